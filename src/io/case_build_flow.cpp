#include "io/case_build_flow.hpp"

#include "case/triangle_mesh.hpp"
#include "io/mesh_file.hpp"
#include "io/voxel_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace vesica {
namespace {

/// What enters too suddenly leaves an error behind that is never damped.
constexpr std::int64_t gentle_steps = 200;

int axis_of(const std::string& name) {
    return name == "x" ? 0 : name == "y" ? 1 : 2;
}

const char* axis_name(int axis) {
    return axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

/// `gentle` is the ramp of an end that does not say it.
FlowTimes read_times(const CaseValues& values, const std::string& table, std::int64_t gentle = 0) {
    FlowTimes times;
    times.start = values.integer(table + ".start");
    times.ramp = values.find(table + ".ramp") ? values.integer(table + ".ramp") : gentle;
    if (values.find(table + ".stop")) {
        times.stop = values.integer(table + ".stop");
        if (times.stop < times.start)
            values.refuse(table + ".stop",
                          fmt::format("expected at least {}.start, which is {}; try stop = {}", table,
                                      times.start, times.start + 10000));
    }
    return times;
}

Vec3<double> read_point(const CaseValues& values, const std::string& path) {
    return {values.number(path, 0), values.number(path, 1), values.number(path, 2)};
}

Vec3<double> read_wall(const CaseValues& values, const std::string& side, int axis) {
    const Vec3<double> velocity = read_point(values, side + ".velocity");
    if (velocity[axis] != 0.0)
        values.refuse(side + ".velocity",
                      fmt::format("expected a velocity along the wall, 0 along {}; try velocity = [0, 0, 0]",
                                  axis_name(axis)));
    return velocity;
}

/// One end lets the fluid in and the other lets it out.
OpenEnds read_open(const CaseValues& values, const std::string& inlet, const std::string& outlet, int axis,
                   bool enters_below) {
    OpenEnds ends;
    ends.enters_below = enters_below;
    const Vec3<double> velocity = read_point(values, inlet + ".velocity");
    ends.velocity = enters_below ? velocity[axis] : -velocity[axis];
    if (!(ends.velocity > 0.0) || norm(velocity) > ends.velocity)
        values.refuse(inlet + ".velocity",
                      fmt::format("expected a velocity straight into the box; try velocity = [{}, {}, {}]",
                                  axis == 0 ? (enters_below ? "0.01" : "-0.01") : "0",
                                  axis == 1 ? (enters_below ? "0.01" : "-0.01") : "0",
                                  axis == 2 ? (enters_below ? "0.01" : "-0.01") : "0"));
    ends.parabolic = values.text(inlet + ".profile") == "parabolic";
    ends.times = read_times(values, inlet, gentle_steps);
    ends.outlet_pressure = values.number(outlet + ".pressure");
    return ends;
}

void read_ends(const CaseValues& values, int axis, Parameters& parameters) {
    const std::string table = fmt::format("boundary.{}", axis_name(axis));
    const std::string lower = table + ".lower";
    const std::string upper = table + ".upper";
    const bool has_lower = values.has_table(lower);
    const bool has_upper = values.has_table(upper);
    if (!has_lower && !has_upper)
        return;
    const std::string& there = has_lower ? lower : upper;
    const std::string& type = values.text(there + ".type");
    const std::string partner = type == "wall" ? "wall" : type == "inlet" ? "outlet" : "inlet";
    if (has_lower != has_upper)
        values.refuse(
            has_lower ? upper : lower,
            fmt::format("expected both ends of the axis, or none where it is periodic, and {} is {} {}; "
                        "try {} = {{ type = \"{}\" }}",
                        there, type == "wall" ? "a" : "an", type, has_lower ? "upper" : "lower", partner));
    if (values.text(upper + ".type") != partner)
        values.refuse(upper + ".type",
                      fmt::format("expected \"{}\", as {} is {} {}; try type = \"{}\"", partner, lower,
                                  type == "wall" ? "a" : "an", type, partner));
    AxisEnds& ends = parameters.ends[static_cast<std::size_t>(axis)];
    if (type == "wall")
        ends = WallEnds{read_wall(values, lower, axis), read_wall(values, upper, axis),
                        read_times(values, lower), read_times(values, upper)};
    else if (type == "inlet")
        ends = read_open(values, lower, upper, axis, true);
    else
        ends = read_open(values, upper, lower, axis, false);
}

/// At most one axis is open: where an inlet meets another end that lets fluid through, nobody knows what
/// enters.
void check_open_axes(const CaseValues& values, const Parameters& parameters) {
    int open = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (!parameters.is_open(axis))
            continue;
        const std::string table = fmt::format("boundary.{}", axis_name(axis));
        if (open >= 0)
            values.refuse(
                table, fmt::format("expected one axis with an inlet and an outlet, and boundary.{} has them "
                                   "already; try walls",
                                   axis_name(open)));
        open = axis;
        const auto& ends = std::get<OpenEnds>(parameters.ends[static_cast<std::size_t>(axis)]);
        const bool walls = parameters.has_walls((axis + 1) % 3) || parameters.has_walls((axis + 2) % 3);
        if (ends.parabolic && !walls)
            values.refuse(
                table + (ends.enters_below ? ".lower" : ".upper") + ".profile",
                "expected walls across another axis, between which the parabola lies; try profile = "
                "\"uniform\"");
    }
}

void read_shear(const CaseValues& values, Parameters& parameters) {
    ShearFlow shear;
    shear.rate = values.number("flow.shear.rate");
    shear.velocity = axis_of(values.text("flow.shear.velocity"));
    shear.gradient = axis_of(values.text("flow.shear.gradient"));
    shear.times = read_times(values, "flow.shear");
    if (shear.velocity == shear.gradient)
        values.refuse(
            values.given("flow.shear.gradient") ? "flow.shear.gradient" : "flow.shear.velocity",
            fmt::format("expected two different axes for velocity and gradient, which are both {}; try "
                        "gradient = \"{}\"",
                        axis_name(shear.gradient), axis_name((shear.velocity + 2) % 3)));
    const bool slides = values.text("flow.shear.with") == "lees-edwards";
    shear.with = slides ? ShearBy::lees_edwards : ShearBy::walls;
    for (int axis = 0; slides && axis < 3; ++axis)
        if (parameters.is_bounded(axis))
            values.refuse(
                "flow.shear.with",
                fmt::format("expected no [boundary.{}] with it: lees-edwards shears a box that is periodic "
                            "along all axes, and whatever stands still at an end would tear where the images "
                            "slide; try with = \"walls\", or remove [boundary.{}]",
                            axis_name(axis), axis_name(axis)));
    constexpr int thinnest = 10; // of what images beyond the faces the band looks at
    if (slides && parameters.size[shear.gradient] < thinnest)
        values.refuse(
            "lattice.size",
            fmt::format("expected at least {} cells along {}, where flow.shear with lees-edwards lets the "
                        "images slide; try {}",
                        thinnest, axis_name(shear.gradient), thinnest));
    for (const int axis : {shear.gradient, shear.velocity})
        if (parameters.is_bounded(axis))
            values.refuse(
                fmt::format("boundary.{}", axis_name(axis)),
                axis == shear.gradient
                    ? "expected nothing there, as flow.shear makes the walls across its gradient; try "
                      "removing one of the two"
                    : "expected no walls across the flow's own axis, along which flow.shear moves the "
                      "fluid; try removing them");
    if (!slides)
        parameters.ends[static_cast<std::size_t>(shear.gradient)] = WallEnds{};
    parameters.flow.shear = shear;
}

void read_extension(const CaseValues& values, Parameters& parameters) {
    ExtensionFlow flow;
    flow.rate = values.number("flow.extension.rate");
    flow.stretch = axis_of(values.text("flow.extension.stretch"));
    flow.squeeze = axis_of(values.text("flow.extension.squeeze"));
    flow.times = read_times(values, "flow.extension");
    if (flow.stretch == flow.squeeze)
        values.refuse(
            values.given("flow.extension.squeeze") ? "flow.extension.squeeze" : "flow.extension.stretch",
            fmt::format("expected two different axes to stretch and to squeeze, which are both {}; try "
                        "squeeze = \"{}\"",
                        axis_name(flow.stretch), axis_name((flow.stretch + 2) % 3)));
    for (const std::string other : {"flow.shear", "flow.poiseuille"})
        if (values.has_table(other))
            values.refuse(
                other, "expected no other flow beside flow.extension, with which all ends of the box move; "
                       "try removing one of the two");
    for (const int axis : {flow.stretch, flow.squeeze}) {
        if (parameters.is_bounded(axis))
            values.refuse(
                fmt::format("boundary.{}", axis_name(axis)),
                "expected nothing there, as flow.extension moves the ends of that axis; try removing one of "
                "the two");
        parameters.ends[static_cast<std::size_t>(axis)] = WallEnds{};
    }
    parameters.flow.extension = flow;
}

void read_poiseuille(const CaseValues& values, Parameters& parameters) {
    PoiseuilleFlow flow;
    flow.velocity = axis_of(values.text("flow.poiseuille.velocity"));
    flow.times = read_times(values, "flow.poiseuille");
    if (parameters.is_bounded(flow.velocity))
        values.refuse(
            "flow.poiseuille.velocity",
            fmt::format("expected an axis without walls; try velocity = \"{}\"",
                        axis_name(parameters.has_walls((flow.velocity + 1) % 3) ? (flow.velocity + 2) % 3
                                                                                : (flow.velocity + 1) % 3)));
    double across[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int k = 0; k < 2; ++k)
        if (const int axis = (flow.velocity + 1 + k) % 3; parameters.has_walls(axis))
            across[k] = parameters.size[axis];
    const bool obstructed = parameters.obstacles.has_value();
    const double narrow = std::min(across[0], across[1]);
    const double wide = std::max(across[0], across[1]);
    if (obstructed && values.find("flow.poiseuille.mean_velocity"))
        values.refuse("flow.poiseuille.mean_velocity", "expected a pressure_gradient beside [obstacles], as "
                                                       "nobody knows which one drives that velocity; try "
                                                       "pressure_gradient = 1e-6");
    if (std::isinf(narrow) && obstructed) {
        flow.pressure_gradient = values.number("flow.poiseuille.pressure_gradient");
        parameters.flow.poiseuille = flow;
        return;
    }
    if (std::isinf(narrow))
        values.refuse(
            "flow.poiseuille",
            "expected walls that hold the fluid, without which it would grow faster for ever; try "
            "[boundary.z] lower = { type = \"wall\" }, upper = { type = \"wall\" }, or flow.body_force");
    const double viscosity = parameters.fluid.density * parameters.fluid.kinematic_viscosity;
    const double mean_per_gradient = mean_velocity_of_duct(narrow, wide, viscosity);
    if (values.find("flow.poiseuille.mean_velocity")) {
        flow.mean_velocity = values.number("flow.poiseuille.mean_velocity");
        flow.pressure_gradient = *flow.mean_velocity / mean_per_gradient;
    } else {
        flow.pressure_gradient = values.number("flow.poiseuille.pressure_gradient");
    }
    parameters.flow.poiseuille = flow;
}

} // namespace

