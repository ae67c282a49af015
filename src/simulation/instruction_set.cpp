#include "simulation/instruction_set.hpp"

namespace vesica {

bool instruction_set_runs_here(std::string_view name) {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (name == "avx512") // -march=skylake-avx512
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
               __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
    if (name == "avx2") // -march=x86-64-v3
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi2");
#endif
    return name == "baseline";
}

} // namespace vesica
