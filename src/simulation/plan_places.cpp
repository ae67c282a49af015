#include "simulation/plan_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesica {

namespace {

using Severity = Remark::Severity;

/// What to say of two interfaces this far apart. They are one below zero, overlap below 2/beta and feel each
/// other's stencils below 2/beta + 2; `accepted`: nothing is said from there on.
void judge_gap(const std::string& key, const std::string& who, const char* remedy, double gap, double width,
               double accepted, Remarks& remarks) {
    if (gap > accepted)
        return;
    if (gap < 0.0)
        remarks.push_back(
            {Severity::error, key,
             fmt::format("{} overlap; expected a gap of at least 2/beta + 2 = {:.1f} cells; try {}", who,
                         width + 2.0, remedy)});
    else
        remarks.push_back(
            {Severity::warning, key,
             fmt::format("{} are {:.1f} cells apart, so that their interfaces overlap; expected at least "
                         "2/beta + 2 = {:.1f}; try {}",
                         who, gap, width + 2.0, remedy)});
}

/// From the nearest point of the surface to a plane across an axis, on whose far side the solid begins;
/// negative if it lies beyond. Looked for on the plane, cell by cell.
double gap_to_plane(const Shape& shape, const Vec3<double>& centre, int axis, double place) {
    const double reach = shape.bounding_radius();
    const double away = place - centre[axis];
    if (std::abs(away) > reach + 20.0)
        return std::abs(away) - reach;
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    double gap = std::numeric_limits<double>::infinity();
    for (double u = -reach; u <= reach; u += 1.0)
        for (double v = -reach; v <= reach; v += 1.0) {
            Vec3<double> point = centre;
            point[axis] = place;
            point[first] += u;
            point[second] += v;
            gap = std::min(gap, shape.signed_distance(point));
        }
    return gap;
}

void judge_ends(const Parameters& parameters, std::size_t vesicle, const Shape& shape, double width,
                double accepted, Remarks& remarks) {
    const Vec3<double>& centre = parameters.vesicles[vesicle].centre;
    for (int axis = 0; axis < 3; ++axis) {
        if (!parameters.is_bounded(axis))
            continue;
        for (const bool upper : {false, true}) {
            const double place = upper ? parameters.size[axis] : 0.0;
            const std::string key = fmt::format("vesicle[{}].centre", vesicle);
            const std::string who =
                fmt::format("vesicle[{}] and the box's end at {} = {:g}", vesicle, "xyz"[axis], place);
            const double gap = gap_to_plane(shape, centre, axis, place);
            judge_gap(key, who, "another centre or a larger box", gap, width, accepted, remarks);
            const double least = gap_to_open_ends(parameters);
            if (parameters.is_open(axis) && gap < least && gap >= 0.0)
                remarks.push_back(
                    {Severity::error, key,
                     fmt::format("{} are {:.1f} cells apart; expected at least {:.1f}, as inlets and "
                                 "outlets know nothing of membranes; try another centre or a longer box",
                                 who, gap, least)});
        }
    }
}

/// Images that slide past take every place along the flow: what counts is how near they come across it.
void judge_sliding_image(const Parameters& parameters, std::size_t vesicle, const Shape& shape, double width,
                         double accepted, Remarks& remarks) {
    const ShearFlow* const flow = parameters.sliding();
    if (flow == nullptr)
        return;
    const Vec3<double>& centre = parameters.vesicles[vesicle].centre;
    const double half = 0.5 * parameters.size[flow->gradient];
    const double gap = gap_to_plane(shape, centre, flow->gradient, centre[flow->gradient] + half) +
                       gap_to_plane(shape, centre, flow->gradient, centre[flow->gradient] - half);
    judge_gap("lattice.size", fmt::format("vesicle[{}] and its own image that slides past", vesicle),
              "a larger lattice.size", gap, width, accepted, remarks);
}

/// Solids do not slide: there must be none along the faces of a box that does.
void judge_slide(const Parameters& parameters, const SolidVoxels& solids, Remarks& remarks) {
    const ShearFlow* const flow = parameters.sliding();
    if (flow == nullptr)
        return;
    Vec3<int> size = parameters.size;
    const int last = size[flow->gradient] - 1;
    size[flow->gradient] = 1;
    Vec3<int> cell{};
    for (cell.z = 0; cell.z < size.z; ++cell.z)
        for (cell.y = 0; cell.y < size.y; ++cell.y)
            for (cell.x = 0; cell.x < size.x; ++cell.x)
                for (const int end : {0, last}) {
                    Vec3<int> place = cell;
                    place[flow->gradient] = end;
                    if (!solids.at(place))
                        continue;
                    remarks.push_back(
                        {Severity::error, "obstacles",
                         fmt::format("obstacles: cell ({}, {}, {}) at the end of the box is solid; expected "
                                     "fluid there, where flow.shear with lees-edwards lets the images slide "
                                     "past; try with = \"walls\", or obstacles away from both ends of {}",
                                     place.x, place.y, place.z, "xyz"[flow->gradient])});
                    return;
                }
}

/// The smallest distance from a vesicle's surface to the centre of a solid cell, less half a cell; negative
/// where it reaches into one.
void judge_obstacles(const Parameters& parameters, const SolidVoxels& solids, std::size_t vesicle,
                     const Shape& shape, double width, double accepted, Remarks& remarks) {
    const Vec3<double>& centre = parameters.vesicles[vesicle].centre;
    const double reach = shape.bounding_radius() + width + 3.0;
    // Across periodic edges too.
    Vec3<int> low{};
    Vec3<int> high{};
    for (int a = 0; a < 3; ++a) {
        low[a] = static_cast<int>(std::floor(centre[a] - reach));
        high[a] = static_cast<int>(std::ceil(centre[a] + reach));
        if (parameters.is_bounded(a)) {
            low[a] = std::max(0, low[a]);
            high[a] = std::min(parameters.size[a], high[a]);
        }
    }
    const auto home = [&](int place, int axis) {
        const int size = parameters.size[axis];
        return (place % size + size) % size;
    };
    double gap = std::numeric_limits<double>::infinity();
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x)
                if (solids.at({home(x, 0), home(y, 1), home(z, 2)}))
                    gap = std::min(gap, shape.signed_distance({x + 0.5, y + 0.5, z + 0.5}) - 0.5);
    judge_gap(fmt::format("vesicle[{}].centre", vesicle),
              fmt::format("vesicle[{}] and the obstacles", vesicle), "another centre", gap, width, accepted,
              remarks);
}

