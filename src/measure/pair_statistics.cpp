#include "measure/pair_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace vesica {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double length(const Vec3<double>& d) {
    return std::sqrt(dot(d, d));
}

/// From one place to the nearest image of another. Images above a sliding face have moved on, so that the
/// axis they slide across comes first.
Vec3<double> to_nearest_image(const Vec3<double>& from, const Vec3<double>& to, const PairBox& box) {
    Vec3<double> d = to - from;
    const auto take_boxes = [&](int axis) {
        const double boxes = box.periodic[axis] ? std::round(d[axis] / box.size[axis]) : 0.0;
        d[axis] -= boxes * box.size[axis];
        return boxes;
    };
    if (box.sliding)
        d[box.sliding->velocity] -= take_boxes(box.sliding->gradient) * box.sliding->displacement;
    for (int a = 0; a < 3; ++a)
        take_boxes(a);
    return d;
}

double longest_distance(const PairBox& box) {
    double shortest_period = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    for (int a = 0; a < 3; ++a) {
        longest = std::max(longest, 1.0 * box.size[a]);
        if (box.periodic[a])
            shortest_period = std::min(shortest_period, 1.0 * box.size[a]);
    }
    return 0.5 * std::min(shortest_period, longest);
}

double fluid_volume(const PairBox& box) {
    const double cells = 1.0 * box.size.x * box.size.y * box.size.z;
    return box.solids == nullptr ? cells : cells - static_cast<double>(box.solids->count());
}

/// Whether a point, or the image of it in the box, lies in the fluid. Solids do not come with sliding.
bool is_fluid(Vec3<double> place, const PairBox& box) {
    Vec3<int> cell{};
    for (int a = 0; a < 3; ++a) {
        const double period = box.size[a];
        if (box.periodic[a])
            place[a] -= period * std::floor(place[a] / period);
        else if (place[a] < 0.0 || place[a] >= period)
            return false;
        cell[a] = std::min(static_cast<int>(place[a]), box.size[a] - 1);
    }
    return box.solids == nullptr || !box.solids->at(cell);
}

/// Directions spread evenly over the sphere along a spiral.
std::vector<Vec3<double>> spread_directions(int count) {
    std::vector<Vec3<double>> directions;
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int k = 0; k < count; ++k) {
        const double z = 1.0 - (2.0 * k + 1.0) / count;
        const double r = std::sqrt(1.0 - z * z);
        directions.push_back({r * std::cos(golden_angle * k), r * std::sin(golden_angle * k), z});
    }
    return directions;
}

/// Of the spheres of this radius round all centres, the part that lies in the fluid.
double part_in_fluid(const std::vector<Vec3<double>>& centres, double radius, const PairBox& box,
                     const std::vector<Vec3<double>>& directions) {
    if (box.solids == nullptr && box.periodic == Vec3<bool>{true, true, true})
        return 1.0;
    std::int64_t in_fluid = 0;
    for (const Vec3<double>& centre : centres)
        for (const Vec3<double>& direction : directions)
            in_fluid += is_fluid(centre + radius * direction, box) ? 1 : 0;
    return static_cast<double>(in_fluid) / (static_cast<double>(centres.size() * directions.size()));
}

} // namespace

std::vector<PairBin> pair_statistics(const std::vector<Vec3<double>>& centres, const PairBox& box,
                                     double width, int along, int across) {
    const auto count = static_cast<std::size_t>(longest_distance(box) / width);
    std::vector<PairBin> bins(count);
    for (std::size_t first = 0; first < centres.size(); ++first)
        for (std::size_t second = first + 1; second < centres.size(); ++second) {
            const Vec3<double> d = to_nearest_image(centres[first], centres[second], box);
            const double distance = length(d);
            const auto bin = static_cast<std::size_t>(distance / width);
            if (bin >= count)
                continue;
            ++bins[bin].pairs;
            if (across >= 0 && distance > 0.0)
                bins[bin].shear_moment += 2.0 * d[along] * d[across] / (distance * distance);
        }
    const std::vector<Vec3<double>> directions = spread_directions(400);
    const auto points = static_cast<double>(centres.size());
    const double density = (points - 1.0) / fluid_volume(box); // of the others, round each
    for (std::size_t k = 0; k < count; ++k) {
        PairBin& bin = bins[k];
        const double inner = static_cast<double>(k) * width;
        const double outer = inner + width;
        bin.distance = 0.5 * (inner + outer);
        const double shell = 4.0 / 3.0 * std::numbers::pi * (std::pow(outer, 3) - std::pow(inner, 3)) *
                             part_in_fluid(centres, bin.distance, box, directions);
        const double expected = 0.5 * points * density * shell;
        const auto pairs = static_cast<double>(bin.pairs);
        bin.distribution = expected > 0.0 ? pairs / expected : unknown;
        bin.shear_moment = across >= 0 && bin.pairs > 0 ? bin.shear_moment / pairs : unknown;
    }
    return bins;
}

double nearest_neighbour(const std::vector<Vec3<double>>& centres, const PairBox& box) {
    if (centres.size() < 2)
        return unknown;
    double sum = 0.0;
    for (std::size_t own = 0; own < centres.size(); ++own) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < centres.size(); ++other)
            if (other != own)
                nearest = std::min(nearest, length(to_nearest_image(centres[own], centres[other], box)));
        sum += nearest;
    }
    return sum / static_cast<double>(centres.size());
}

} // namespace vesica
