#pragma once

#include "measure/snapshot.hpp"

#include <cstddef>
#include <vector>

namespace vesica {

/// Values on a box of cells, z slowest, then y, x. Cell (i, j, k) of the block is the lattice's cell
/// origin + (i, j, k), its centre half a cell further.
struct DenseBlock {
    Vec3<int> origin{};
    Vec3<int> size{};
    std::vector<double> values;

    std::size_t index(int i, int j, int k) const {
        const auto wide = [](int n) {
            return static_cast<std::size_t>(n);
        };
        return (wide(k) * wide(size.y) + wide(j)) * wide(size.x) + wide(i);
    }
};

/// The vesicle's own phase field in the box around its layer, widened by `margin` cells; -1 outside.
/// Empty for a vesicle without cells.
DenseBlock phase_block(const VesicleSnapshot& vesicle, int margin = 1);

/// s = -atanh(phi)/beta. Where phi is +-1 (or beyond by rounding) s is some twenty layers away.
DenseBlock distance_block(const DenseBlock& phase, double beta);

/// The cell of the block that holds a cell of the vesicle's layer.
std::size_t block_index(const DenseBlock& block, const Vec3<double>& cell_centre);

/// A quantity of the layer's cells on the nodes of `frame`; 0 where there is no cell.
template <class Quantity>
std::vector<double> nodal_values(const VesicleSnapshot& vesicle, const DenseBlock& frame, Quantity quantity) {
    std::vector<double> values(frame.values.size(), 0.0);
    for (const InterfaceCell& cell : vesicle.cells)
        values[block_index(frame, cell.position)] = quantity(cell);
    return values;
}

} // namespace vesica
