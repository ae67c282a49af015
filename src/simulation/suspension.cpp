#include "simulation/suspension.hpp"

#include "core/input_error.hpp"
#include "shape/packing.hpp"
#include "shape/random_numbers.hpp"
#include "simulation/case_bodies.hpp"
#include "simulation/plan_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesica {

namespace {

constexpr double pi = std::numbers::pi;

Vec3<double> as_numbers(const Vec3<int>& v) {
    return {1.0 * v.x, 1.0 * v.y, 1.0 * v.z};
}

/// The shape about the origin, its z along z.
std::shared_ptr<const Shape> shape_about_origin(const Case& what, VesicleParameters vesicle,
                                                const std::string& path) {
    vesicle.centre = {};
    vesicle.axis = {0.0, 0.0, 1.0};
    return shape_of(what, vesicle, path);
}

/// Directions as the case asks for, drawn one after the other.
std::function<Vec3<double>(RandomNumbers&)> directions(const SuspensionParameters& suspension) {
    const Frame about = Frame::along(suspension.axis);
    // Two independent tilts make an angle whose mean square is the sum of theirs.
    const double tilt = suspension.spread * pi / 180.0 / std::sqrt(2.0);
    switch (suspension.orientation) {
    case PackedOrientation::random:
        return [](RandomNumbers& random) {
            return random.direction();
        };
    case PackedOrientation::aligned:
        return [about](RandomNumbers&) {
            return about.z;
        };
    case PackedOrientation::spread:
        return [about, tilt](RandomNumbers& random) {
            const double a = tilt * random.gaussian();
            const double b = tilt * random.gaussian();
            const double angle = std::hypot(a, b);
            const double share = angle > 0.0 ? std::sin(angle) / angle : 1.0;
            return share * a * about.x + share * b * about.y + std::cos(angle) * about.z;
        };
    }
    return {};
}

/// How far vesicles keep from the ends of an axis.
double end_gap(const Parameters& parameters, int axis, double gap) {
    if (!parameters.is_open(axis))
        return gap;
    return std::max(gap, gap_to_open_ends(parameters) + 0.5);
}

PackingTask task_of(const Case& what, std::shared_ptr<const SolidVoxels> solids, std::size_t count) {
    const SuspensionParameters& suspension = *what.suspension;
    const Parameters& parameters = what.parameters;
    PackingTask task;
    task.size = as_numbers(parameters.size);
    task.begin = as_numbers(suspension.region_begin);
    task.end = as_numbers(suspension.region_end);
    task.gap = suspension.gap.value_or(comfortable_gap(parameters.fluid));
    for (int a = 0; a < 3; ++a) {
        task.periodic[static_cast<std::size_t>(a)] = !parameters.is_bounded(a);
        task.end_gaps[a] = end_gap(parameters, a, task.gap);
    }
    if (solids != nullptr)
        task.solids = std::make_shared<const SolidDistance>(*solids, task.periodic);
    std::vector<const VesicleParameters*> examples; // of each kind
    for (const VesicleParameters& vesicle : parameters.vesicles) {
        const auto same = std::find_if(examples.begin(), examples.end(), [&](const VesicleParameters* other) {
            return other->shape == vesicle.shape && other->radius == vesicle.radius &&
                   other->perturbations == vesicle.perturbations;
        });
        task.fixed.push_back(
            {static_cast<std::size_t>(same - examples.begin()), vesicle.centre, vesicle.axis});
        if (same != examples.end())
            continue;
        examples.push_back(&vesicle);
        task.kinds.push_back(
            shape_about_origin(what, vesicle, fmt::format("vesicle[{}]", task.fixed.size() - 1)));
    }
    task.kind = task.kinds.size();
    task.kinds.push_back(shape_about_origin(what, suspension.vesicle, "suspension"));
    task.count = count;
    task.turning = suspension.orientation == PackedOrientation::random;
    task.first_axis = directions(suspension);
    task.seed = suspension.seed;
    return task;
}

void refuse_gap(const Case& what) {
    const SuspensionParameters& suspension = *what.suspension;
    const Vec3<int>& size = what.parameters.size;
    const double most = 0.5 * std::min({size.x, size.y, size.z});
    if (suspension.gap && *suspension.gap > most)
        throw InputError(what.place("suspension.gap"),
                         fmt::format("suspension.gap is {:g} cells; expected at most {:g}, half of the box's "
                                     "shortest side; try {:.1f}",
                                     *suspension.gap, most, comfortable_gap(what.parameters.fluid)));
}

/// Bodies are not kept from their own images, and of others they see two along an axis.
void refuse_box(const Case& what, const PackingTask& task) {
    const double least = 2.0 * task.kinds[task.kind]->bounding_radius() + task.gap;
    for (int a = 0; a < 3; ++a)
        if (task.periodic[static_cast<std::size_t>(a)] && task.size[a] < least)
            throw InputError(
                what.place("suspension.radius"),
                fmt::format(
                    "suspension.radius is {:g}: a vesicle could meet its own image along {}, where the "
                    "box is {:g} cells long; expected at least {:.0f}; try a larger box or a smaller "
                    "radius",
                    what.suspension->vesicle.radius, "xyz"[a], task.size[a], std::ceil(least)));
}

} // namespace

