#include "io/case_resolver.hpp"

namespace vesica {
namespace {

using detail::Resolver;

const char* axis_name(int axis) {
    return axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

void write_times(Resolver& out, const FlowTimes& times) {
    out.steps("start", times.start);
    if (times.stop != FlowTimes::never)
        out.steps("stop", times.stop);
    out.steps("ramp", times.ramp);
}

void write_open(Resolver& out, const OpenEnds& open, int axis) {
    const std::string table = fmt::format("boundary.{}.", axis_name(axis));
    const std::string inlet = table + (open.enters_below ? "lower" : "upper");
    const std::string outlet = table + (open.enters_below ? "upper" : "lower");
    out.header("[" + inlet + "]", inlet);
    out.text("type", "inlet");
    Vec3<double> velocity{};
    velocity[axis] = open.enters_below ? open.velocity : -open.velocity;
    out.point("velocity", velocity);
    out.text("profile", open.parabolic ? "parabolic" : "uniform");
    write_times(out, open.times);
    out.header("[" + outlet + "]", outlet);
    out.text("type", "outlet");
    out.number("pressure", open.outlet_pressure);
}

} // namespace

void detail::write_boundary(Resolver& out, const Parameters& parameters) {
    out.header("[boundary]", "boundary");
    out.number("wetting", parameters.wetting);
    for (int axis = 0; axis < 3; ++axis) {
        const auto* walls = std::get_if<WallEnds>(&parameters.ends[static_cast<std::size_t>(axis)]);
        if (const auto* open = std::get_if<OpenEnds>(&parameters.ends[static_cast<std::size_t>(axis)]))
            write_open(out, *open, axis);
        const bool of_flow =
            (parameters.flow.shear && parameters.flow.shear->gradient == axis) || parameters.flow.extension;
        if (walls == nullptr || of_flow)
            continue;
        for (const auto& [side, velocity, times] :
             {std::tuple("lower", walls->lower_velocity, walls->lower_times),
              std::tuple("upper", walls->upper_velocity, walls->upper_times)}) {
            const std::string path = fmt::format("boundary.{}.{}", axis_name(axis), side);
            out.header("[" + path + "]", path);
            out.text("type", "wall");
            out.point("velocity", velocity);
            if (velocity != Vec3<double>{})
                write_times(out, times);
        }
    }
}

void detail::write_obstacles(Resolver& out, const ObstacleParameters& obstacles) {
    out.header("[obstacles]", "obstacles");
    out.text("file", obstacles.file);
    if (obstacles.mesh == nullptr) {
        out.text("dataset", obstacles.dataset);
        return;
    }
    out.text("solid", obstacles.solid_inside ? "inside" : "outside");
    out.number("scale", obstacles.scale);
    out.point("position", obstacles.position);
}

void detail::write_flow(Resolver& out, const FlowParameters& flow) {
    if (flow.shear) {
        out.header("[flow.shear]", "flow.shear");
        out.number("rate", flow.shear->rate);
        out.text("velocity", axis_name(flow.shear->velocity));
        out.text("gradient", axis_name(flow.shear->gradient));
        out.text("with", flow.shear->with == ShearBy::walls ? "walls" : "lees-edwards");
        write_times(out, flow.shear->times);
    }
    if (flow.poiseuille) {
        out.header("[flow.poiseuille]", "flow.poiseuille");
        if (flow.poiseuille->mean_velocity)
            out.number("mean_velocity", *flow.poiseuille->mean_velocity);
        else
            out.number("pressure_gradient", flow.poiseuille->pressure_gradient);
        out.text("velocity", axis_name(flow.poiseuille->velocity));
        write_times(out, flow.poiseuille->times);
    }
    if (flow.extension) {
        out.header("[flow.extension]", "flow.extension");
        out.number("rate", flow.extension->rate);
        out.text("stretch", axis_name(flow.extension->stretch));
        out.text("squeeze", axis_name(flow.extension->squeeze));
        write_times(out, flow.extension->times);
    }
    if (flow.body_force) {
        out.header("[flow.body_force]", "flow.body_force");
        out.point("force", flow.body_force->force);
        write_times(out, flow.body_force->times);
    }
}

} // namespace vesica
