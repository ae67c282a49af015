#pragma once

#include "simulation/plan_cost.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace vesica {

struct BenchOptions {
    int threads = 0;                ///< 0: as many as default_threads()
    std::vector<int> edges;         ///< of the cubes; empty: 128
    std::vector<std::string> cases; ///< by name; empty: all
    int colours = 0;                ///< of the spheres; 0: one for each
    double seconds = 5.0;           ///< to spend on each case
    EngineFactory factory;          ///< empty: make_engine
    std::ostream* progress = nullptr;
};

/// What the machine can do at most: passes over all populations in place, the fastest of all that took turns
/// with the cases.
struct BenchLimit {
    int edge = 0;
    Precision precision = Precision::double_precision;
    double bandwidth = 0.0;       ///< bytes per second, read-modify-write of one large array
    double bandwidth_mlups = 0.0; ///< the same in cells of 38 numbers, 19 read and 19 written
    double streaming_mlups = 0.0; ///< D3Q19 streaming in place without collision
};

struct BenchCase {
    std::string name;
    int edge = 0;
    Precision precision = Precision::double_precision;
    double mlups = 0.0;
    double bandwidth_mlups = 0.0; ///< what the limits' passes reached, taking turns with this case
    double streaming_mlups = 0.0;
    double interface_fraction = 0.0; ///< of the box's cells in interface bands
    double bytes_per_cell = 0.0;     ///< of the engine's own memory
    std::string instruction_set;
};

struct BenchReport {
    int threads = 1;
    std::string instruction_set; ///< of the limits' kernels
    std::vector<BenchLimit> limits;
    std::vector<BenchCase> cases;
};

/// The names of the standard cases.
const std::vector<std::string>& bench_case_names();

/// Measures the standard cases in double and in single precision: `fluid`, at rest with the regularised
/// collision, `mrt`, the same with multiple relaxation times, `discocyte`, of R0 = 20 per 128 cells, and
/// `crowd`, discocytes of R0 = 18.5, one in every 64^3 cells. Passes of the machine's limits and steps of a
/// case take turns, so that a machine that is slower for a while is slower for all. Throws InputError for a
/// box too small or a name unknown. By name only: `spheres` of
/// R0 = 10, one in every 32^3 cells.
BenchReport run_bench(const BenchOptions& options);

std::string bench_text(const BenchReport& report);
std::string bench_json(const BenchReport& report);

} // namespace vesica
