#include "shape/triangle_tree.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace vesica {
namespace {

constexpr int triangles_per_leaf = 4;
constexpr int deepest = 64; // halving 2^31 triangles takes 31 levels

/// Ericson 2005, "Real-time collision detection", 5.1.5: the regions of the triangle's plane in turn.
ClosestPoint closest_on_triangle(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b,
                                 const Vec3<double>& c) {
    const auto at = [&](const Vec3<double>& q, int feature) {
        const Vec3<double> d = p - q;
        return ClosestPoint{q, dot(d, d), -1, feature};
    };
    const Vec3<double> ab = b - a, ac = c - a, ap = p - a;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0)
        return at(a, 1);
    const Vec3<double> bp = p - b;
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3)
        return at(b, 2);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        return at(a + (d1 / (d1 - d3)) * ab, 4);
    const Vec3<double> cp = p - c;
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6)
        return at(c, 3);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        return at(a + (d2 / (d2 - d6)) * ac, 6);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        return at(b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), 5);
    const double scale = 1.0 / (va + vb + vc);
    return at(a + (vb * scale) * ab + (vc * scale) * ac, 0);
}

} // namespace

void BoundingBox::include(const Vec3<double>& p) {
    for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
    }
}

double BoundingBox::squared_distance(const Vec3<double>& p) const {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double d = std::max({low[i] - p[i], 0.0, p[i] - high[i]});
        sum += d * d;
    }
    return sum;
}

bool BoundingBox::overlaps(const BoundingBox& other) const {
    for (int i = 0; i < 3; ++i)
        if (low[i] > other.high[i] || other.low[i] > high[i])
            return false;
    return true;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    boxes_.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto vertex = [&](int i) {
            return mesh.vertices[static_cast<std::size_t>(i)];
        };
        BoundingBox box{vertex(a), vertex(a)};
        box.include(vertex(b));
        box.include(vertex(c));
        boxes_.push_back(box);
    }
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(2 * order_.size() / triangles_per_leaf + 2);
    nodes_.emplace_back();
    build(0, 0, static_cast<int>(order_.size()));
}

void TriangleTree::build(int node, int begin, int end) {
    const auto index = [](int i) {
        return static_cast<std::size_t>(i);
    };
    BoundingBox box = box_of(order_[index(begin)]);
    BoundingBox centres{box.low + box.high, box.low + box.high}; // twice the centres
    for (int i = begin; i < end; ++i) {
        const BoundingBox& b = box_of(order_[index(i)]);
        box.include(b.low);
        box.include(b.high);
        centres.include(b.low + b.high);
    }
    nodes_[index(node)] = {box, begin, end - begin};
    if (end - begin <= triangles_per_leaf)
        return;

    const Vec3<double> extent = centres.high - centres.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const int middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int a, int b) {
                         const double ca = box_of(a).low[axis] + box_of(a).high[axis];
                         const double cb = box_of(b).low[axis] + box_of(b).high[axis];
                         return ca != cb ? ca < cb : a < b;
                     });
    const int left = static_cast<int>(nodes_.size());
    nodes_[index(node)].begin = left;
    nodes_[index(node)].count = 0;
    nodes_.emplace_back();
    nodes_.emplace_back();
    build(left, begin, middle);
    build(left + 1, middle, end);
}

ClosestPoint TriangleTree::closest(const Vec3<double>& position, double within) const {
    struct Entry {
        int node;
        double squared_distance;
    };
    Entry stack[deepest];
    int height = 0;
    stack[height++] = {0, nodes_[0].box.squared_distance(position)};
    ClosestPoint best;
    best.squared_distance = within;
    while (height > 0) {
        const Entry entry = stack[--height];
        if (entry.squared_distance >= best.squared_distance)
            continue;
        const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
        for (int i = node.begin; i < node.begin + node.count; ++i) {
            const int triangle = order_[static_cast<std::size_t>(i)];
            const auto& [a, b, c] = mesh_.triangles[static_cast<std::size_t>(triangle)];
            const auto vertex = [&](int k) -> const Vec3<double>& {
                return mesh_.vertices[static_cast<std::size_t>(k)];
            };
            ClosestPoint here = closest_on_triangle(position, vertex(a), vertex(b), vertex(c));
            if (here.squared_distance >= best.squared_distance)
                continue;
            here.triangle = triangle;
            best = here;
        }
        if (node.count > 0)
            continue;
        Entry near{node.begin, nodes_[static_cast<std::size_t>(node.begin)].box.squared_distance(position)};
        Entry far{node.begin + 1,
                  nodes_[static_cast<std::size_t>(node.begin) + 1].box.squared_distance(position)};
        if (far.squared_distance < near.squared_distance)
            std::swap(near, far);
        assert(height + 2 <= deepest);
        stack[height++] = far;
        stack[height++] = near;
    }
    return best;
}

std::vector<int> TriangleTree::overlapping(const BoundingBox& box) const {
    std::vector<int> found;
    std::vector<int> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[static_cast<std::size_t>(stack.back())];
        stack.pop_back();
        if (!node.box.overlaps(box))
            continue;
        for (int i = node.begin; i < node.begin + node.count; ++i)
            if (const int triangle = order_[static_cast<std::size_t>(i)]; box_of(triangle).overlaps(box))
                found.push_back(triangle);
        if (node.count > 0)
            continue;
        stack.push_back(node.begin + 1);
        stack.push_back(node.begin);
    }
    return found;
}

} // namespace vesica
