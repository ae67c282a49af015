#include "simulation/flow_drive.hpp"

#include "lattice/velocity_set.hpp"
#include "shape/mesh_voxels.hpp"

namespace vesica {

namespace {

constexpr int lower_end(int axis) {
    return 1 + 2 * axis;
}
constexpr int upper_end(int axis) {
    return 2 + 2 * axis;
}

} // namespace

std::shared_ptr<const SolidVoxels> solid_voxels(const Parameters& parameters) {
    if (!parameters.obstacles)
        return nullptr;
    const ObstacleParameters& solids = *parameters.obstacles;
    if (solids.voxels != nullptr)
        return solids.voxels;
    return std::make_shared<const SolidVoxels>(
        voxelise(*solids.mesh, parameters.size, solids.scale, solids.position, solids.solid_inside));
}

FlowDrive::FlowDrive(const Parameters& parameters)
    : size_(parameters.size),
      lattice_(parameters.lattice()),
      ends_(parameters.ends),
      flow_(parameters.flow),
      obstacles_(solid_voxels(parameters)),
      has_solids_(parameters.is_bounded() || obstacles_ != nullptr) {}

/// Where the layers of two axes meet, walls count before ends that let fluid through, and then the first
/// axis.
int FlowDrive::wall_of(const Vec3<int>& cell) const {
    for (const bool open : {false, true})
        for (int a = 0; a < 3; ++a)
            if (cell[a] >= size_[a] && is_open(a) == open)
                return cell[a] == size_[a] ? upper_end(a) : lower_end(a);
    return 0;
}

WallLink FlowDrive::link(const Vec3<int>& cell, int direction) const {
    Vec3<int> beyond{};
    Vec3<double> middle{};
    for (int a = 0; a < 3; ++a) {
        const int c = velocity(direction, a);
        beyond[a] = (cell[a] + c + lattice_[a]) % lattice_[a];
        middle[a] = cell[a] + 0.5 + 0.5 * c;
    }
    const int wall = wall_of(beyond);
    return {wall, wall == 0 ? Vec3<double>{} : velocity_of((wall - 1) / 2, wall % 2 == 0, middle)};
}

/// Of an end at full strength.
Vec3<double> FlowDrive::velocity_of(int axis, bool upper, const Vec3<double>& place) const {
    Vec3<double> u{};
    const AxisEnds& ends = ends_[static_cast<std::size_t>(axis)];
    if (const auto* walls = std::get_if<WallEnds>(&ends))
        u = upper ? walls->upper_velocity : walls->lower_velocity;
    if (const auto* open = std::get_if<OpenEnds>(&ends); open != nullptr && open->enters_below != upper)
        u[axis] = (upper ? -1.0 : 1.0) * open->velocity * inlet_profile(axis, place);
    if (flow_.shear && flow_.shear->gradient == axis)
        u[flow_.shear->velocity] = (upper ? 0.5 : -0.5) * flow_.shear->rate * size_[axis];
    if (flow_.extension && (flow_.extension->stretch == axis || flow_.extension->squeeze == axis)) {
        const auto from_middle = [&](int a) {
            return place[a] - 0.5 * size_[a];
        };
        const ExtensionFlow& flow = *flow_.extension;
        u[flow.stretch] = flow.rate * from_middle(flow.stretch);
        u[flow.squeeze] = -flow.rate * from_middle(flow.squeeze);
    }
    return u;
}

/// Over its mean.
double FlowDrive::inlet_profile(int axis, const Vec3<double>& place) const {
    double profile = 1.0;
    if (!std::get<OpenEnds>(ends_[static_cast<std::size_t>(axis)]).parabolic)
        return profile;
    for (int a = 0; a < 3; ++a)
        if (has_walls(a)) {
            const double height = place[a] / size_[a];
            profile *= 6.0 * height * (1.0 - height);
        }
    return profile;
}

const FlowTimes* FlowDrive::times_of(int axis) const {
    if (const auto* open = std::get_if<OpenEnds>(&ends_[static_cast<std::size_t>(axis)]))
        return &open->times;
    if (flow_.shear && flow_.shear->gradient == axis)
        return &flow_.shear->times;
    if (flow_.extension && (flow_.extension->stretch == axis || flow_.extension->squeeze == axis))
        return &flow_.extension->times;
    return nullptr;
}

std::array<WallState, FlowDrive::wall_count> FlowDrive::walls(std::int64_t step) const {
    std::array<WallState, wall_count> states{};
    for (int a = 0; a < 3; ++a) {
        WallState& lower = states[static_cast<std::size_t>(lower_end(a))];
        WallState& upper = states[static_cast<std::size_t>(upper_end(a))];
        if (const FlowTimes* times = times_of(a))
            lower.strength = upper.strength = times->strength(step);
        else if (const auto* walls = std::get_if<WallEnds>(&ends_[static_cast<std::size_t>(a)])) {
            lower.strength = walls->lower_times.strength(step);
            upper.strength = walls->upper_times.strength(step);
        }
        if (const auto* open = std::get_if<OpenEnds>(&ends_[static_cast<std::size_t>(a)])) {
            WallState& outlet = open->enters_below ? upper : lower;
            outlet.open = true;
            outlet.density_deviation = 3.0 * open->outlet_pressure;
        }
    }
    return states;
}

Vec3<double> FlowDrive::body_force(std::int64_t step) const {
    Vec3<double> force{};
    if (flow_.poiseuille)
        force[flow_.poiseuille->velocity] =
            flow_.poiseuille->times.strength(step) * flow_.poiseuille->pressure_gradient;
    if (flow_.body_force)
        force = force + flow_.body_force->times.strength(step) * flow_.body_force->force;
    return force;
}

} // namespace vesica
