#include "simulation/bench_kernels.hpp"

#include "core/input_error.hpp"
#include "simulation/instruction_set.hpp"

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
    return static_cast<std::size_t>(direction_stride * direction_count);
}

template <class Real>
BenchKernels<Real> bench_kernels(const std::string& instruction_set) {
    const auto chosen = [&](const char* name) {
        return (instruction_set.empty() || instruction_set == name) && instruction_set_runs_here(name);
    };
#ifdef VESICA_HAS_ISA_AVX512
    if (chosen("avx512"))
        return choose<Real>(bench_double_isa_entry_avx512, bench_single_isa_entry_avx512);
#endif
#ifdef VESICA_HAS_ISA_AVX2
    if (chosen("avx2"))
        return choose<Real>(bench_double_isa_entry_avx2, bench_single_isa_entry_avx2);
#endif
    if (chosen("baseline"))
        return choose<Real>(bench_double_isa_entry_baseline, bench_single_isa_entry_baseline);
    throw InputError("the instruction set \"" + instruction_set +
                     "\" is not one of this machine and build; expected baseline, avx2 or avx512");
}

template BenchKernels<double> bench_kernels<double>(const std::string&);
template BenchKernels<float> bench_kernels<float>(const std::string&);

} // namespace vesica
