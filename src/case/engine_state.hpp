#pragma once

#include "case/parameters.hpp"
#include "core/cell_box.hpp"

#include <cstdint>
#include <vector>

namespace vesica {

/// Everything that must be kept to continue bit for bit, of a part of the box. Arrays are in the part's
/// canonical order (z, y, x), independent of threads and instruction sets.
struct EngineState {
    std::int64_t step = 0;
    Precision precision = Precision::double_precision;
    Vec3<int> size{};                             ///< of the whole box
    CellBox part{};                               ///< the cells the arrays are of
    std::vector<std::vector<double>> populations; ///< 19 x cells, f_i - t_i rho0
    std::vector<double> minority;                 ///< signed minority colour fraction per cell
    std::vector<std::uint8_t> band;  ///< per cell: bit 0 core at the last rebuild, bit 1 inside (red) side
    std::vector<double> controllers; ///< area constraint state, vesicle by vesicle
};

} // namespace vesica
