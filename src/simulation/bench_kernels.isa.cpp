// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "simulation/bench_kernels.hpp"

#include "lattice/velocity_set.hpp"
#include "parallel/for_each.hpp"
#include "parallel/pack.hpp"

#ifndef VESICA_ISA
#define VESICA_ISA baseline
#endif
#define VESICA_PASTE_TWO(a, b) a##b
#define VESICA_PASTE(a, b) VESICA_PASTE_TWO(a, b)
#define VESICA_TEXT_OF(a) #a
#define VESICA_TEXT(a) VESICA_TEXT_OF(a)

namespace vesica {

namespace {

/// Runs `row(pointer to its first cell)` over the rows of the box, the same rows in the same thread every
/// time.
template <class Real, class Row>
inline void for_each_row(const BenchBox& box, Real* f, int threads, const Row& row) {
    const int edge = box.cells_per_edge;
    for_each_index(std::int64_t{edge} * edge, threads, [&](std::int64_t k) {
        row(f + box.first_cell() + k / edge * box.layer_stride + k % edge * box.row_stride);
    });
}

/// Runs `part(pointer, numbers)` over layer after layer of every direction: long runs, margins included.
template <class Real, class Part>
inline void for_each_layer(const BenchBox& box, Real* f, int threads, const Part& part) {
    for_each_index(box.cells_per_edge + 2, threads, [&](std::int64_t z) {
        for (int i = 0; i < direction_count; ++i)
            part(f + i * box.direction_stride + z * box.layer_stride, box.layer_stride);
    });
}

/// Little enough arithmetic to leave the memory the bottleneck, and enough to leave nothing out.
template <class Real>
VESICA_INLINE Pack<Real> halved_towards_one(const Pack<Real>& a) {
    return (a + Pack<Real>(1)) * Pack<Real>(0.5);
}

template <class Real>
void fill(const BenchBox& box, Real* f, int threads) {
    for_each_layer(box, f, threads, [](Real* numbers, std::ptrdiff_t count) {
        for (std::ptrdiff_t k = 0; k < count; ++k)
            numbers[k] = Real(1);
    });
}

template <class Real>
void read_modify_write(const BenchBox& box, Real* f, int threads) {
    for_each_layer(box, f, threads, [](Real* numbers, std::ptrdiff_t count) {
        for (std::ptrdiff_t k = 0; k < count; k += tile_width)
            halved_towards_one(Pack<Real>::load(numbers + k)).store(numbers + k);
    });
}

template <class Real>
void stream_even(const BenchBox& box, Real* f, int threads) {
    for_each_row(box, f, threads, [&](Real* row) {
        for (int x = 0; x < box.cells_per_edge; x += tile_width) {
            Pack<Real> g[direction_count];
            for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
                g[i] = Pack<Real>::load(row + x + i * box.direction_stride);
            });
            for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
                halved_towards_one(g[i]).store(row + x + opposite(i) * box.direction_stride);
            });
        }
    });
}

template <class Real>
void stream_odd(const BenchBox& box, Real* f, int threads) {
    std::ptrdiff_t neighbour[direction_count];
    for (int i = 0; i < direction_count; ++i)
        neighbour[i] = velocity(i, 0) + velocity(i, 1) * box.row_stride + velocity(i, 2) * box.layer_stride;
    for_each_row(box, f, threads, [&](Real* row) {
        for (int x = 0; x < box.cells_per_edge; x += tile_width) {
            Pack<Real> g[direction_count];
            for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
                g[i] = Pack<Real>::load(row + x - neighbour[i] + opposite(i) * box.direction_stride);
            });
            for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
                halved_towards_one(g[i]).store(row + x + neighbour[i] + i * box.direction_stride);
            });
        }
    });
}

} // namespace

BenchKernels<double> VESICA_PASTE(bench_double_isa_entry_, VESICA_ISA)();
BenchKernels<float> VESICA_PASTE(bench_single_isa_entry_, VESICA_ISA)();

BenchKernels<double> VESICA_PASTE(bench_double_isa_entry_, VESICA_ISA)() {
    return {fill<double>, read_modify_write<double>, stream_even<double>, stream_odd<double>,
            VESICA_TEXT(VESICA_ISA)};
}

BenchKernels<float> VESICA_PASTE(bench_single_isa_entry_, VESICA_ISA)() {
    return {fill<float>, read_modify_write<float>, stream_even<float>, stream_odd<float>,
            VESICA_TEXT(VESICA_ISA)};
}

} // namespace vesica
