#define CATCH_CONFIG_RUNNER
#include "parallel/ranks.hpp"

#include <catch2/catch.hpp>

/// Runs under mpirun: every rank goes through the same cases.
int main(int argument_count, char** arguments) {
    const vesica::MpiSession session;
    const int failed = Catch::Session().run(argument_count, arguments);
    return vesica::Ranks::all().any(failed != 0) ? 1 : 0;
}
