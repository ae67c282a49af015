#include "core/version.hpp"
#include "simulation/bench.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace vesica {

std::string bench_text(const BenchReport& report) {
    std::string text = fmt::format("vesica {}, {} thread{}, {}\n\n", version, report.threads,
                                   report.threads == 1 ? "" : "s", report.instruction_set);
    text += "The machine's limits: one pass over 19 populations per cell, read and written in place\n";
    text += fmt::format("  {:>5}  {:<9}  {:>10}  {:>18}  {:>18}\n", "box", "precision", "GB/s",
                        "bandwidth, MLUPS", "streaming, MLUPS");
    for (const BenchLimit& limit : report.limits)
        text += fmt::format("  {:>3}^3  {:<9}  {:>10.1f}  {:>18.1f}  {:>18.1f}\n", limit.edge,
                            name_of(limit.precision), 1e-9 * limit.bandwidth, limit.bandwidth_mlups,
                            limit.streaming_mlups);
    text += "\nThe standard cases\n";
    text += fmt::format("  {:<10}  {:>5}  {:<9}  {:>8}  {:>12}  {:>12}  {:>11}  {:>10}\n", "case", "box",
                        "precision", "MLUPS", "of bandwidth", "of streaming", "interface", "bytes/cell");
    for (const BenchCase& measured : report.cases) {
        text += fmt::format(
            "  {:<10}  {:>3}^3  {:<9}  {:>8.2f}  {:>10.1f} %  {:>10.1f} %  {:>9.1f} %  {:>10.1f}\n",
            measured.name, measured.edge, name_of(measured.precision), measured.mlups,
            100.0 * measured.mlups / measured.bandwidth_mlups,
            100.0 * measured.mlups / measured.streaming_mlups, 100.0 * measured.interface_fraction,
            measured.bytes_per_cell);
    }
    return text;
}

std::string bench_json(const BenchReport& report) {
    nlohmann::ordered_json json;
    json["version"] = version;
    json["threads"] = report.threads;
    json["instruction_set"] = report.instruction_set;
    json["limits"] = nlohmann::ordered_json::array();
    for (const BenchLimit& limit : report.limits)
        json["limits"].push_back({{"edge", limit.edge},
                                  {"precision", name_of(limit.precision)},
                                  {"bytes_per_second", limit.bandwidth},
                                  {"bandwidth_mlups", limit.bandwidth_mlups},
                                  {"streaming_mlups", limit.streaming_mlups}});
    json["cases"] = nlohmann::ordered_json::array();
    for (const BenchCase& measured : report.cases) {
        json["cases"].push_back({{"name", measured.name},
                                 {"edge", measured.edge},
                                 {"precision", name_of(measured.precision)},
                                 {"instruction_set", measured.instruction_set},
                                 {"mlups", measured.mlups},
                                 {"bandwidth_mlups", measured.bandwidth_mlups},
                                 {"streaming_mlups", measured.streaming_mlups},
                                 {"interface_fraction", measured.interface_fraction},
                                 {"bytes_per_cell", measured.bytes_per_cell},
                                 {"over_bandwidth", measured.mlups / measured.bandwidth_mlups},
                                 {"over_streaming", measured.mlups / measured.streaming_mlups}});
    }
    return json.dump(2) + "\n";
}

} // namespace vesica
