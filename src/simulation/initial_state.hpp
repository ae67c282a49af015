#pragma once

#include "case/parameters.hpp"
#include "lattice/band.hpp"
#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "shape/shape.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vesica {

/// The colours a run starts from, in a block of a periodic box: per label phi = -tanh(beta s), s the distance
/// from the surface of the nearest of its shapes.
class InitialColours {
public:
    struct Placed {
        std::shared_ptr<const Shape> shape;
        Vec3<double> centre;
        int label = 0;
    };

    /// Shapes with ascending labels.
    InitialColours(const Block& block, std::vector<Placed> shapes, double beta, double cutoff, int threads);

    /// Cells whose 1 - phi^2 exceeds the cutoff.
    const std::vector<Band::Seed>& core() const { return core_; }
    /// Per tile: the label inside whose shapes all of it lies; -1: none.
    const std::vector<std::int32_t>& interior() const { return interior_; }
    /// Signed minority fraction of a cell of the block, by grid index.
    double chi_at(std::int64_t cell, int label) const;

private:
    struct Row;

    /// The images of these shapes that come within `far` of a row of cells, by its place in the whole box.
    void find_near(std::span<const Placed> shapes, int y, int z, double far, Row& row) const;
    std::vector<Placed> shapes_near_plane(int z, double far) const;
    /// From the nearest surface of the row's images from the first to the one before the last; `far` where
    /// that is farther.
    double distance(const Row& row, std::size_t first, std::size_t last, int x) const;

    Block block_;
    Grid grid_;
    std::vector<Placed> shapes_;
    double beta_;
    std::vector<Band::Seed> core_;
    std::vector<std::int32_t> interior_;
};

} // namespace vesica
