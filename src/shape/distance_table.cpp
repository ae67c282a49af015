#include "shape/distance_table.hpp"

#include <algorithm>
#include <cmath>

namespace vesica {

DistanceTable::DistanceTable(const Shape& shape, double margin)
    : half_(shape.bounding_radius() + margin), spacing_(shape.bounding_radius() / cells_per_radius) {
    const int cells = 2 * static_cast<int>(std::ceil(half_ / spacing_));
    half_ = 0.5 * cells * spacing_;
    nodes_ = cells + 1;
    values_.reserve(static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(nodes_) *
                    static_cast<std::size_t>(nodes_));
    for (int k = 0; k < nodes_; ++k)
        for (int j = 0; j < nodes_; ++j)
            for (int i = 0; i < nodes_; ++i)
                values_.push_back(shape.signed_distance(
                    {i * spacing_ - half_, j * spacing_ - half_, k * spacing_ - half_}));
}

DistanceValue DistanceTable::at(const Vec3<double>& position) const {
    Vec3<double> place = (1.0 / spacing_) * (position + Vec3<double>{half_, half_, half_});
    for (int a = 0; a < 3; ++a)
        place[a] = std::clamp(place[a], 0.0, nodes_ - 1.001);
    return trilinear(place, [&](const Vec3<int>& k) { return node(k); });
}

std::vector<InnerPoint> DistanceTable::points(double spacing) const {
    std::vector<InnerPoint> points;
    const auto place_of = [&](int i, int j, int k) {
        return Vec3<double>{i * spacing_ - half_, j * spacing_ - half_, k * spacing_ - half_};
    };
    const auto on_surface = [&](Vec3<double> place) {
        for (int step = 0; step < 3; ++step) {
            const DistanceValue value = at(place);
            place = place - value.distance * value.gradient;
        }
        const bool is_new = std::none_of(points.begin(), points.end(), [&](const InnerPoint& other) {
            const Vec3<double> between = place - other.place;
            return other.depth == 0.0 && dot(between, between) < spacing * spacing;
        });
        if (is_new && std::abs(at(place).distance) < 0.2 * spacing_)
            points.push_back({place, 0.0});
    };
    const auto for_each_node = [&](const auto& body) {
        for (int k = 0; k < nodes_; ++k)
            for (int j = 0; j < nodes_; ++j)
                for (int i = 0; i < nodes_; ++i)
                    body(node({i, j, k}), place_of(i, j, k));
    };
    // The centre, or the deepest place of a shape that has a hollow there. More than one would cancel each
    // other where two bodies lie on top of each other.
    InnerPoint inside{{}, -at({}).distance};
    if (inside.depth < spacing_)
        for_each_node([&](double distance, const Vec3<double>& place) {
            if (-distance > inside.depth)
                inside = {place, -distance};
        });
    points.push_back(inside);
    for_each_node([&](double distance, const Vec3<double>& place) {
        if (std::abs(distance) < 0.9 * spacing_)
            on_surface(place);
    });
    return points;
}

} // namespace vesica
