#pragma once

#include "lattice/block.hpp"
#include "lattice/grid.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vesica {

/// How far the images above a box have moved on along the velocity's axis, modulo the box: whole cells and
/// the rest, in [0, 1). Values in between are taken from four cells, by the cubic through them: whoever
/// differentiates them twice would find the kinks of straight lines.
struct Displacement {
    static constexpr int reads = 4;

    int whole = 0;
    std::array<double, reads> weights{0.0, 1.0, 0.0, 0.0}; ///< of the cells at whole - 1 ... whole + 2

    static Displacement of(double cells, int period) {
        const double wrapped = cells - std::floor(cells / period) * period;
        const double whole = std::floor(wrapped);
        const double t = wrapped - whole;
        return {static_cast<int>(whole) % period,
                {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
                 -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0}};
    }
};

/// The cells of a block that lie along the box's sliding faces, and the lines of cells beyond them.
class SlidingFaces {
public:
    struct Face {
        int towards = 0; ///< -1: below the lower face, +1: above the upper one
        int rim = 0;     ///< the block's own last place along the gradient
        int ghosts = 0;  ///< the place beyond
    };

    SlidingFaces() = default;
    SlidingFaces(const Grid& grid, const Block& block) : grid_(grid) {
        if (!block.slide)
            return;
        slide_ = *block.slide;
        for (const bool upper : {false, true})
            if (block.slides_at(slide_.gradient, upper)) {
                const int last = grid.size()[slide_.gradient] - 1;
                faces_.push_back({upper ? 1 : -1, upper ? last : 0, upper ? last + 1 : -1});
            }
    }

    const std::vector<Face>& faces() const { return faces_; }
    const Slide& slide() const { return slide_; }
    /// The third axis.
    int beside() const { return 3 - slide_.gradient - slide_.velocity; }

    /// body(face, index of a tile's first cell, bits of its cells along the face) for the tiles of the k-th
    /// row of cells along each face, of `rows()`.
    int rows() const { return slide_.gradient == 2 ? grid_.size().y : grid_.size().z; }
    template <class Body>
    void for_each_tile(std::int64_t k, const Body& body) const {
        const auto row = static_cast<int>(k);
        for (const Face& face : faces_) {
            if (slide_.gradient == 0) {
                for (int y = 0; y < grid_.size().y; ++y)
                    body(face, grid_.index(face.rim / Grid::tile * Grid::tile, y, row),
                         1u << (face.rim % Grid::tile));
                continue;
            }
            const int y = slide_.gradient == 1 ? face.rim : row;
            const int z = slide_.gradient == 2 ? face.rim : row;
            for (int x = 0; x < grid_.size().x; x += Grid::tile)
                body(face, grid_.index(x, y, z), unsigned{grid_.interior_bits({x, y, z})});
        }
    }

private:
    Grid grid_;
    Slide slide_;
    std::vector<Face> faces_;
};

} // namespace vesica
