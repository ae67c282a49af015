#include "core/version.hpp"
#include "kernels/entries.hpp"
#include "simulation/instruction_set.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <string_view>

namespace vesica {

namespace {

struct InstructionSet {
    const char* name;
    void (*entries[5])(const char* isa_name);
};

#define VESICA_INSTRUCTION_SET(isa)                                                                          \
    InstructionSet {                                                                                         \
#isa, {                                                                                              \
            VESICA_BENCHMARK_ENTRY(collision, isa), VESICA_BENCHMARK_ENTRY(colour, isa),                     \
                VESICA_BENCHMARK_ENTRY(geometry, isa), VESICA_BENCHMARK_ENTRY(membrane, isa),                \
                VESICA_BENCHMARK_ENTRY(passes, isa)                                                          \
        }                                                                                                    \
    }

/// Those the program was built for, the best first.
const InstructionSet instruction_sets[] = {
#ifdef VESICA_HAS_ISA_AVX512
    VESICA_INSTRUCTION_SET(avx512),
#endif
#ifdef VESICA_HAS_ISA_AVX2
    VESICA_INSTRUCTION_SET(avx2),
#endif
    VESICA_INSTRUCTION_SET(baseline),
};

/// Registers the benchmarks of `wanted`, of all sets for "all", of the best for "". False if there are none.
bool register_benchmarks(std::string_view wanted) {
    bool any = false;
    for (const InstructionSet& set : instruction_sets) {
        if (!instruction_set_runs_here(set.name) ||
            !(wanted.empty() || wanted == "all" || wanted == set.name))
            continue;
        for (const auto& entry : set.entries)
            entry(set.name);
        any = true;
        if (wanted.empty())
            break;
    }
    return any;
}

} // namespace

} // namespace vesica

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::string_view wanted;
    for (int k = 1; k < argc; ++k) {
        constexpr std::string_view option = "--instruction_set=";
        const std::string_view argument = argv[k];
        if (!argument.starts_with(option)) {
            std::fprintf(stderr,
                         "%s: unknown option; expected those of Google Benchmark (--help) or "
                         "--instruction_set=baseline|avx2|avx512|all\n",
                         argv[k]);
            return 2;
        }
        wanted = argument.substr(option.size());
    }
    if (!vesica::register_benchmarks(wanted)) {
        std::fprintf(
            stderr,
            "the instruction set \"%s\" is not one of this machine and build; expected baseline, avx2, "
            "avx512 or all\n",
            std::string(wanted).c_str());
        return 2;
    }
    benchmark::AddCustomContext("vesica", std::string(vesica::version));
    benchmark::AddCustomContext("commit", std::string(vesica::commit));
    benchmark::AddCustomContext("compiler", std::string(vesica::compiler));
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
