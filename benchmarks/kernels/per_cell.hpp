#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace vesica {

/// A benchmark's place and name: `collision/regularised/double/avx512/cells:128`.
template <class Real>
std::string benchmark_name(const std::string& kernel, const std::string& instruction_set,
                           std::int64_t cells) {
    const char* const precision = sizeof(Real) == sizeof(double) ? "double" : "single";
    return kernel + "/" + precision + "/" + instruction_set + "/cells:" + std::to_string(cells);
}

/// What every benchmark reports: cells per second as items_per_second, and the time one cell takes.
inline void report_cells(benchmark::State& state, std::int64_t cells) {
    state.SetItemsProcessed(state.iterations() * cells);
    state.counters["per_cell"] =
        benchmark::Counter(static_cast<double>(cells),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

} // namespace vesica
