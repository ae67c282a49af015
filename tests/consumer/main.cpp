#include "core/version.hpp"
#include "io/case_file.hpp"
#include "simulation/engine.hpp"

#include <iostream>

int main(int, char** argv) {
    const vesica::Case read = vesica::read_case(argv[1]);
    const auto engine = vesica::make_engine(read.parameters, 1);
    std::cout << "vesica " << vesica::version << " with " << engine->instruction_set() << '\n';
}