/// One text of the step serves all membranes.
void judge_forms(const Parameters& parameters, Remarks& remarks) {
    const auto form_of = [&](std::size_t vesicle) {
        return parameters.types[parameters.vesicles[vesicle].type].bending.form.index();
    };
    for (std::size_t k = 1; k < parameters.vesicles.size(); ++k)
        if (form_of(k) != form_of(0)) {
            const std::string& type = parameters.types[parameters.vesicles[k].type].name;
            remarks.push_back(
                {Severity::error, fmt::format("vesicle_type.{}.bending.form", type),
                 fmt::format("vesicle_type.{}.bending.form is another than that of vesicle[0]; expected one "
                             "form for all vesicles of a box; try the other",
                             type)});
            return;
        }
}

void judge_packing(const SuspensionParameters& suspension, double comfortable, Remarks& remarks) {
    if (suspension.gap && *suspension.gap < comfortable)
        remarks.push_back(
            {Severity::note, "suspension.gap",
             fmt::format("suspension.gap is {:g}: below 2/beta + 2 = {:.1f} cells interfaces of neighbours "
                         "overlap from the start, as they do wherever vesicles press together",
                         *suspension.gap, comfortable)});
}

} // namespace

void judge_places(const Case& what, const std::vector<std::unique_ptr<const Shape>>& shapes, const Plan& plan,
                  Remarks& remarks) {
    const Parameters& parameters = what.parameters;
    const double width = plan.interface_width;
    const double comfortable = comfortable_gap(parameters.fluid);
    const std::size_t first_packed = parameters.vesicles.size() - what.packed;
    const auto accepted_by = [&](std::size_t vesicle) {
        if (vesicle < first_packed)
            return comfortable;
        return std::max(0.0, std::min(comfortable, what.suspension->gap.value_or(comfortable)) - 0.2);
    };
    if (what.packed > 0)
        judge_packing(*what.suspension, comfortable, remarks);
    const double reach = width + 3.0;
    const auto& vesicles = parameters.vesicles;
    judge_forms(parameters, remarks);
    const auto gap = [&](std::size_t a, std::size_t b, const Vec3<double>& shift) {
        return gap_between(*shapes[a], vesicles[a].centre, *shapes[b], vesicles[b].centre, shift, reach);
    };
    // A box is the whole of space modulo its edges: every pair meets through 27 images, and each vesicle its
    // own, of which the opposite ones are as far.
    for (std::size_t a = 0; a < shapes.size(); ++a) {
        for (std::size_t b = a; b < shapes.size(); ++b) {
            const double accepted = accepted_by(b);
            double smallest = reach;
            for (int k = -1; k <= 1; ++k)
                for (int j = -1; j <= 1; ++j)
                    for (int i = -1; i <= 1; ++i) {
                        if (a == b && (k * 3 + j) * 3 + i <= 0)
                            continue;
                        if ((i != 0 && parameters.is_bounded(0)) || (j != 0 && parameters.is_bounded(1)) ||
                            (k != 0 && parameters.is_bounded(2)))
                            continue;
                        const Vec3<double> shift{1.0 * i * parameters.size.x, 1.0 * j * parameters.size.y,
                                                 1.0 * k * parameters.size.z};
                        smallest = std::min(smallest, gap(a, b, shift));
                    }
            if (smallest >= reach)
                continue;
            if (a == b)
                judge_gap("lattice.size", fmt::format("vesicle[{}] and its own periodic image", a),
                          "a larger lattice.size", smallest, width, accepted, remarks);
            else
                judge_gap(fmt::format("vesicle[{}].centre", b),
                          fmt::format("vesicle[{}] and vesicle[{}]", a, b),
                          b >= first_packed ? "another suspension.seed" : "other centres", smallest, width,
                          accepted, remarks);
        }
    }
    if (plan.obstacles != nullptr)
        judge_slide(parameters, *plan.obstacles, remarks);
    for (std::size_t a = 0; a < shapes.size(); ++a) {
        const double accepted = accepted_by(a);
        judge_ends(parameters, a, *shapes[a], width, accepted, remarks);
        judge_sliding_image(parameters, a, *shapes[a], width, accepted, remarks);
        if (plan.obstacles != nullptr)
            judge_obstacles(parameters, *plan.obstacles, a, *shapes[a], width, accepted, remarks);
    }
    for (std::size_t a = 0; a < plan.different; ++a) {
        const VesiclePlan& vesicle = plan.vesicles[a];
        const double widest = 2.0 * 1.24 * std::sqrt(vesicle.target_area / (4.0 * 3.14159265358979));
        const double edge = 2.0 * vesicle.radius / vesicle.confinement;
        if (vesicle.target_area > 1.001 * vesicle.area && vesicle.target_reduced_volume < 0.95 &&
            widest + width + 2.0 > edge)
            remarks.push_back(
                {Severity::warning, "lattice.size",
                 fmt::format(
                     "lattice.size: the discocyte that vesicle[{}] may become is {:.0f} cells wide and would "
                     "meet its own image; expected a box of at least {:.0f}; try that",
                     a, widest, std::ceil(widest + width + 2.0))});
    }
}

