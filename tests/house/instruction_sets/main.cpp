#include "choose.hpp"
#include "shared.hpp"

#include <cstdio>
#include <numeric>

namespace {

bool fails = false;

void expect(bool holds, const char* set, const char* what) {
    if (!holds) {
        std::printf("%s: %s\n", set, what);
        fails = true;
    }
}

void refuse(double) {
    throw Refusal("the caller refuses");
}

void accept(double) {}

} // namespace

int main() {
    std::vector<double> values(1000);
    std::iota(values.begin(), values.end(), 0.0);
    const double sum = sum_of_squares(values);
    const int calls = count_calls();
    for (const Kernels& kernels : available_kernels()) {
        expect(kernels.first(values) == sum, kernels.name, "the sum differs");
        expect(kernels.second(values, accept) == sum, kernels.name, "the second sum differs");
        expect(kernels.second(values, refuse) == -1, kernels.name,
               "an exception of the caller did not come through");
        expect(kernels.second({}, accept) == -1, kernels.name,
               "an exception inside the set was not caught there");
        try {
            kernels.first({});
            expect(false, kernels.name, "no exception");
        } catch (const Refusal& refusal) {
            expect(std::string("nothing to sum") == refusal.what(), kernels.name, "another exception");
        }
        std::printf("%s works\n", kernels.name);
    }
    expect(count_calls() == calls + 1, "all", "a set shares the generic program's inline function");
    return fails ? 1 : 0;
}