std::int64_t fluid_cells(const Vec3<int>& begin, const Vec3<int>& end, const SolidVoxels* solids) {
    const Vec3<int> size = end - begin;
    const std::int64_t all = std::int64_t{size.x} * size.y * size.z;
    if (solids == nullptr)
        return all;
    std::int64_t solid = 0;
    for (int z = begin.z; z < end.z; ++z)
        for (int y = begin.y; y < end.y; ++y)
            for (int x = begin.x; x < end.x; ++x)
                solid += solids->at({x, y, z}) ? 1 : 0;
    return all - solid;
}

void pack_suspension(Case& what) {
    if (!what.suspension || what.packed > 0)
        return;
    const SuspensionParameters& suspension = *what.suspension;
    const auto solids = obstacles_of(what);
    const double space =
        static_cast<double>(fluid_cells(suspension.region_begin, suspension.region_end, solids.get()));
    const double radius = suspension.vesicle.radius;
    const double each = 4.0 / 3.0 * pi * radius * radius * radius;
    const auto wanted = [&] {
        return suspension.count ? *suspension.count : std::llround(*suspension.haematocrit * space / each);
    };
    const std::int64_t count = wanted();
    const char* const key = suspension.count ? "suspension.count" : "suspension.haematocrit";
    const std::string given = suspension.count ? fmt::format("{}", *suspension.count)
                                               : fmt::format("{:g}", *suspension.haematocrit);
    if (count < 1)
        throw InputError(what.place(key),
                         fmt::format("{} is {}: less than one vesicle of this radius in the {:.0f} cells of "
                                     "fluid; expected at least {:.3g}; try that, or count = 1",
                                     key, given, space, each / space));
    constexpr std::int64_t most = 4000; // every body looks at every other
    if (count > most || static_cast<double>(count) * each > 0.74 * space)
        throw InputError(what.place(key),
                         fmt::format("{} is {}: {} vesicles, {:.0f} % of the fluid; expected at most {} and "
                                     "74 %, which no packing of spheres exceeds; try a haematocrit of 0.3",
                                     key, given, count, 100.0 * static_cast<double>(count) * each / space,
                                     most));
    refuse_gap(what);
    const PackingTask task = task_of(what, solids, static_cast<std::size_t>(count));
    refuse_box(what, task);
    const PackingResult packed = pack(task);
    if (packed.scale < 1.0) {
        // As many smaller ones fitted; fewer of the full size are at most as dense.
        const double smaller = std::pow(packed.scale, 3);
        const std::string fits =
            suspension.count
                ? fmt::format("no more than about {:.0f}", std::floor(smaller * static_cast<double>(count)))
                : fmt::format("no more than about {:.2f}", smaller * *suspension.haematocrit);
        throw InputError(
            what.place(key),
            fmt::format(
                "{} is {}: {} vesicles with gaps of {:.2f} cells do not fit, at random; expected {}; try "
                "less, a smaller suspension.gap, a larger box, or another suspension.seed",
                key, given, count, task.gap, packed.scale > 0.0 ? fits : "fewer"));
    }
    for (const PackedBody& body : packed.bodies) {
        VesicleParameters vesicle = suspension.vesicle;
        vesicle.centre = body.centre;
        vesicle.axis = body.axis;
        what.places[fmt::format("vesicle[{}]", what.parameters.vesicles.size())] = what.place("suspension");
        what.parameters.vesicles.push_back(vesicle);
    }
    what.packed = packed.bodies.size();
}

} // namespace vesica
