#include "io/case_key_parts.hpp"
#include "io/case_keys.hpp"

#include <fmt/format.h>

namespace vesica {
namespace {

constexpr KeyRange step_count{.low = 0.0, .high = 1e15};

/// Ends that begin to move at once towards or away from the fluid leave an error behind that alternates from
/// cell to cell and is never damped; over some hundred steps hardly any.
constexpr const char* gentle = "200";

void add_times(const std::string& table, std::vector<CaseKey>& keys, const std::string& ramp = "0") {
    keys.push_back({.path = table + "start",
                    .kind = KeyKind::steps,
                    .meaning = "when it begins",
                    .default_value = "0",
                    .dimension = dimension::time,
                    .range = step_count});
    keys.push_back({.path = table + "stop",
                    .kind = KeyKind::steps,
                    .meaning = "when it ends; absent: never",
                    .example = "40000",
                    .dimension = dimension::time,
                    .range = step_count});
    keys.push_back(
        {.path = table + "ramp",
         .kind = KeyKind::steps,
         .meaning = "time over which it grows to full strength from its start on, and dies from its end on",
         .default_value = ramp,
         .dimension = dimension::time,
         .range = step_count});
}

CaseKey axis_key(const std::string& path, const std::string& meaning, const std::string& default_value) {
    return {.path = path,
            .kind = KeyKind::choice,
            .meaning = meaning,
            .default_value = default_value,
            .choices = {"x", "y", "z"}};
}

std::vector<CaseKey> obstacle_keys() {
    return {{.path = "obstacles.file",
             .kind = KeyKind::text,
             .meaning = "a closed surface (STL, PLY), or voxels as large as the box, solid where they are "
                        "not zero (VTI, "
                        "HDF5, raw bytes with x fastest); relative to the case file",
             .example = "\"channel.stl\"",
             .need = Need::required},
            {.path = "obstacles.dataset",
             .kind = KeyKind::text,
             .meaning = "which array of a file of voxels; empty where there is only one",
             .default_value = "\"\""},
            {.path = "obstacles.solid",
             .kind = KeyKind::choice,
             .meaning = "which side of a surface",
             .default_value = "\"inside\"",
             .choices = {"inside", "outside"}},
            {.path = "obstacles.scale",
             .kind = KeyKind::number,
             .meaning = "cells per unit of a surface's file",
             .default_value = "1.0",
             .range = {.low = 0.0, .low_open = true}},
            {.path = "obstacles.position",
             .kind = KeyKind::point,
             .meaning = "of the origin of a surface's file",
             .default_value = "[0, 0, 0]",
             .dimension = dimension::length}};
}

} // namespace

std::vector<CaseKey> detail::flow_keys() {
    std::vector<CaseKey> keys;
    for (const std::string axis : {"x", "y", "z"})
        for (const std::string side : {"lower", "upper"}) {
            const std::string table = "boundary." + axis + "." + side + ".";
            keys.push_back({.path = table + "type",
                            .kind = KeyKind::choice,
                            .meaning = "what the box ends with there",
                            .example = "\"wall\"",
                            .need = Need::required,
                            .choices = {"wall", "inlet", "outlet"}});
            keys.push_back(
                {.path = table + "velocity",
                 .kind = KeyKind::point,
                 .meaning =
                     "of a wall, along itself; of the fluid that enters, straight into the box: its mean",
                 .default_value = "[0, 0, 0]",
                 .dimension = dimension::velocity,
                 .condition = {"type", {"wall", "inlet"}}});
            keys.push_back(
                {.path = table + "profile",
                 .kind = KeyKind::choice,
                 .meaning = "of the fluid that enters: the same everywhere, or a parabola between walls",
                 .default_value = "\"uniform\"",
                 .choices = {"uniform", "parabolic"},
                 .condition = {"type", {"inlet"}}});
            add_times(table, keys);
            for (auto key = keys.end() - 3; key != keys.end(); ++key)
                key->condition = {"type", {"wall", "inlet"}};
            CaseKey& ramp = keys.back();
            ramp.default_value.clear();
            ramp.example = gentle;
            ramp.meaning += fmt::format("; absent: 0 of a wall, {} steps of what enters", gentle);
            keys.push_back({.path = table + "pressure",
                            .kind = KeyKind::number,
                            .meaning = "where the fluid leaves, above that of the fluid at rest",
                            .default_value = "0.0",
                            .dimension = dimension::pressure,
                            .range = {.low = -0.1, .high = 0.1},
                            .condition = {"type", {"outlet"}}});
        }
    keys.push_back(
        {.path = "boundary.wetting",
         .kind = KeyKind::number,
         .meaning = "force per volume on inner fluid in the cells beside a solid, towards it; below 0 solids "
                    "repel vesicles, and nothing sticks to them",
         .default_value = "-0.005",
         .range = {.low = -0.05, .high = 0.05}});
    for (const CaseKey& key : obstacle_keys())
        keys.push_back(key);
    keys.push_back(
        {.path = "flow.shear.rate",
         .kind = KeyKind::number,
         .meaning = "gamma: the velocity grows by it per length, and is 0 in the middle of the box",
         .example = "5e-4",
         .need = Need::required,
         .dimension = dimension::rate,
         .range = {.low = -1.0, .high = 1.0}});
    keys.push_back(axis_key("flow.shear.velocity", "the axis the fluid moves along", "\"x\""));
    keys.push_back(axis_key("flow.shear.gradient", "the axis the velocity changes along", "\"z\""));
    keys.push_back(
        {.path = "flow.shear.with",
         .kind = KeyKind::choice,
         .meaning =
             "what drives it: walls at both ends of the gradient's axis, moving against each other, or, "
             "without any walls, the box's own periodic images that slide past it",
         .default_value = "\"walls\"",
         .choices = {"walls", "lees-edwards"}});
    add_times("flow.shear.", keys);
    keys.push_back({.path = "flow.poiseuille.mean_velocity",
                    .kind = KeyKind::number,
                    .meaning = "of the fluid alone between the walls that the boundary has",
                    .example = "0.01",
                    .need = Need::one_of,
                    .group = "the strength of the flow",
                    .dimension = dimension::velocity,
                    .range = {.low = -1.0, .high = 1.0}});
    keys.push_back({.path = "flow.poiseuille.pressure_gradient",
                    .kind = KeyKind::number,
                    .meaning = "-dp/dx, by which the pressure falls along the flow: a force on every cell",
                    .example = "1e-6",
                    .need = Need::one_of,
                    .group = "the strength of the flow",
                    .dimension = dimension::force_density,
                    .range = {.low = -1.0, .high = 1.0}});
    keys.push_back(axis_key("flow.poiseuille.velocity", "the axis the fluid moves along", "\"x\""));
    add_times("flow.poiseuille.", keys);
    keys.push_back(
        {.path = "flow.extension.rate",
         .kind = KeyKind::number,
         .meaning =
             "of a plane extension about the middle of the box, whose ends move with it along both axes",
         .example = "1e-4",
         .need = Need::required,
         .dimension = dimension::rate,
         .range = {.low = -1.0, .high = 1.0}});
    keys.push_back(axis_key("flow.extension.stretch", "the axis along which the fluid leaves", "\"x\""));
    keys.push_back(axis_key("flow.extension.squeeze", "the axis along which it comes", "\"z\""));
    add_times("flow.extension.", keys, gentle);
    keys.push_back({.path = "flow.body_force.force",
                    .kind = KeyKind::point,
                    .meaning = "per volume, on every cell",
                    .example = "[1e-6, 0, 0]",
                    .need = Need::required,
                    .dimension = dimension::force_density,
                    .range = {.low = -1.0, .high = 1.0}});
    add_times("flow.body_force.", keys);
    return keys;
}

} // namespace vesica
