#include "simulation/bench_kernels.hpp"

#include "core/input_error.hpp"

namespace vesica {

BenchKernels<double> bench_double_isa_entry_baseline();
BenchKernels<float> bench_single_isa_entry_baseline();
#ifdef VESICA_HAS_ISA_AVX2
BenchKernels<double> bench_double_isa_entry_avx2();
BenchKernels<float> bench_single_isa_entry_avx2();
#endif
#ifdef VESICA_HAS_ISA_AVX512
BenchKernels<double> bench_double_isa_entry_avx512();
BenchKernels<float> bench_single_isa_entry_avx512();
#endif

namespace {

template <class Real>
BenchKernels<Real> choose(BenchKernels<double> (*in_double)(), BenchKernels<float> (*in_single)()) {
    if constexpr (sizeof(Real) == sizeof(double))
        return in_double();
    else
        return in_single();
}

std::ptrdiff_t round_up(std::ptrdiff_t value, std::ptrdiff_t multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

} // namespace

BenchBox::BenchBox(int edge) : cells_per_edge(static_cast<int>(round_up(edge, 8))) {
    row_stride = cells_per_edge + 16;
    layer_stride = row_stride * (cells_per_edge + 2);
    // An odd number of cache lines: consecutive directions start in different sets.
    const std::ptrdiff_t line = 16;
    direction_stride = round_up(layer_stride * (cells_per_edge + 2), line);
    if (direction_stride / line % 2 == 0)
        direction_stride += line;
}

std::size_t BenchBox::numbers() const {
    return static_cast<std::size_t>(direction_stride * bench_directions);
}

template <class Real>
BenchKernels<Real> bench_kernels(const std::string& instruction_set) {
    [[maybe_unused]] const auto wanted = [&](const char* name) {
        return instruction_set.empty() || instruction_set == name;
    };
#if defined(__x86_64__)
    __builtin_cpu_init();
#ifdef VESICA_HAS_ISA_AVX512
    // The set of -march=skylake-avx512.
    if (wanted("avx512") && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return choose<Real>(bench_double_isa_entry_avx512, bench_single_isa_entry_avx512);
#endif
#ifdef VESICA_HAS_ISA_AVX2
    if (wanted("avx2") && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
        __builtin_cpu_supports("bmi2"))
        return choose<Real>(bench_double_isa_entry_avx2, bench_single_isa_entry_avx2);
#endif
#endif
    if (wanted("baseline"))
        return choose<Real>(bench_double_isa_entry_baseline, bench_single_isa_entry_baseline);
    throw InputError("the instruction set \"" + instruction_set +
                     "\" is not one of this machine and build; expected baseline, avx2 or avx512");
}

template BenchKernels<double> bench_kernels<double>(const std::string&);
template BenchKernels<float> bench_kernels<float>(const std::string&);

} // namespace vesica