std::optional<ObstacleParameters> build_obstacles(const CaseValues& values, const Vec3<int>& size,
                                                  const std::filesystem::path& folder) {
    if (!values.has_table("obstacles"))
        return std::nullopt;
    const std::string path = "obstacles.file";
    ObstacleParameters obstacles;
    obstacles.file = values.text(path);
    obstacles.dataset = values.text("obstacles.dataset");
    obstacles.solid_inside = values.text("obstacles.solid") == "inside";
    obstacles.scale = values.number("obstacles.scale");
    obstacles.position = read_point(values, "obstacles.position");
    const std::filesystem::path file = folder / obstacles.file;
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const bool surface = ending == ".stl" || ending == ".ply";
    for (const std::string key : {"obstacles.solid", "obstacles.scale", "obstacles.position"})
        if (!surface && values.given(key))
            values.refuse(key,
                          "expected that only of a surface (STL, PLY), and obstacles.file holds voxels; try "
                          "removing it");
    if (surface && values.given("obstacles.dataset"))
        values.refuse("obstacles.dataset",
                      "expected that only of voxels, and obstacles.file is a surface; try removing it");
    try {
        if (surface)
            obstacles.mesh = std::make_shared<const TriangleMesh>(read_triangle_mesh(file));
        else
            obstacles.voxels =
                std::make_shared<const SolidVoxels>(read_voxels(file, size, obstacles.dataset));
    } catch (const InputError& error) {
        values.refuse(path, std::string("expected a file of solids that can be read; ") + error.what());
    }
    return obstacles;
}

double mean_velocity_of_duct(double height, double width, double viscosity) {
    const double plane = height * height / (12.0 * viscosity);
    if (std::isinf(width))
        return plane;
    constexpr double pi = std::numbers::pi;
    double sum = 0.0;
    for (int n = 1; n < 200; n += 2)
        sum += std::tanh(0.5 * n * pi * width / height) / std::pow(n, 5);
    return plane * (1.0 - 192.0 * height / (std::pow(pi, 5) * width) * sum);
}

void build_flow(const CaseValues& values, Parameters& parameters) {
    parameters.wetting = values.number("boundary.wetting");
    for (int axis = 0; axis < 3; ++axis)
        read_ends(values, axis, parameters);
    check_open_axes(values, parameters);
    if (values.has_table("flow.extension"))
        read_extension(values, parameters);
    if (values.has_table("flow.shear"))
        read_shear(values, parameters);
    if (values.has_table("flow.poiseuille"))
        read_poiseuille(values, parameters);
    if (values.has_table("flow.body_force"))
        parameters.flow.body_force =
            BodyForce{read_point(values, "flow.body_force.force"), read_times(values, "flow.body_force")};
}

} // namespace vesica
