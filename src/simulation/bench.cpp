#include "simulation/bench.hpp"

#include "core/input_error.hpp"
#include "core/large_memory.hpp"
#include "simulation/bench_kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <memory>

namespace vesica {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Seconds of the fastest of many calls: what the machine can do, not what else it was doing.
template <class Work>
double fastest(double budget, const Work& work) {
    work(); // first touch
    double best = HUGE_VAL;
    const auto begin = Clock::now();
    for (int round = 0; round < 3 || seconds_since(begin) < budget; ++round) {
        const auto before = Clock::now();
        work();
        best = std::min(best, seconds_since(before));
    }
    return best;
}

template <class Real>
BenchLimit measure_limit(int edge, Precision precision, int threads, double budget,
                         std::string& instruction_set) {
    const BenchBox box(edge);
    const BenchKernels<Real> kernels = bench_kernels<Real>();
    instruction_set = kernels.instruction_set;
    const auto f = large_array<Real>(box.numbers());
    kernels.fill(box, f.get(), threads);

    BenchLimit limit;
    limit.edge = edge;
    limit.precision = precision;
    const double pass = fastest(0.5 * budget, [&] { kernels.read_modify_write(box, f.get(), threads); });
    const double numbers = static_cast<double>(direction_count * box.layer_stride * (box.cells_per_edge + 2));
    limit.bandwidth = 2.0 * numbers * sizeof(Real) / pass;
    limit.bandwidth_mlups = 1e-6 * limit.bandwidth / (bench_numbers_per_cell * sizeof(Real));
    const double both = fastest(0.5 * budget, [&] {
        kernels.stream_even(box, f.get(), threads);
        kernels.stream_odd(box, f.get(), threads);
    });
    limit.streaming_mlups = 2e-6 * std::pow(box.cells_per_edge, 3) / both;
    return limit;
}

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
                parameters.vesicles.push_back(vesicle);
            }
    return parameters;
}

BenchCase measure_case(const std::string& name, const Parameters& parameters, int threads,
                       const BenchOptions& options) {
    const auto engine =
        options.factory ? options.factory(parameters, threads) : make_engine(parameters, threads);
    BenchCase measured;
    measured.name = name;
    measured.edge = parameters.size.x;
    measured.precision = parameters.numerics.precision;
    // Pairs: streaming in place has even and odd steps, which need not cost the same.
    const double pair = fastest(options.seconds, [&] {
        engine->step();
        engine->step();
    });
    measured.mlups = 2e-6 * std::pow(parameters.size.x, 3) / pair;
    measured.interface_fraction = engine->interface_fraction();
    measured.bytes_per_cell = static_cast<double>(engine->bytes_allocated()) / std::pow(parameters.size.x, 3);
    measured.instruction_set = std::string(engine->instruction_set());
    return measured;
}

} // namespace

const BenchLimit& BenchReport::limit_of(const BenchCase& measured) const {
    const auto found = std::find_if(limits.begin(), limits.end(), [&](const BenchLimit& limit) {
        return limit.edge == measured.edge && limit.precision == measured.precision;
    });
    assert(found != limits.end());
    return *found;
}

BenchReport run_bench(const BenchOptions& options) {
    BenchReport report;
    report.threads = options.threads > 0 ? options.threads : default_threads();
    const std::vector<int> edges = options.edges.empty() ? std::vector<int>{128} : options.edges;
    const auto say = [&](const std::string& what, int edge) {
        if (options.progress != nullptr)
            *options.progress << fmt::format("measuring {}, {}^3\n", what, edge) << std::flush;
    };
    for (const int edge : edges) {
        if (edge < 32)
            throw InputError(
                fmt::format("--size is {}; expected at least 32 cells, below which nothing but caches is "
                            "measured; try 128",
                            edge));
        for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
            const bool in_double = precision == Precision::double_precision;
            const std::string suffix = in_double ? ", double" : ", single";
            say("the machine's limits" + suffix, edge);
            report.limits.push_back(in_double
                                        ? measure_limit<double>(edge, precision, report.threads,
                                                                options.seconds, report.instruction_set)
                                        : measure_limit<float>(edge, precision, report.threads,
                                                               options.seconds, report.instruction_set));
            say("a fluid at rest" + suffix, edge);
            report.cases.push_back(measure_case("fluid", fluid(edge, precision), report.threads, options));
            say("the same with multiple relaxation times" + suffix, edge);
            report.cases.push_back(
                measure_case("mrt", multiple_rates(edge, precision), report.threads, options));
            say("a discocyte" + suffix, edge);
            report.cases.push_back(
                measure_case("discocyte", discocyte(edge, precision), report.threads, options));
            say("a crowd of discocytes" + suffix, edge);
            report.cases.push_back(measure_case("crowd", crowd(edge, precision), report.threads, options));
        }
    }
    return report;
}

} // namespace vesica
