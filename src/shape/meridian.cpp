#include "shape/meridian.hpp"

#include "shape/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vesica {
namespace {

constexpr int points_per_block = 32;

std::vector<MeridianPoint> sample(const Meridian::Curve& curve, double length, int pieces) {
    std::vector<MeridianPoint> points;
    points.reserve(static_cast<std::size_t>(pieces) + 1);
    for (int i = 0; i <= pieces; ++i)
        points.push_back(curve(length * i / pieces));
    return points;
}

/// Coefficients in u in [0, 1] of the quintic with the values and two derivatives of both ends.
void hermite(double (&c)[6], double h, double p0, double d0, double s0, double p1, double d1, double s1) {
    const double rise = p1 - p0;
    const double v0 = h * d0, v1 = h * d1, a0 = h * h * s0, a1 = h * h * s1;
    c[0] = p0;
    c[1] = v0;
    c[2] = a0 / 2.0;
    c[3] = 10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1;
    c[4] = -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1;
    c[5] = 6.0 * rise - 3.0 * v0 - 3.0 * v1 - 0.5 * a0 + 0.5 * a1;
}

double squared(double x) {
    return x * x;
}

} // namespace

double MeridianPoint::speed() const {
    return std::hypot(dr, dz);
}

double MeridianPoint::meridional_curvature() const {
    const double v = speed();
    return (dz * ddr - dr * ddz) / (v * v * v);
}

double MeridianPoint::azimuthal_curvature() const {
    if (std::abs(r) < 1e-6 * speed())
        return meridional_curvature();
    return -dz / (r * speed());
}

Meridian::Meridian(const Curve& curve, double length, int pieces)
    : Meridian(sample(curve, length, pieces), length) {}

Meridian::Meridian(std::vector<MeridianPoint> points, double length)
    : points_(std::move(points)), length_(length), step_(length / static_cast<double>(points_.size() - 1)) {
    points_.front().r = points_.back().r = 0.0;
    pieces_.resize(points_.size() - 1);
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const MeridianPoint &a = points_[i], &b = points_[i + 1];
        hermite(pieces_[i].r, step_, a.r, a.dr, a.ddr, b.r, b.dr, b.ddr);
        hermite(pieces_[i].z, step_, a.z, a.dz, a.ddz, b.z, b.dz, b.ddz);
        longest_chord_ = std::max(longest_chord_, std::hypot(b.r - a.r, b.z - a.z));
    }
    for (std::size_t begin = 0; begin < points_.size(); begin += points_per_block) {
        const std::size_t end = std::min(begin + points_per_block, points_.size());
        const MeridianPoint& middle = points_[(begin + end) / 2];
        Block block{middle.r, middle.z, 0.0};
        for (std::size_t i = begin; i < end; ++i)
            block.radius = std::max(block.radius, std::hypot(points_[i].r - block.r, points_[i].z - block.z));
        blocks_.push_back(block);
    }
    integrate();
}

void Meridian::integrate() {
    using std::numbers::pi;
    for (const MeridianSample& s : samples()) {
        const MeridianPoint& p = s.point;
        const double disc = -pi * p.r * p.r * p.dz * s.weight;
        volume_ += disc;
        centre_ += disc * p.z;
        area_ += 2.0 * pi * p.r * p.speed() * s.weight;
    }
    centre_ /= volume_;
    for (const MeridianPoint& p : points_) {
        bounding_radius_ = std::max(bounding_radius_, std::hypot(p.r, p.z));
        largest_curvature_ = std::max(
            {largest_curvature_, std::abs(p.meridional_curvature()), std::abs(p.azimuthal_curvature())});
    }
    bounding_radius_ += longest_chord_ / 2.0;
}

std::vector<MeridianSample> Meridian::samples(int stride) const {
    std::vector<MeridianSample> result;
    for (int begin = 0; begin < pieces(); begin += stride) {
        const int end = std::min(begin + stride, pieces());
        const double width = step_ * (end - begin);
        for (const auto& [x, weight] : gauss_legendre_8())
            result.push_back({at(step_ * begin + width * x), width * weight});
    }
    return result;
}

Meridian Meridian::normalised(double radius) const {
    const double factor = radius / std::cbrt(volume_ * 3.0 / (4.0 * std::numbers::pi));
    std::vector<MeridianPoint> scaled = points_;
    for (MeridianPoint& p : scaled)
        p = {p.r * factor,  (p.z - centre_) * factor, p.dr * factor,
             p.dz * factor, p.ddr * factor,           p.ddz * factor};
    return Meridian(std::move(scaled), length_);
}

