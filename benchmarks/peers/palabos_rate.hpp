#pragma once

#include "palabos_headers.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>
#include <string>

/// What both peers share: the command line, the clock and the line they print.
namespace peers {

struct Arguments {
    int edge = 128;       ///< of the cube, cells
    double seconds = 2.0; ///< to spend
    std::string precision = "double";
    std::string collision; ///< as the program knows them
};

/// Reads `--size N --seconds S --precision double|single --collision NAME`. Ends the program with status 2 at
/// anything else.
inline Arguments read_arguments(int argc, char** argv, const std::string& default_collision) {
    Arguments arguments;
    arguments.collision = default_collision;
    std::map<std::string, std::string> given;
    bool understood = argc % 2 == 1;
    for (int k = 1; k + 1 < argc; k += 2)
        given[argv[k]] = argv[k + 1];
    for (const auto& option : given) {
        if (option.first == "--size")
            arguments.edge = std::atoi(option.second.c_str());
        else if (option.first == "--seconds")
            arguments.seconds = std::atof(option.second.c_str());
        else if (option.first == "--precision")
            arguments.precision = option.second;
        else if (option.first == "--collision")
            arguments.collision = option.second;
        else
            understood = false;
    }
    understood = understood && arguments.edge >= 8 && arguments.seconds > 0.0 &&
                 (arguments.precision == "double" || arguments.precision == "single");
    if (!understood) {
        plb::pcerr << "usage: " << argv[0]
                   << " [--size N] [--seconds S] [--precision double|single] [--collision NAME]\n"
                   << "N is at least 8\n";
        std::exit(2);
    }
    return arguments;
}

struct Rate {
    double mlups = 0.0;      ///< of the fastest pair of steps, as `vesica bench` reports it
    double mean_mlups = 0.0; ///< of all pairs
    int steps = 0;           ///< all of them, the first pair too
};

/// Calls `step` in pairs until the time is over. All ranks wait for each other before the clock is read; the
/// first one decides for all whether to go on.
template <class Step>
Rate measure(const Arguments& arguments, const Step& step) {
    using Clock = std::chrono::steady_clock;
    const auto pair = [&] {
        plb::global::mpi().barrier();
        const auto begin = Clock::now();
        step();
        step();
        plb::global::mpi().barrier();
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    Rate rate;
    pair(); // caches, pages, connections between ranks
    rate.steps = 2;
    double best = std::numeric_limits<double>::infinity();
    double total = 0.0;
    int pairs = 0;
    for (int go_on = 1; go_on != 0;) {
        const double seconds = pair();
        best = std::min(best, seconds);
        total += seconds;
        ++pairs;
        rate.steps += 2;
        go_on = pairs < 3 || total < arguments.seconds ? 1 : 0;
        plb::global::mpi().bCast(&go_on, 1);
    }
    const double cells = 1e-6 * arguments.edge * arguments.edge * arguments.edge;
    rate.mlups = 2.0 * cells / best;
    rate.mean_mlups = 2.0 * cells * pairs / total;
    return rate;
}

/// One line of JSON; `extra` are further members, each with a comma before it.
inline void print_rate(const char* name, const Arguments& arguments, const Rate& rate,
                       const std::string& extra) {
    std::ostringstream line;
    line.precision(6);
    line << "{\"peer\": \"palabos\", \"case\": \"" << name << "\", \"collision\": \"" << arguments.collision
         << "\", \"precision\": \"" << arguments.precision << "\", \"edge\": " << arguments.edge
         << ", \"ranks\": " << plb::global::mpi().getSize() << ", \"steps\": " << rate.steps
         << ", \"mlups\": " << rate.mlups << ", \"mean_mlups\": " << rate.mean_mlups << extra << "}\n";
    plb::pcout << line.str() << std::flush;
}

/// The whole program: body(arguments, T()) with T the precision asked for.
template <class Body>
int run_in_precision_asked_for(int argc, char** argv, const Body& body) {
    plb::plbInit(&argc, &argv);
    const Arguments arguments = read_arguments(argc, argv, "bgk");
    if (arguments.precision == "double")
        body(arguments, double());
    else
        body(arguments, float());
    return 0;
}

} // namespace peers
