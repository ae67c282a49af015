// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "collision/paper_mrt.hpp"
#include "collision/regularised.hpp"
#include "collision/symmetric_mrt.hpp"
#include "kernels/entries.hpp"
#include "kernels/per_cell.hpp"
#include "lattice/field.hpp"
#include "parallel/pack.hpp"

namespace vesica {

namespace {

/// Without neighbours: every cell is read, collided and written where it lies, turned round as an even step
/// of in-place streaming does.
template <class Real, bool forced, class Collision>
void collide(benchmark::State& state, std::int64_t cells, const Collision& collision) {
    using V = Pack<Real, tile_width * tiles_per_register<Real>>;
    Field<Real> populations(direction_count, cells);
    const FieldView<Real> f = populations.view();
    for (int i = 0; i < direction_count; ++i)
        for (std::int64_t k = 0; k < cells; ++k) // any deviations that differ from each other
            f.component(i)[k] =
                static_cast<Real>(1e-3 * weight(i) * static_cast<double>((k + 7 * i) % 11 - 5));
    Vec3<V> F{V(0), V(0), V(0)};
    V rate(0.9);
    benchmark::DoNotOptimize(rate);
    if constexpr (forced) {
        F = {V(1e-6), V(-2e-6), V(3e-6)};
        benchmark::DoNotOptimize(F);
    }
    for (auto _ : state) {
        for (std::int64_t cell = 0; cell < cells; cell += V::width) {
            V g[direction_count];
            for_each_direction([&](auto i) VESICA_INLINE_LAMBDA { g[i] = V::load(f.component(i) + cell); });
            collision(g, F, rate, V(1));
            for_each_direction([&](auto i)
                                   VESICA_INLINE_LAMBDA { g[i].store(f.component(opposite(i)) + cell); });
        }
        benchmark::ClobberMemory();
    }
    report_cells(state, cells);
    state.SetBytesProcessed(state.iterations() * cells * 2 * direction_count *
                            static_cast<std::int64_t>(sizeof(Real)));
}

template <class Real, bool forced, class Collision>
void add(const char* name, const char* isa_name, std::int64_t cells, const Collision& collision) {
    benchmark::RegisterBenchmark(
        benchmark_name<Real>(std::string("collision/") + name, isa_name, cells).c_str(),
        [=](benchmark::State& state) { collide<Real, forced>(state, cells, collision); });
}

template <class Real>
void add_all(const char* isa_name) {
    // 19 populations of 128 cells lie in a first-level cache, of 4096 in a second-level one, of a million in
    // memory.
    for (const std::int64_t cells : {128, 4096, 1 << 20}) {
        add<Real, false>("regularised", isa_name, cells, RegularisedCollision{});
        add<Real, true>("regularised_forced", isa_name, cells, RegularisedCollision{});
        add<Real, true>("bgk", isa_name, cells, SymmetricMrt<SingleRelaxationTime>{});
        add<Real, true>("trt", isa_name, cells, SymmetricMrt<TwoRelaxationTimes>{});
        add<Real, true>("symmetric_mrt", isa_name, cells, SymmetricMrt<FreeGhostRates>{{1.1, 1.2, 1.3, 1.4}});
        add<Real, true>("paper_mrt", isa_name, cells, PaperMrt{1.1, 1.2, 1.3, 1.4});
    }
}

} // namespace

void VESICA_BENCHMARK_ENTRY(collision, VESICA_ISA)(const char* isa_name) {
    add_all<double>(isa_name);
    add_all<float>(isa_name);
}

} // namespace vesica
