#include "shape/solid_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vesica {

namespace {

constexpr float far = 1e12f;

std::size_t index(const Vec3<int>& size, const Vec3<int>& place) {
    return (static_cast<std::size_t>(place.z) * static_cast<std::size_t>(size.y) +
            static_cast<std::size_t>(place.y)) *
               static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(place.x);
}

/// min over q of (p - q)^2 + f(q) for every p: the lower envelope of parabolas.
class LowerEnvelope {
public:
    void operator()(std::vector<float>& f) {
        const int n = static_cast<int>(f.size());
        vertex_.assign(f.size(), 0);
        from_.assign(f.size() + 1, 0.0);
        int last = 0;
        from_[0] = -1e30;
        from_[1] = 1e30;
        const auto at = [](int k) {
            return static_cast<std::size_t>(k);
        };
        const auto meeting = [&](int p, int q) {
            return ((double{f[at(p)]} + 1.0 * p * p) - (double{f[at(q)]} + 1.0 * q * q)) / (2.0 * (p - q));
        };
        for (int p = 1; p < n; ++p) {
            double s = meeting(p, vertex_[at(last)]);
            while (last > 0 && s <= from_[at(last)]) {
                --last;
                s = meeting(p, vertex_[at(last)]);
            }
            ++last;
            vertex_[at(last)] = p;
            from_[at(last)] = s;
            from_[at(last) + 1] = 1e30;
        }
        result_.resize(f.size());
        int k = 0;
        for (int p = 0; p < n; ++p) {
            while (from_[at(k) + 1] < p)
                ++k;
            const int q = vertex_[at(k)];
            result_[at(p)] = static_cast<float>(1.0 * (p - q) * (p - q)) + f[at(q)];
        }
        f.swap(result_);
    }

private:
    std::vector<int> vertex_;
    std::vector<double> from_;
    std::vector<float> result_;
};

/// Squared distance of every cell's centre to the nearest one where `here` holds.
template <class Here>
std::vector<float> squared_distance(const Vec3<int>& size, const std::array<bool, 3>& periodic,
                                    const Here& here) {
    std::vector<float> squared(index(size, {0, 0, size.z}), far);
    Vec3<int> place{};
    for (place.z = 0; place.z < size.z; ++place.z)
        for (place.y = 0; place.y < size.y; ++place.y)
            for (place.x = 0; place.x < size.x; ++place.x)
                if (here(place))
                    squared[index(size, place)] = 0.0f;
    LowerEnvelope envelope;
    std::vector<float> line;
    for (int axis = 0; axis < 3; ++axis) {
        const int n = size[axis];
        const int lead = periodic[static_cast<std::size_t>(axis)] ? n : 0; // a whole image on either side
        Vec3<int> ends = size;
        ends[axis] = 1;
        for (place.z = 0; place.z < ends.z; ++place.z)
            for (place.y = 0; place.y < ends.y; ++place.y)
                for (place.x = 0; place.x < ends.x; ++place.x) {
                    Vec3<int> at = place;
                    line.resize(static_cast<std::size_t>(n + 2 * lead));
                    for (int k = 0; k < n + 2 * lead; ++k) {
                        at[axis] = k % n;
                        line[static_cast<std::size_t>(k)] = squared[index(size, at)];
                    }
                    envelope(line);
                    for (int k = 0; k < n; ++k) {
                        at[axis] = k;
                        squared[index(size, at)] = line[static_cast<std::size_t>(k + lead)];
                    }
                }
    }
    return squared;
}

} // namespace

SolidDistance::SolidDistance(const SolidVoxels& solids, const std::array<bool, 3>& periodic)
    : size_(solids.size()), periodic_(periodic) {
    const auto outside = squared_distance(size_, periodic, [&](const Vec3<int>& c) { return solids.at(c); });
    const auto inside = squared_distance(size_, periodic, [&](const Vec3<int>& c) { return !solids.at(c); });
    distance_.resize(outside.size());
    for (std::size_t k = 0; k < outside.size(); ++k)
        distance_[k] = outside[k] > 0.0f ? std::sqrt(outside[k]) - 0.5f : 0.5f - std::sqrt(inside[k]);
}

double SolidDistance::cell(Vec3<int> place) const {
    for (int a = 0; a < 3; ++a)
        place[a] = periodic_[static_cast<std::size_t>(a)] ? (place[a] % size_[a] + size_[a]) % size_[a]
                                                          : std::clamp(place[a], 0, size_[a] - 1);
    return distance_[index(size_, place)];
}

DistanceValue SolidDistance::at(const Vec3<double>& position) const {
    return trilinear(position - Vec3<double>{0.5, 0.5, 0.5},
                     [&](const Vec3<int>& place) { return cell(place); });
}

} // namespace vesica