MeridianPoint Meridian::evaluate(int piece, double u) const {
    const auto value = [u](const double(&c)[6]) {
        return c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))));
    };
    const auto slope = [u](const double(&c)[6]) {
        return c[1] + u * (2.0 * c[2] + u * (3.0 * c[3] + u * (4.0 * c[4] + u * 5.0 * c[5])));
    };
    const auto bend = [u](const double(&c)[6]) {
        return 2.0 * c[2] + u * (6.0 * c[3] + u * (12.0 * c[4] + u * 20.0 * c[5]));
    };
    const Piece& p = pieces_[static_cast<std::size_t>(piece)];
    return {value(p.r),
            value(p.z),
            slope(p.r) / step_,
            slope(p.z) / step_,
            bend(p.r) / (step_ * step_),
            bend(p.z) / (step_ * step_)};
}

MeridianPoint Meridian::at(double t) const {
    const int piece = std::clamp(static_cast<int>(t / step_), 0, pieces() - 1);
    return evaluate(piece, t / step_ - piece);
}

/// Newton's method for the stationary point of the squared distance next to a sampled point, kept between its
/// neighbours by bisection. Returns the parameter.
double Meridian::refine(double r, double z, int node) const {
    const auto stationarity = [&](const MeridianPoint& p) {
        return (p.r - r) * p.dr + (p.z - z) * p.dz;
    };
    double low = step_ * std::max(node - 1, 0);
    double high = step_ * std::min(node + 1, pieces());
    double t = step_ * node;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const MeridianPoint p = at(t);
        const double f = stationarity(p);
        (f > 0.0 ? high : low) = t;
        const double slope = squared(p.dr) + squared(p.dz) + (p.r - r) * p.ddr + (p.z - z) * p.ddz;
        double next = t - f / slope;
        if (!(slope > 0.0) || next < low || next > high)
            next = 0.5 * (low + high);
        const double change = std::abs(next - t);
        t = next;
        if (change <= 1e-14 * length_)
            break;
    }
    return t;
}

MeridianFoot Meridian::closest(double r, double z) const {
    const auto to_middle = [&](const Block& block) {
        return std::sqrt(squared(block.r - r) + squared(block.z - z));
    };
    double bound = std::numeric_limits<double>::max();
    for (const Block& block : blocks_)
        bound = std::min(bound, to_middle(block) + block.radius);

    // A point of the curve is within half a chord of a sampled one, so every sampled local minimum that is no
    // farther than this beyond the best may lie next to the closest point.
    struct Candidate {
        int node;
        double distance;
    };
    std::vector<Candidate> candidates;
    const int last = pieces();
    const auto squared_distance = [&](int i) {
        const MeridianPoint& p = points_[static_cast<std::size_t>(i)];
        return squared(p.r - r) + squared(p.z - z);
    };
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const Block& block = blocks_[b];
        if (to_middle(block) - block.radius > bound + longest_chord_)
            continue;
        const int begin = static_cast<int>(b) * points_per_block;
        const int end = std::min(begin + points_per_block, last + 1);
        double before = squared_distance(std::max(begin - 1, 0));
        double here = squared_distance(begin);
        for (int i = begin; i < end; ++i) {
            const double after = squared_distance(std::min(i + 1, last));
            if (here <= before && here <= after) {
                const double distance = std::sqrt(here);
                candidates.push_back({i, distance});
                bound = std::min(bound, distance);
            }
            before = here;
            here = after;
        }
    }

    MeridianFoot best;
    double best_distance = std::numeric_limits<double>::max();
    for (const Candidate& candidate : candidates) {
        if (candidate.distance > bound + longest_chord_)
            continue;
        const MeridianPoint p = at(refine(r, z, candidate.node));
        const double distance = std::hypot(r - p.r, z - p.z);
        if (distance >= best_distance)
            continue;
        best_distance = distance;
        const double v = p.speed();
        best.normal_r = -p.dz / v;
        best.normal_z = p.dr / v;
        best.distance = std::copysign(distance, (r - p.r) * best.normal_r + (z - p.z) * best.normal_z);
    }
    return best;
}

} // namespace vesica
