#include "measure/surface.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <unordered_map>

namespace vesica {
namespace {

/// A cube's corner, or an edge's direction, as bits: 1 for x, 2 for y, 4 for z.
using Corner = unsigned;

struct Tetrahedron {
    std::array<Corner, 4> corners;
    bool even; ///< its corners form a right-handed frame
};

/// Paths 0 -> 7 along the axes in each of the six orders (Kuhn 1960).
constexpr std::array<Tetrahedron, 6> kuhn = {{
    {{0, 1, 3, 7}, true},
    {{0, 2, 6, 7}, true},
    {{0, 4, 5, 7}, true},
    {{0, 1, 5, 7}, false},
    {{0, 2, 3, 7}, false},
    {{0, 4, 6, 7}, false},
}};

class Marcher {
public:
    explicit Marcher(const DenseBlock& distance) : distance_(distance) {
        for (Corner c = 0; c < 8; ++c)
            offset_[c] = distance.index(static_cast<int>(c & 1), static_cast<int>(c >> 1 & 1),
                                        static_cast<int>(c >> 2));
    }

    void visit_cube(int i, int j, int k) {
        const std::size_t base = distance_.index(i, j, k);
        unsigned inside = 0;
        for (Corner c = 0; c < 8; ++c)
            if (is_inside(base + offset_[c]))
                inside |= 1u << c;
        if (inside == 0 || inside == 0xff)
            return;
        cube_ = {i, j, k};
        for (const Tetrahedron& tetrahedron : kuhn)
            cut(tetrahedron, inside);
    }

    SurfaceMesh take() { return std::move(mesh_); }

private:
    bool is_inside(std::size_t node) const { return distance_.values[node] < 0.0; }

    void cut(const Tetrahedron& tetrahedron, unsigned inside) {
        // Corners inside first, keeping track of the orientation through the swaps.
        std::array<Corner, 4> v = tetrahedron.corners;
        bool even = tetrahedron.even;
        std::size_t count = 0;
        for (std::size_t n = 0; n < 4; ++n) {
            if ((inside >> v[n] & 1u) == 0)
                continue;
            if (n != count) {
                std::swap(v[n], v[count]);
                even = !even;
            }
            ++count;
        }
        const auto on = [&](std::size_t a, std::size_t b) {
            return crossing(v[a], v[b]);
        };
        switch (count) {
        case 1:
            add_triangle(on(0, 1), on(0, 2), on(0, 3), even);
            break;
        case 2:
            add_triangle(on(0, 2), on(0, 3), on(1, 3), even);
            add_triangle(on(0, 2), on(1, 3), on(1, 2), even);
            break;
        case 3:
            add_triangle(on(0, 3), on(1, 3), on(2, 3), even);
            break;
        default:
            break;
        }
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool even) {
        if (!even)
            std::swap(b, c);
        mesh_.triangles.push_back({a, b, c});
    }

    /// The mesh's point on the edge between two corners of the present cube; made when first asked for.
    std::uint32_t crossing(Corner p, Corner q) {
        const Corner low = std::min(p, q); // along a Kuhn edge one corner's bits contain the other's
        const Corner high = std::max(p, q);
        const std::size_t base = distance_.index(cube_.x, cube_.y, cube_.z);
        const std::size_t a = base + offset_[low];
        const std::size_t b = base + offset_[high];
        const auto [entry, is_new] = numbers_.try_emplace(8 * a + (high - low), mesh_.points.size());
        if (is_new) {
            constexpr double margin = 1e-4;
            const double at_a = distance_.values[a];
            const double at_b = distance_.values[b];
            const double t = std::clamp(at_a / (at_a - at_b), margin, 1.0 - margin);
            const Vec3<double> start = centre(low);
            mesh_.points.push_back(start + t * (centre(high) - start));
            mesh_.lattice_points.push_back({a, b, t});
        }
        return static_cast<std::uint32_t>(entry->second);
    }

    Vec3<double> centre(Corner c) const {
        const Vec3<int> cell =
            distance_.origin + cube_ +
            Vec3<int>{static_cast<int>(c & 1), static_cast<int>(c >> 1 & 1), static_cast<int>(c >> 2)};
        return {cell.x + 0.5, cell.y + 0.5, cell.z + 0.5};
    }

    const DenseBlock& distance_;
    std::array<std::size_t, 8> offset_{};
    Vec3<int> cube_{};
    std::unordered_map<std::size_t, std::size_t> numbers_; // looked up only: its order never shows
    SurfaceMesh mesh_;
};

} // namespace

SurfaceMesh extract_surface(const DenseBlock& distance) {
    assert(distance.values.size() == distance.index(0, 0, distance.size.z));
    Marcher marcher(distance);
    for (int k = 0; k + 1 < distance.size.z; ++k)
        for (int j = 0; j + 1 < distance.size.y; ++j)
            for (int i = 0; i + 1 < distance.size.x; ++i)
                marcher.visit_cube(i, j, k);
    return marcher.take();
}

SurfaceMesh extract_surface(const VesicleSnapshot& vesicle) {
    return extract_surface(distance_block(phase_block(vesicle), vesicle.beta));
}

} // namespace vesica
