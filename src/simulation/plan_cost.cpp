#include "simulation/plan_cost.hpp"

#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace vesica {

namespace {

/// Above this a case takes more than a second or two to build, and more memory than a plan should.
constexpr double quick_cells = 1.2e6;

double cells_of(const Vec3<int>& size) {
    return 1.0 * size.x * size.y * size.z;
}

double seconds_per_step(Engine& engine) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point begin) {
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    engine.step(); // touches memory for the first time
    const auto begin = Clock::now();
    double best = HUGE_VAL;
    // The fastest of a few: a plan should not depend on what else the machine did just now.
    for (int step = 0; step < 20 && (step < 3 || seconds_since(begin) < 0.3); ++step) {
        const auto before = Clock::now();
        engine.step();
        best = std::min(best, seconds_since(before));
    }
    return best;
}

struct SmallBox {
    double cells = 0.0;
    double layer = 0.0;
    double seconds = 0.0;
    double bytes = 0.0;
};

constexpr double small_radius = 10.0;

SmallBox measure_small(Parameters parameters, int edge, int threads, const EngineFactory& factory) {
    parameters.size = {edge, edge, edge};
    if (parameters.sliding() != nullptr)
        parameters.flow.shear.reset(); // images near the layer would make the small box's larger
    VesicleParameters sphere = parameters.vesicles.front();
    sphere.shape = SphereShape{};
    sphere.perturbations.clear();
    sphere.radius = small_radius;
    sphere.centre = {0.5 * edge, 0.5 * edge, 0.5 * edge};
    parameters.vesicles = {sphere};
    const auto engine = factory(parameters, threads);
    SmallBox box;
    box.cells = cells_of(parameters.lattice());
    box.seconds = seconds_per_step(*engine);
    box.layer = box.cells * engine->interface_fraction();
    box.bytes = static_cast<double>(engine->bytes_allocated());
    return box;
}

RunCost cost_from_small_boxes(const Parameters& parameters, int threads, const EngineFactory& factory) {
    const SmallBox small = measure_small(parameters, 36, threads, factory);
    const SmallBox large = measure_small(parameters, 72, threads, factory);
    const double cells = cells_of(parameters.lattice());
    const double small_area = 4.0 * std::numbers::pi * small_radius * small_radius;
    const double layers = membrane_area(parameters) / small_area; // in layers of the small sphere
    // Both boxes hold the same layer, so that their difference is the cost of plain cells.
    const auto scaled = [&](double in_small, double in_large) {
        const double per_cell = std::max(0.0, (in_large - in_small) / (large.cells - small.cells));
        const double per_layer = std::max(0.0, in_small - per_cell * small.cells);
        return per_cell * cells + per_layer * layers;
    };
    RunCost cost;
    cost.seconds_per_step = scaled(small.seconds, large.seconds);
    cost.bytes = scaled(small.bytes, large.bytes);
    return cost;
}

/// The number that follows a word in a file of the kernel's; 0 if there is none.
double number_after(const char* path, const std::string& name) {
    std::ifstream file(path);
    double value = 0.0;
    for (std::string word; file >> word;)
        if (word == name && file >> value)
            return value;
    return 0.0;
}

/// The number a file of the kernel's consists of; 0 if it says "max" or is not there.
double number_in(const char* path) {
    std::ifstream file(path);
    double value = 0.0;
    return file >> value ? value : 0.0;
}

} // namespace

RunCost measure_cost(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                     int threads, const EngineFactory& factory) {
    RunCost cost;
    if (cells_of(parameters.size) <= quick_cells || parameters.vesicles.empty()) {
        const auto engine = factory(parameters, threads);
        cost.seconds_per_step = seconds_per_step(*engine);
        cost.bytes = static_cast<double>(engine->bytes_allocated());
        cost.of_this_case = true;
    } else {
        cost = cost_from_small_boxes(parameters, threads, factory);
    }
    cost.output = output_cost(parameters, run, output, threads);
    return cost;
}

double available_memory() {
    const double machine = 1024.0 * number_after("/proc/meminfo", "MemAvailable:");
    const double limit = number_in("/sys/fs/cgroup/memory.max");
    const double used = number_in("/sys/fs/cgroup/memory.current");
    if (limit > 0.0 && limit > used)
        return machine > 0.0 ? std::min(machine, limit - used) : limit - used;
    return machine;
}

int default_threads() {
    return std::max(1, omp_get_max_threads());
}

int default_threads(const Ranks& ranks) {
    std::vector<std::uint64_t> mask(sizeof(cpu_set_t) / sizeof(std::uint64_t), 0);
    if (sched_getaffinity(0, sizeof(cpu_set_t), reinterpret_cast<cpu_set_t*>(mask.data())) != 0)
        for (int processor = 0; processor < omp_get_num_procs();
             ++processor) // a machine with more than it can name
            mask[static_cast<std::size_t>(processor) / 64 % mask.size()] |= std::uint64_t{1}
                                                                            << processor % 64;
    const int share = ranks.share_of_processors(mask); // by all, though some may have been told otherwise
    const bool told = std::getenv("OMP_NUM_THREADS") != nullptr;
    return told || ranks.count() == 1 ? default_threads() : share;
}

} // namespace vesica
