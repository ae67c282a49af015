#include "shape/mesh_voxels.hpp"

#include "core/input_error.hpp"
#include "shape/mesh_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Every row of cell centres is a ray along x, and a centre is inside after an odd number of crossings. The
// crossings are found by halving dimensions: the plane of centres z = k + 1/2 cuts the edges of the mesh in
// points and its triangles in segments between them, and a row of that plane cuts the segments. Rays through
// vertices, edges and faces need no tolerance: a point counts as below a centre when its coordinate is not
// greater (half-open intervals), which only asks for the integer `first_centre` of a vertex or cut edge. All
// triangles at an edge compute its cut from the same numbers in the same order, and a closed mesh has two
// segments at every cut, so each row is crossed an even number of times whatever the rounding.

namespace vesica {
namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// The first of `count` cells whose centre i + 1/2 is not below `coordinate`; `count` if there is none.
int first_centre(double coordinate, int count) {
    return static_cast<int>(std::clamp(std::ceil(coordinate - 0.5), 0.0, static_cast<double>(count)));
}

/// Where a plane of constant z cuts an edge.
struct Cut {
    double x;
    double y;
};

/// The cut of the edge between two vertices, whichever of its triangles asks.
Cut cut_of(const std::vector<Vec3<double>>& vertices, int one, int other, double z) {
    const Vec3<double>& a = vertices[index(std::min(one, other))];
    const Vec3<double>& b = vertices[index(std::max(one, other))];
    const double share = (z - a.z) / (b.z - a.z);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

std::vector<Vec3<double>> placed(const TriangleMesh& mesh, double scale, const Vec3<double>& position) {
    std::vector<Vec3<double>> vertices = mesh.vertices;
    for (Vec3<double>& v : vertices) {
        v = scale * v + position;
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            throw InputError(
                SourcePlace{mesh.source, 0, 0},
                fmt::format("a vertex is at ({}, {}, {}) cells after scaling by {}; expected finite numbers; "
                            "try a smaller scale",
                            v.x, v.y, v.z, scale));
    }
    return vertices;
}

/// The planes of centres that a triangle crosses: from `begin` to the one before `end`.
struct Span {
    int begin = 0;
    int end = 0;
    int triangle = 0;
};

/// Crossings in one plane of cells: an odd number at (x, y) turns the state of cell x and those behind it.
class PlaneCrossings {
public:
    explicit PlaneCrossings(const Vec3<int>& size) : size_(size), odd_(index(size.x) * index(size.y)) {}

    /// Counts the crossings of a segment with all rows.
    void add(const Cut& a, const Cut& b) {
        const bool rising = a.y < b.y;
        const Cut &low = rising ? a : b, &high = rising ? b : a;
        const int end = first_centre(high.y, size_.y);
        for (int y = first_centre(low.y, size_.y); y < end; ++y) {
            const double share = (y + 0.5 - low.y) / (high.y - low.y);
            const int x = first_centre(low.x + share * (high.x - low.x), size_.x);
            if (x < size_.x)
                odd_[index(y) * index(size_.x) + index(x)] ^= 1;
        }
    }

    /// Sets the solid cells of plane z and forgets the crossings.
    void mark(int z, bool solid_inside, SolidVoxels& solid) {
        for (int y = 0; y < size_.y; ++y) {
            std::uint8_t* const row = odd_.data() + index(y) * index(size_.x);
            bool inside = false;
            for (int x = 0; x < size_.x; ++x) {
                inside = inside != (row[x] != 0);
                if (inside == solid_inside)
                    solid.set({x, y, z});
            }
        }
        std::fill(odd_.begin(), odd_.end(), std::uint8_t{0});
    }

private:
    Vec3<int> size_;
    std::vector<std::uint8_t> odd_;
};

/// The triangles that cross a plane of centres of the box, by their first one.
std::vector<Span> spans_of(const TriangleMesh& mesh, const std::vector<int>& first_plane) {
    std::vector<Span> spans;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const auto [low, high] =
            std::minmax({first_plane[index(t[0])], first_plane[index(t[1])], first_plane[index(t[2])]});
        if (low < high)
            spans.push_back({low, high, static_cast<int>(i)});
    }
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.triangle < b.triangle;
    });
    return spans;
}

} // namespace

SolidVoxels voxelise(const TriangleMesh& mesh, const Vec3<int>& size, double scale,
                     const Vec3<double>& position, bool solid_inside) {
    assert(scale > 0.0);
    check_closed_pieces(mesh);
    const std::vector<Vec3<double>> vertices = placed(mesh, scale, position);
    std::vector<int> first_plane;
    first_plane.reserve(vertices.size());
    for (const Vec3<double>& v : vertices)
        first_plane.push_back(first_centre(v.z, size.z));
    const std::vector<Span> spans = spans_of(mesh, first_plane);

    SolidVoxels solid(size);
    PlaneCrossings crossings(size);
    std::vector<Span> active;
    auto next = spans.begin();
    for (int z = 0; z < size.z; ++z) {
        std::erase_if(active, [&](const Span& span) { return span.end <= z; });
        for (; next != spans.end() && next->begin == z; ++next)
            active.push_back(*next);
        for (const Span& span : active) {
            const auto& t = mesh.triangles[index(span.triangle)];
            Cut cuts[2];
            std::size_t count = 0; // two: the corners are on both sides of the plane
            for (std::size_t k = 0; k < 3; ++k) {
                const int from = t[k], to = t[(k + 1) % 3];
                if ((first_plane[index(from)] <= z) != (first_plane[index(to)] <= z))
                    cuts[count++] = cut_of(vertices, from, to, z + 0.5);
            }
            assert(count == 2);
            crossings.add(cuts[0], cuts[1]);
        }
        crossings.mark(z, solid_inside, solid);
    }
    return solid;
}

} // namespace vesica
