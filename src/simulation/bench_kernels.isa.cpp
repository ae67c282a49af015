// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "simulation/bench_kernels.hpp"

#include <cstring>

#ifndef VESICA_ISA
#define VESICA_ISA baseline
#endif
#define VESICA_PASTE_TWO(a, b) a##b
#define VESICA_PASTE(a, b) VESICA_PASTE_TWO(a, b)
#define VESICA_TEXT_OF(a) #a
#define VESICA_TEXT(a) VESICA_TEXT_OF(a)

namespace vesica {

namespace {

constexpr int width = 8;

template <class Real>
struct Pack;
template <>
struct Pack<double> {
    typedef double type __attribute__((vector_size(width * sizeof(double))));
};
template <>
struct Pack<float> {
    typedef float type __attribute__((vector_size(width * sizeof(float))));
};

template <class Real>
inline typename Pack<Real>::type load(const Real* from) {
    typename Pack<Real>::type pack;
    std::memcpy(&pack, from, sizeof pack);
    return pack;
}

template <class Real>
inline void store(Real* to, const typename Pack<Real>::type& pack) {
    std::memcpy(to, &pack, sizeof pack);
}

struct Direction {
    int x;
    int y;
    int z;
};

// Rest first, then opposites side by side: the opposite of an odd direction is the next one, of an even one
// the last.
constexpr Direction directions[bench_directions] = {
    {0, 0, 0},  {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},  {0, -1, 0}, {0, 0, 1},   {0, 0, -1},
    {1, 1, 0},  {-1, -1, 0}, {1, -1, 0},  {-1, 1, 0}, {1, 0, 1},  {-1, 0, -1}, {1, 0, -1},
    {-1, 0, 1}, {0, 1, 1},   {0, -1, -1}, {0, 1, -1}, {0, -1, 1},
};

constexpr int opposite(int i) {
    return i == 0 ? 0 : i % 2 == 1 ? i + 1 : i - 1;
}

/// Runs `row(pointer to its first cell)` over the rows of the box, the same rows in the same thread every
/// time.
template <class Real, class Row>
inline void for_each_row(const BenchBox& box, Real* f, int threads, const Row& row) {
    const int edge = box.cells_per_edge;
#pragma omp parallel for collapse(2) schedule(static) num_threads(threads)
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            row(f + box.first_cell() + z * box.layer_stride + y * box.row_stride);
}

/// Runs `part(pointer, numbers)` over layer after layer of every direction: long runs, margins included.
template <class Real, class Part>
inline void for_each_layer(const BenchBox& box, Real* f, int threads, const Part& part) {
    const int layers = box.cells_per_edge + 2;
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int z = 0; z < layers; ++z)
        for (int i = 0; i < bench_directions; ++i)
            part(f + i * box.direction_stride + z * box.layer_stride, box.layer_stride);
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
        for (std::ptrdiff_t k = 0; k < count; k += width)
            store(numbers + k, (load(numbers + k) + Real(1)) * Real(0.5));
    });
}

template <class Real>
void stream_even(const BenchBox& box, Real* f, int threads) {
    const int edge = box.cells_per_edge;
    for_each_row(box, f, threads, [&](Real* row) {
        for (int x = 0; x < edge; x += width) {
            typename Pack<Real>::type pack[bench_directions];
#pragma GCC unroll 19
            for (int i = 0; i < bench_directions; ++i)
                pack[i] = load(row + x + i * box.direction_stride);
#pragma GCC unroll 19
            for (int i = 0; i < bench_directions; ++i)
                store(row + x + opposite(i) * box.direction_stride, (pack[i] + Real(1)) * Real(0.5));
        }
    });
}

template <class Real>
void stream_odd(const BenchBox& box, Real* f, int threads) {
    const int edge = box.cells_per_edge;
    std::ptrdiff_t neighbour[bench_directions];
    for (int i = 0; i < bench_directions; ++i)
        neighbour[i] =
            directions[i].x + directions[i].y * box.row_stride + directions[i].z * box.layer_stride;
    for_each_row(box, f, threads, [&](Real* row) {
        for (int x = 0; x < edge; x += width) {
            typename Pack<Real>::type pack[bench_directions];
#pragma GCC unroll 19
            for (int i = 0; i < bench_directions; ++i)
                pack[i] = load(row + x - neighbour[i] + opposite(i) * box.direction_stride);
#pragma GCC unroll 19
            for (int i = 0; i < bench_directions; ++i)
                store(row + x + neighbour[i] + i * box.direction_stride, (pack[i] + Real(1)) * Real(0.5));
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
