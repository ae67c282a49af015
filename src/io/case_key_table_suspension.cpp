#include "io/case_key_parts.hpp"

namespace vesica::detail {

std::vector<CaseKey> shape_keys(const std::string& table) {
    return {
        {.path = table + ".type",
         .kind = KeyKind::text,
         .meaning = "name of a [vesicle_type.NAME]",
         .example = "\"rbc\"",
         .need = Need::required},
        {.path = table + ".shape",
         .kind = KeyKind::choice,
         .meaning =
             "at the start; discocyte, prolate and stomatocyte are exact minimisers of the bending energy",
         .example = "\"sphere\"",
         .need = Need::required,
         .choices = {"sphere", "spheroid", "discocyte", "prolate", "stomatocyte", "evans-fung", "mesh"}},
        {.path = table + ".aspect",
         .kind = KeyKind::number,
         .meaning = "length along the axis over width",
         .example = "0.5",
         .need = Need::required,
         .range = {.low = 0.02, .high = 50.0},
         .condition = {"shape", {"spheroid"}}},
        {.path = table + ".reduced_volume",
         .kind = KeyKind::number,
         .meaning = "of the exact shape",
         .example = "0.65",
         .need = Need::required,
         .range = {.low = 0.0, .high = 1.0, .low_open = true},
         .reason = "1 being the sphere",
         .condition = {"shape", {"discocyte", "prolate", "stomatocyte"}}},
        {.path = table + ".file",
         .kind = KeyKind::text,
         .meaning = "STL or PLY, closed; relative to the case file",
         .example = "\"cell.stl\"",
         .need = Need::required,
         .condition = {"shape", {"mesh"}}},
    };
}

std::vector<CaseKey> suspension_keys() {
    std::vector<CaseKey> keys = shape_keys("suspension");
    const std::vector<CaseKey> own{
        {.path = "suspension.radius",
         .kind = KeyKind::number,
         .meaning = "of the sphere of equal volume",
         .example = "12",
         .need = Need::required,
         .dimension = dimension::length,
         .range = {.low = 0.0, .low_open = true}},
        {.path = "suspension.haematocrit",
         .kind = KeyKind::number,
         .meaning = "what they fill of the region's fluid",
         .example = "0.2",
         .need = Need::one_of,
         .group = "how many they are",
         .range = {.low = 0.0, .high = 0.6, .low_open = true}},
        {.path = "suspension.count",
         .kind = KeyKind::integer,
         .meaning = "of them",
         .example = "40",
         .need = Need::one_of,
         .group = "how many they are",
         .range = {.low = 1.0, .high = 4000.0}},
        {.path = "suspension.orientation",
         .kind = KeyKind::choice,
         .meaning = "of their axes: all directions alike, turned where that makes room; all along `axis`; or "
                    "about it with an angle of `spread`",
         .default_value = "\"random\"",
         .choices = {"random", "aligned", "spread"}},
        {.path = "suspension.axis",
         .kind = KeyKind::direction,
         .meaning = "of any length",
         .default_value = "[0, 0, 1]",
         .condition = {"orientation", {"aligned", "spread"}}},
        {.path = "suspension.spread",
         .kind = KeyKind::number,
         .meaning = "root mean square angle with the axis, degrees",
         .default_value = "20",
         .range = {.low = 0.0, .high = 60.0, .low_open = true},
         .condition = {"orientation", {"spread"}}},
        {.path = "suspension.gap",
         .kind = KeyKind::number,
         .meaning = "between any two surfaces, and to walls and obstacles; absent: 2/beta + 2 cells, where "
                    "interfaces do not feel each other yet",
         .example = "4",
         .dimension = dimension::length,
         .range = {.low = 0.0, .low_open = true}},
        {.path = "suspension.seed",
         .kind = KeyKind::integer,
         .meaning = "of the random places and directions",
         .default_value = "1",
         .range = {.low = 0.0}},
        {.path = "suspension.region",
         .kind = KeyKind::region,
         .meaning =
             "first cell, and one past the last: the part of the box that they are packed into; absent: "
             "all of it",
         .example = "[[0, 0, 0], [64, 64, 64]]"},
    };
    keys.insert(keys.end(), own.begin(), own.end());
    return keys;
}

} // namespace vesica::detail
