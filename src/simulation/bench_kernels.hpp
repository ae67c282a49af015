#pragma once

#include "lattice/velocity_set.hpp"

#include <cstddef>
#include <string>

namespace vesica {

/// Numbers a cell moves per step when the populations are streamed in place: each is read once and written
/// once.
inline constexpr int bench_numbers_per_cell = 2 * direction_count;

/// A box of populations as a structure of arrays, one cell of margin on every side and one vector at the ends
/// of the rows, so that the kernels need no special case at the edge. Directions lie `direction_stride`
/// numbers apart, which is kept off the powers of two: with one, all nineteen streams fall into the same sets
/// of the cache.
struct BenchBox {
    int cells_per_edge = 0; ///< a multiple of 8
    std::ptrdiff_t row_stride = 0;
    std::ptrdiff_t layer_stride = 0;
    std::ptrdiff_t direction_stride = 0;

    explicit BenchBox(int edge);
    std::size_t numbers() const; ///< to allocate
    std::ptrdiff_t first_cell() const { return layer_stride + row_stride + 8; }
};

/// The two memory passes that bound any lattice Boltzmann step, for one instruction set.
template <class Real>
struct BenchKernels {
    /// Sets everything to 1 with the threads that will work on it, so that each finds its part near itself.
    void (*fill)(const BenchBox& box, Real* f, int threads);
    /// f <- (f + 1)/2 over all numbers of all rows: as much memory traffic as a step can have at least.
    void (*read_modify_write)(const BenchBox& box, Real* f, int threads);
    /// The AA pattern (Bailey et al. 2009) without collision. Even steps turn the populations round in their
    /// cell, odd ones fetch them from the neighbours and push them on: one array, no second copy.
    void (*stream_even)(const BenchBox& box, Real* f, int threads);
    void (*stream_odd)(const BenchBox& box, Real* f, int threads);
    const char* instruction_set;
};

/// The kernels for `instruction_set` (empty: the best this machine has). Throws InputError for an unknown
/// one.
template <class Real>
BenchKernels<Real> bench_kernels(const std::string& instruction_set = {});

} // namespace vesica
