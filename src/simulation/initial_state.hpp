#pragma once

#include "case/parameters.hpp"
#include "lattice/band.hpp"
#include "lattice/block.hpp"
#include "lattice/grid.hpp"
#include "shape/shape.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace vesica {

/// The colours a run starts from, in a block of a periodic box: phi = -tanh(beta s), s the distance from the
/// nearest shape's surface.
class InitialColours {
public:
    struct Placed {
        std::shared_ptr<const Shape> shape;
        Vec3<double> centre;
    };

    InitialColours(const Block& block, std::vector<Placed> shapes, double beta, double cutoff, int threads);

    /// Cells whose 1 - phi^2 exceeds the cutoff.
    const std::vector<Band::Seed>& core() const { return core_; }
    /// Per tile: bit k set where cell k lies inside.
    const std::vector<std::uint8_t>& inside() const { return inside_; }
    /// Signed minority fraction of a cell of the block, by grid index.
    double chi_at(std::int64_t cell) const;

private:
    struct Row;

    /// The images of shapes that come within `far` of a row of cells, by its place in the whole box.
    Row row_near(int y, int z, double far) const;
    double distance(const Row& row, int x) const;

    Block block_;
    Grid grid_;
    std::vector<Placed> shapes_;
    double beta_;
    std::vector<Band::Seed> core_;
    std::vector<std::uint8_t> inside_;
};

} // namespace vesica
