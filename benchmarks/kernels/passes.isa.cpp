// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "collision/regularised.hpp"
#include "kernels/entries.hpp"
#include "kernels/per_cell.hpp"
#include "kernels/sphere.hpp"
#include "simulation/fluid_step.hpp"

#include <ctime>

namespace vesica {

namespace {

enum class Pass { fluid, locate, normals, curvatures, slopes, forces };

constexpr const char* pass_names[] = {"fluid_and_transport", "locate", "normals",
                                      "curvatures",          "slopes", "forces"};

/// How far out the pass goes, and so which cells its time is shared by; -1: all of the box.
constexpr int level_of(Pass pass) {
    constexpr int levels[] = {-1,           Band::outermost, reach::colour, reach::raw_curvature,
                              reach::slope, reach::force};
    return levels[static_cast<int>(pass)];
}

/// Seconds this thread has worked: what else the machine does is left out, as in Google Benchmark's own
/// rates.
double seconds_of_work() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Real steps of a sphere, of which one pass is timed: what a kernel costs with everything around it, its
/// band, masks, sums and ghosts.
template <class Real>
void time_pass(benchmark::State& state, int edge, Pass timed) {
    constexpr int threads = 1;
    Sphere<Real> sphere(edge, 0.3 * edge);
    Layer<Real>& layer = sphere.layer;
    const PopulationView<Real> f(sphere.populations.view(), sphere.grid);
    const FluidStep<Real, RegularisedCollision> fluid(sphere.grid, f, {}, 1.0, 1.0);
    const Membrane membrane{HelfrichLaw{0.1, 0.0}, 0.0, FreeArea{}, {}, 0.0};
    Streaming streaming = Streaming::arrived;
    layer.weigh(f, streaming, threads);
    for (auto _ : state) {
        double seconds = 0.0;
        const auto run = [&](Pass pass, const auto& work) {
            const double begin = seconds_of_work();
            work();
            if (pass == timed)
                seconds = seconds_of_work() - begin;
        };
        run(Pass::locate, [&] { layer.locate(threads); });
        run(Pass::normals, [&] { layer.normals(threads); });
        run(Pass::curvatures, [&] { layer.curvatures(threads); });
        run(Pass::slopes, [&] { layer.slopes(threads); });
        run(Pass::forces, [&] { layer.forces(std::span(&membrane, 1), threads); });
        run(Pass::fluid, [&] {
            const Streaming streamed = after_step(streaming);
            layer.begin_transport(threads);
            fluid(streaming, sphere.influence(), FlowInfluence<Real>{}, nullptr, threads,
                  [&](int thread, std::int64_t first_row, std::int64_t last_row) {
                      layer.transport_rows(f, streamed, thread, first_row, last_row);
                  });
            layer.end_transport();
            streaming = streamed;
        });
        state.SetIterationTime(seconds);
    }
    const int level = level_of(timed);
    report_cells(state, level < 0 ? sphere.grid.volume() : sphere.cells_of_level(level));
}

template <class Real>
void add_all(const char* isa_name) {
    // Populations and layer of 16^3 cells (one and a half megabytes each, in double) lie in the caches, of
    // 128^3 in memory.
    for (const int edge : {16, 128})
        for (const Pass pass :
             {Pass::fluid, Pass::locate, Pass::normals, Pass::curvatures, Pass::slopes, Pass::forces}) {
            const std::string name = std::string("pass/") + pass_names[static_cast<int>(pass)];
            const std::int64_t box = std::int64_t{edge} * edge * edge;
            benchmark::RegisterBenchmark(benchmark_name<Real>(name, isa_name, box).c_str(),
                                         [=](benchmark::State& state) { time_pass<Real>(state, edge, pass); })
                ->UseManualTime();
        }
}

} // namespace

void VESICA_BENCHMARK_ENTRY(passes, VESICA_ISA)(const char* isa_name) {
    add_all<double>(isa_name);
    add_all<float>(isa_name);
}

} // namespace vesica