namespace {

void judge_tracers(const Parameters& parameters, const RunParameters& run, const TracerOutput& tracers,
                   Remarks& remarks) {
    if (run.steps > 0 && tracers.start >= run.steps)
        remarks.push_back({Severity::warning, "tracers.start",
                           fmt::format("tracers.start is {}: the run ends before, after {} steps; expected "
                                       "less; try start = 0",
                                       tracers.start, run.steps)});
    double each = 0.0;
    for (const TracerSeeds& seeds : tracers.seeds)
        each += seeds.count;
    const double releases = tracers.release > 0 && run.steps > tracers.start
                                ? 1.0 + std::floor(static_cast<double>(run.steps - tracers.start) /
                                                   static_cast<double>(tracers.release))
                                : 1.0;
    const double all =
        each * releases + 1.0 * tracers.membrane * static_cast<double>(parameters.vesicles.size());
    constexpr double most = 1e6;
    if (all > most)
        remarks.push_back(
            {Severity::error, tracers.release > 0 ? "tracers.release" : "tracers.seeds",
             fmt::format("tracers would be {:.3g} points in the end; expected at most {:g}; try "
                         "fewer seeds, or a longer release",
                         all, most)});
}

} // namespace

void judge_schedule(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                    Remarks& remarks) {
    if (output.tracers)
        judge_tracers(parameters, run, *output.tracers, remarks);
    if (run.stop_when_steady) {
        const SteadyCriterion& steady = *run.stop_when_steady;
        if (output.metrics_every == 0)
            remarks.push_back({Severity::error, "run.stop_when_steady",
                               "run.stop_when_steady is judged from the metrics, and "
                               "output.metrics is missing; try output.metrics = { every = 200 }"});
        else if (steady.over < output.metrics_every)
            remarks.push_back(
                {Severity::error, "run.stop_when_steady.over",
                 fmt::format(
                     "run.stop_when_steady.over is {}; expected at least output.metrics.every, which is {}; "
                     "try over = {}",
                     steady.over, output.metrics_every, 10 * output.metrics_every)});
        bool bends = false;
        for (const VesicleType& type : parameters.types)
            bends = bends || type.bending.modulus > 0.0;
        if (steady.quantity == "bending_energy" && !bends)
            remarks.push_back({Severity::error, "run.stop_when_steady.quantity",
                               "run.stop_when_steady.quantity is bending_energy, and no vesicle "
                               "bends; try \"area\""});
    }
    if (run.wall_time && output.checkpoint_every == 0)
        remarks.push_back({Severity::note, "run.wall_time",
                           "run.wall_time: the checkpoint written when it is used up is the only one; "
                           "output.checkpoint would add others"});
}

} // namespace vesica
