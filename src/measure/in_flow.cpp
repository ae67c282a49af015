#include "measure/in_flow.hpp"

#include "measure/diameter.hpp"
#include "measure/layer_sum.hpp"
#include "measure/solid_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesica {
namespace {

constexpr double pi = std::numbers::pi;

Vec3<double> cross(const Vec3<double>& a, const Vec3<double>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace

double tank_treading_frequency(const VesicleSnapshot& vesicle, const ShearPlane& plane) {
    // A slab about the plane through the centre, of weight 1 there and 0 two cells away: layers of cells have
    // the same weight together wherever the centre lies between them.
    constexpr double half_slab = 2.0;
    constexpr std::size_t bins = 36;
    struct Arc {
        double weight = 0.0;
        double flux = 0.0;
    };
    std::array<Arc, bins> arcs{};
    const Vec3<double> axis = cross(plane.gradient, plane.flow); // the shear turns about it
    const Vec3<double> centre = centre_of_mass(vesicle);
    const Vec3<double> velocity = (1.0 / vesicle.colour_mass) * vesicle.momentum;
    for (const InterfaceCell& cell : vesicle.cells) {
        const Vec3<double> r = cell.position - centre;
        const double in_slab = 1.0 - std::abs(dot(r, axis)) / half_slab;
        if (!cell.has_geometry || in_slab <= 0.0)
            continue;
        const double angle = std::atan2(dot(r, plane.gradient), dot(r, plane.flow)) + pi;
        Arc& arc = arcs[std::min(bins - 1, static_cast<std::size_t>(angle / (2.0 * pi) * bins))];
        arc.weight += in_slab * cell.weight;
        arc.flux += in_slab * cell.weight * dot(cell.u - velocity, cross(axis, cell.n));
    }
    double period = 0.0;
    int sense = 0;
    for (const Arc& arc : arcs) {
        if (arc.weight <= 0.0 || arc.flux == 0.0)
            return std::numeric_limits<double>::quiet_NaN();
        const int here = arc.flux > 0.0 ? 1 : -1;
        if (sense != 0 && here != sense)
            return std::numeric_limits<double>::quiet_NaN();
        sense = here;
        const double length = arc.weight / half_slab;
        period += length / (std::abs(arc.flux) / arc.weight);
    }
    return sense * 2.0 * pi / period;
}

double particle_stress(const VesicleSnapshot& vesicle, const ShearPlane& plane, double outer_viscosity) {
    const Vec3<double> centre = centre_of_mass(vesicle);
    // By parts: the viscosity's gradient times the velocity, whatever the viscosity does across the layer.
    // Its inverse is linear in the fraction of red, whose own gradient is the cell's weight.
    const double inner_viscosity = vesicle.viscosity_ratio * outer_viscosity;
    const double slope = 1.0 / outer_viscosity - 1.0 / inner_viscosity;
    double sum = 0.0;
    for (const InterfaceCell& cell : vesicle.cells) {
        const Vec3<double> r = cell.position - centre;
        const auto both = [&](const Vec3<double>& a, const Vec3<double>& b) {
            return dot(a, plane.flow) * dot(b, plane.gradient) + dot(a, plane.gradient) * dot(b, plane.flow);
        };
        sum -= 0.5 * both(cell.force, r);
        if (cell.has_geometry && slope != 0.0) {
            const double viscosity = 1.0 / (1.0 / outer_viscosity - 0.5 * (1.0 + cell.phi) * slope);
            sum += viscosity * viscosity * slope * cell.weight * both(cell.u, cell.n);
        }
    }
    return sum;
}

double distance_to_walls(const VesicleSnapshot& vesicle, const Snapshot& snapshot) {
    double gap = std::numeric_limits<double>::infinity();
    for (const Vec3<double>& point : surface_points(vesicle))
        for (int a = 0; a < 3; ++a)
            if (snapshot.walls[a])
                gap = std::min({gap, point[a], snapshot.size[a] - point[a]});
    return gap;
}

} // namespace vesica
