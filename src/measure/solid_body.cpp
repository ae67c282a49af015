#include "measure/solid_body.hpp"

#include "measure/layer_sum.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesica {
namespace {

/// Exact sums of 1, r and r r.
struct Moments {
    ExactSum zeroth;
    std::array<ExactSum, 3> first;
    std::array<ExactSum, 6> second; // xx yy zz xy xz yz
};

constexpr std::array<std::array<int, 2>, 6> pairs = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// Cells and spans of pure colour, about `origin`.
Moments raw_moments(const VesicleSnapshot& vesicle, const Vec3<double>& origin) {
    Moments sums;
    const auto add = [&sums](double share, const Vec3<double>& r) {
        sums.zeroth.add(share);
        for (int a = 0; a < 3; ++a)
            sums.first[static_cast<std::size_t>(a)].add(share * r[a]);
        for (std::size_t p = 0; p < 6; ++p)
            sums.second[p].add(share * r[pairs[p][0]] * r[pairs[p][1]]);
    };
    for (const InterfaceCell& cell : vesicle.cells)
        add(0.5 * (1.0 + cell.phi), cell.position - origin);
    for (const InsideSpan& span : vesicle.inside) {
        const Vec3<double> start =
            Vec3<double>{span.begin + 0.5, span.y + 0.5, span.z + 0.5} + span.rest - origin;
        for (int k = 0; k < span.count; ++k)
            add(1.0, {start.x + k, start.y, start.z});
    }
    return sums;
}

Vec3<double> centre_of(const Moments& sums) {
    const double total = sums.zeroth.value();
    return {sums.first[0].value() / total, sums.first[1].value() / total, sums.first[2].value() / total};
}

/// What the layer adds to the raw sums about `origin`.
Moments layer_excess(const VesicleSnapshot& vesicle, const Vec3<double>& origin, double known_area) {
    const LayerMoments layer = layer_moments(vesicle);
    const double m2 = layer.volume;
    const double m4 = layer.volume_fourth;
    const double coverage = geometry_coverage(vesicle, known_area);
    Moments sums;
    if (std::isnan(coverage))
        return sums;
    for (const InterfaceCell& cell : vesicle.cells) {
        const double dA = geometry_trust(vesicle, cell) * cell.weight * cell.J / coverage;
        if (dA == 0.0)
            continue;
        const Vec3<double> r = foot_point(cell) - origin;
        const double displaced = layer.shift * cell.H0;
        sums.zeroth.add(dA * (m2 * cell.H0 + displaced));
        for (int a = 0; a < 3; ++a) {
            const double q1 = cell.n[a];
            sums.first[static_cast<std::size_t>(a)].add(
                dA * (displaced * r[a] + 0.5 * m2 * (q1 + 2.0 * cell.H0 * r[a]) + 0.25 * m4 * cell.K0 * q1));
        }
        for (std::size_t p = 0; p < 6; ++p) {
            const int a = pairs[p][0];
            const int b = pairs[p][1];
            const double q1 = cell.n[a] * r[b] + r[a] * cell.n[b];
            const double q2 = cell.n[a] * cell.n[b];
            sums.second[p].add(dA * (displaced * r[a] * r[b] + 0.5 * m2 * (q1 + 2.0 * cell.H0 * r[a] * r[b]) +
                                     0.25 * m4 * (2.0 * cell.H0 * q2 + cell.K0 * q1)));
        }
    }
    return sums;
}

} // namespace

SolidBody solid_body(const VesicleSnapshot& vesicle) {
    return solid_body(vesicle, centre_of_mass(vesicle), area(vesicle));
}

SolidBody solid_body(const VesicleSnapshot& vesicle, const Vec3<double>& origin, double known_area) {
    const Moments raw = raw_moments(vesicle, origin);
    const Moments excess = layer_excess(vesicle, origin, known_area);

    const double volume = raw.zeroth.value() - excess.zeroth.value();
    Vec3<double> shift; // from the origin to the corrected centre
    for (int a = 0; a < 3; ++a) {
        const auto i = static_cast<std::size_t>(a);
        shift[a] = (raw.first[i].value() - excess.first[i].value()) / volume;
    }
    std::array<double, 6> second{};
    for (std::size_t p = 0; p < 6; ++p)
        second[p] = raw.second[p].value() - excess.second[p].value() -
                    volume * shift[pairs[p][0]] * shift[pairs[p][1]]; // parallel axes
    return {volume, origin + shift, {second[0], second[1], second[2], second[3], second[4], second[5]}};
}

double volume(const VesicleSnapshot& vesicle) {
    return solid_body(vesicle).volume;
}

Vec3<double> centre_of_mass(const VesicleSnapshot& vesicle) {
    // About a corner of the vesicle's own box, so that a distant one keeps its digits; and not about any one
    // cell, whose place in the list depends on the threads.
    Vec3<double> origin;
    if (!vesicle.cells.empty())
        origin = vesicle.cells.front().position;
    for (const InterfaceCell& cell : vesicle.cells)
        for (int a = 0; a < 3; ++a)
            origin[a] = std::min(origin[a], cell.position[a]);
    return origin + centre_of(raw_moments(vesicle, origin));
}

double reduced_volume(double volume, double area) {
    return 6.0 * std::sqrt(std::numbers::pi) * volume / (area * std::sqrt(area));
}

std::array<double, 3> principal_inertia(const SolidBody& body, double density) {
    const SymmetricTensor& m = body.second;
    Eigen::Matrix3d inertia;
    inertia << m.yy + m.zz, -m.xy, -m.xz, //
        -m.xy, m.xx + m.zz, -m.yz,        //
        -m.xz, -m.yz, m.xx + m.yy;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(density * inertia, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d& values = solver.eigenvalues();
    return {values[0], values[1], values[2]};
}

} // namespace vesica
