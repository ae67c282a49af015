#include "choose.hpp"

#define DECLARE(isa)                                                                                         \
    double first_isa_entry_##isa(const std::vector<double>&);                                                \
    double second_isa_entry_##isa(const std::vector<double>&, void (*)(double));

DECLARE(baseline)
#ifdef VESICA_HAS_ISA_AVX2
DECLARE(avx2)
#endif
#ifdef VESICA_HAS_ISA_AVX512
DECLARE(avx512)
#endif

std::vector<Kernels> available_kernels() {
    std::vector<Kernels> kernels{{"baseline", first_isa_entry_baseline, second_isa_entry_baseline}};
#ifdef VESICA_HAS_ISA_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        kernels.push_back({"avx2", first_isa_entry_avx2, second_isa_entry_avx2});
    }
#endif
#ifdef VESICA_HAS_ISA_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) {
        kernels.push_back({"avx512", first_isa_entry_avx512, second_isa_entry_avx512});
    }
#endif
    return kernels;
}
