#include "simulation/bench.hpp"

#include "core/input_error.hpp"
#include "core/large_memory.hpp"
#include "simulation/bench_kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

namespace vesica {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Seconds of the fastest call so far: what the machine can do, not what else it was doing.
class Fastest {
public:
    template <class Work>
    void time(const Work& work) {
        const auto before = Clock::now();
        work();
        seconds_ = std::min(seconds_, seconds_since(before));
    }
    double seconds() const { return seconds_; }

private:
    double seconds_ = HUGE_VAL;
};

/// The passes that bound every step, over populations of their own.
template <class Real>
class Passes {
public:
    Passes(int edge, int threads)
        : box_(edge),
          kernels_(bench_kernels<Real>()),
          f_(large_array<Real>(box_.numbers())),
          threads_(threads) {
        kernels_.fill(box_, f_.get(), threads);
        read_modify_write();
        stream_twice();
    }

    const char* instruction_set() const { return kernels_.instruction_set; }
    void read_modify_write() { kernels_.read_modify_write(box_, f_.get(), threads_); }
    /// In place, even and odd passes need not cost the same.
    void stream_twice() {
        kernels_.stream_even(box_, f_.get(), threads_);
        kernels_.stream_odd(box_, f_.get(), threads_);
    }
    double bandwidth(double seconds_of_pass) const { // bytes per second
        const double numbers =
            static_cast<double>(direction_count * box_.layer_stride * (box_.cells_per_edge + 2));
        return 2.0 * numbers * sizeof(Real) / seconds_of_pass;
    }
    double bandwidth_mlups(double seconds_of_pass) const {
        return 1e-6 * bandwidth(seconds_of_pass) / (bench_numbers_per_cell * sizeof(Real));
    }
    double streaming_mlups(double seconds_of_two) const {
        return 2e-6 * std::pow(box_.cells_per_edge, 3) / seconds_of_two;
    }

private:
    BenchBox box_;
    BenchKernels<Real> kernels_;
    std::unique_ptr<Real[], FreeLargeMemory> f_;
    int threads_;
};

Parameters fluid(int edge, Precision precision) {
    Parameters parameters;
    parameters.size = {edge, edge, edge};
    parameters.numerics.precision = precision;
    return parameters;
}

/// With a rate for every family of ghost modes: the most general collision there is.
Parameters multiple_rates(int edge, Precision precision) {
    Parameters parameters = fluid(edge, precision);
    parameters.fluid.ghosts = SymmetricGhosts{1.2, 1.1, 1.3, 1.4};
    return parameters;
}

Parameters discocyte(int edge, Precision precision) {
    Parameters parameters = fluid(edge, precision);
    VesicleType type;
    type.name = "rbc";
    type.bending.modulus = 0.1;
    parameters.types = {type};
    VesicleParameters vesicle;
    vesicle.shape = HelfrichShape{HelfrichBranch::discocyte, 0.65};
    vesicle.radius = 20.0 * edge / 128.0;
    vesicle.centre = {0.5 * edge, 0.5 * edge, 0.5 * edge};
    parameters.vesicles = {vesicle};
    return parameters;
}

/// A vesicle in every cube of 64 cells, so close that interface bands fill most of the box: what a cell of
/// the interface costs, whatever the size of the box.
Parameters crowd(int edge, Precision precision) {
    constexpr int spacing = 64;
    Parameters parameters = discocyte(edge, precision);
    parameters.types.front().area.constraint = NoConstraint{};
    const int per_edge = std::max(1, edge / spacing);
    VesicleParameters vesicle = parameters.vesicles.front();
    vesicle.radius = 18.5 / spacing * edge / per_edge;
    parameters.vesicles.clear();
    for (int z = 0; z < per_edge; ++z)
        for (int y = 0; y < per_edge; ++y)
            for (int x = 0; x < per_edge; ++x) {
                const double cell = static_cast<double>(edge) / per_edge;
                vesicle.centre = {(x + 0.5) * cell, (y + 0.5) * cell, (z + 0.5) * cell};
                vesicle.joins_previous = !parameters.vesicles.empty();
                parameters.vesicles.push_back(vesicle);
            }
    return parameters;
}

/// A sphere in every cube of 32 cells, all of them in so many colours.
Parameters spheres(int edge, Precision precision) {
    constexpr int spacing = 32;
    Parameters parameters = discocyte(edge, precision);
    parameters.types.front().area.constraint = NoConstraint{};
    VesicleParameters sphere = parameters.vesicles.front();
    sphere.shape = SphereShape{};
    sphere.radius = 10.0;
    parameters.vesicles.clear();
    for (int z = 0; z + spacing <= edge; z += spacing)
        for (int y = 0; y + spacing <= edge; y += spacing)
            for (int x = 0; x + spacing <= edge; x += spacing) {
                sphere.centre = {x + 0.5 * spacing, y + 0.5 * spacing, z + 0.5 * spacing};
                parameters.vesicles.push_back(sphere);
            }
    return parameters;
}

/// Neighbours in the list share a colour, so that so many are left; 0: one for each.
void share_colours(Parameters& parameters, int colours) {
    const std::size_t count = parameters.vesicles.size();
    const std::size_t left = colours > 0 ? std::min(static_cast<std::size_t>(colours), count) : count;
    for (std::size_t k = 1; k < count; ++k)
        parameters.vesicles[k].joins_previous = k * left / count == (k - 1) * left / count;
}

struct StandardCase {
    const char* name;
    const char* text;
    Parameters (*parameters)(int edge, Precision precision);
    bool by_name_only = false;
};

constexpr StandardCase standard_cases[] = {
    {"fluid", "a fluid at rest", fluid},
    {"mrt", "the same with multiple relaxation times", multiple_rates},
    {"discocyte", "a discocyte", discocyte},
    {"crowd", "a crowd of discocytes", crowd},
    {"spheres", "spheres of several colours", spheres, true},
};

template <class Real>
BenchCase measure_case(const StandardCase& standard, int edge, Precision precision, Passes<Real>& passes,
                       BenchLimit& limit, int threads, const BenchOptions& options) {
    Parameters parameters = standard.parameters(edge, precision);
    if (standard.by_name_only)
        share_colours(parameters, options.colours);
    const auto engine =
        options.factory ? options.factory(parameters, threads) : make_engine(parameters, threads);
    const auto step_twice = [&] {
        engine->step();
        engine->step();
    };
    step_twice(); // whatever is done once
    Fastest pass;
    Fastest streaming;
    Fastest stepping;
    constexpr int fewest_turns = 5;
    const auto begin = Clock::now();
    for (int turn = 0; turn < fewest_turns || seconds_since(begin) < options.seconds; ++turn) {
        pass.time([&] { passes.read_modify_write(); });
        streaming.time([&] { passes.stream_twice(); });
        stepping.time(step_twice);
    }

    const double cells = std::pow(edge, 3);
    BenchCase measured;
    measured.name = standard.name;
    measured.edge = edge;
    measured.precision = precision;
    measured.mlups = 2e-6 * cells / stepping.seconds();
    measured.bandwidth_mlups = passes.bandwidth_mlups(pass.seconds());
    measured.streaming_mlups = passes.streaming_mlups(streaming.seconds());
    measured.interface_fraction = engine->interface_fraction();
    measured.bytes_per_cell = static_cast<double>(engine->bytes_allocated()) / cells;
    measured.instruction_set = std::string(engine->instruction_set());
    limit.bandwidth = std::max(limit.bandwidth, passes.bandwidth(pass.seconds()));
    limit.bandwidth_mlups = std::max(limit.bandwidth_mlups, measured.bandwidth_mlups);
    limit.streaming_mlups = std::max(limit.streaming_mlups, measured.streaming_mlups);
    return measured;
}

bool chosen(const StandardCase& standard, const BenchOptions& options) {
    return (options.cases.empty() && !standard.by_name_only) ||
           std::find(options.cases.begin(), options.cases.end(), standard.name) != options.cases.end();
}

template <class Real>
void measure_cases(int edge, Precision precision, const BenchOptions& options, BenchReport& report) {
    Passes<Real> passes(edge, report.threads);
    report.instruction_set = passes.instruction_set();
    BenchLimit limit;
    limit.edge = edge;
    limit.precision = precision;
    for (const StandardCase& standard : standard_cases) {
        if (!chosen(standard, options))
            continue;
        if (options.progress != nullptr)
            *options.progress << fmt::format("measuring {}, {}, {}^3\n", standard.text, name_of(precision),
                                             edge)
                              << std::flush;
        report.cases.push_back(
            measure_case(standard, edge, precision, passes, limit, report.threads, options));
    }
    report.limits.push_back(limit);
}

void check(const BenchOptions& options, const std::vector<int>& edges) {
    for (const int edge : edges)
        if (edge < 32)
            throw InputError(
                fmt::format("--size is {}; expected at least 32 cells, below which nothing but caches is "
                            "measured; try 128",
                            edge));
    const std::vector<std::string>& names = bench_case_names();
    for (const std::string& name : options.cases)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError(
                fmt::format("--case is \"{}\"; expected one of {}", name, fmt::join(names, ", ")));
}

} // namespace

const std::vector<std::string>& bench_case_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const StandardCase& standard : standard_cases)
            all.emplace_back(standard.name);
        return all;
    }();
    return names;
}

BenchReport run_bench(const BenchOptions& options) {
    BenchReport report;
    report.threads = options.threads > 0 ? options.threads : default_threads();
    const std::vector<int> edges = options.edges.empty() ? std::vector<int>{128} : options.edges;
    check(options, edges);
    for (const int edge : edges) {
        measure_cases<double>(edge, Precision::double_precision, options, report);
        measure_cases<float>(edge, Precision::single_precision, options, report);
    }
    return report;
}

} // namespace vesica
