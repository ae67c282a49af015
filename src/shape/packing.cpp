#include "shape/packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vesica {

namespace {

constexpr double tolerance = 0.05; ///< cells that a gap may fall short by in the end
constexpr double margin = 0.2; ///< cells more than asked for: points on a surface miss what lies between them
constexpr double slack = 0.3;  ///< and while bodies grow
constexpr double fastest_growth = 0.01;
constexpr double momentum = 0.5; ///< of a round's displacement that goes on into the next
constexpr int patience = 300;    ///< rounds without progress before everything is shaken
constexpr int most_shakes = 6;

struct Kind {
    DistanceTable table;
    double radius;                  ///< of the bounding sphere
    std::vector<InnerPoint> coarse; ///< points on the surface and within: while bodies grow
    std::vector<InnerPoint> fine;
};

struct Body {
    const Kind* kind;
    Vec3<double> centre;
    Vec3<double> axis;
    Frame frame;
    double scale;
    bool moves;

    // Of what pushes it this round, weighted by how deep it lies.
    double depth = 0.0;
    Vec3<double> push{};
    Vec3<double> turn{};
    // What it did last round.
    Vec3<double> moved{};
    Vec3<double> turned{};

    double radius() const { return scale * kind->radius; }
    Vec3<double> place_of(const Vec3<double>& point) const { return centre + scale * frame.vector(point); }

    void pushed(const Vec3<double>& from_centre, const Vec3<double>& direction, double by) {
        depth += by;
        push = push + (by * by) * direction;
        turn = turn + (by * by) * cross(from_centre, direction);
    }
};

class Crowd {
public:
    explicit Crowd(const PackingTask& task) : task_(task), random_(task.seed) {
        for (const std::shared_ptr<const Shape>& shape : task.kinds) {
            DistanceTable table(*shape, task.gap + 2.0);
            const double radius = shape->bounding_radius();
            std::vector<InnerPoint> coarse = table.points(std::max(2.0, 0.22 * radius));
            std::vector<InnerPoint> fine = table.points(std::max(1.2, 0.1 * radius));
            kinds_.push_back({std::move(table), radius, std::move(coarse), std::move(fine)});
        }
        for (const PackedBody& body : task.fixed)
            bodies_.push_back(
                {&kinds_[body.kind], body.centre, body.axis, Frame::along(body.axis), 1.0, false});
        const Kind& kind = kinds_[task.kind];
        for (std::size_t k = 0; k < task.count; ++k) {
            const Vec3<double> axis = task.first_axis(random_);
            bodies_.push_back({&kind, random_place(), axis, Frame::along(axis), 1.0, true});
        }
    }

    PackingResult grow() {
        double scale = first_scale();
        double milestone = scale; // progress is 1 % of growth, or a tenth of what is still missing
        double least = std::numeric_limits<double>::infinity();
        double done = 0.0;
        int waiting = 0;
        int shakes = 0;
        while (true) {
            fine_ = scale >= 1.0;
            const double deepest = press_all(scale);
            if (deepest < slack)
                done = std::max(done, std::min(scale, 0.999));
            if (fine_ && deepest < tolerance) {
                done = 1.0;
                break;
            }
            make_room();
            scale = std::min(1.0, scale * (1.0 + fastest_growth * std::max(0.0, 1.0 - deepest / slack)));
            if (scale > 1.01 * milestone || (fine_ && deepest < 0.9 * least)) {
                milestone = std::max(milestone, scale);
                least = fine_ ? deepest : least;
                waiting = 0;
            } else if (++waiting > patience) {
                if (++shakes > most_shakes)
                    break;
                if (done == 0.0) { // too large to begin with
                    scale *= 0.8;
                    milestone = scale;
                }
                shake();
                waiting = 0;
            }
        }
        PackingResult result;
        result.scale = done;
        for (const Body& body : bodies_)
            if (body.moves)
                result.bodies.push_back({task_.kind, body.centre, body.axis});
        return result;
    }

private:
    Vec3<double> random_place() {
        Vec3<double> place{};
        for (int attempt = 0; attempt < 1000; ++attempt) {
            for (int a = 0; a < 3; ++a)
                place[a] = task_.begin[a] + random_.uniform() * (task_.end[a] - task_.begin[a]);
            if (task_.solids == nullptr || task_.solids->at(place).distance > task_.gap)
                break;
        }
        return place;
    }

    /// At which a dilute gas of them hardly overlaps.
    double first_scale() const {
        const double radius = kinds_[task_.kind].radius;
        double space = 1.0;
        for (int a = 0; a < 3; ++a)
            space *= task_.end[a] - task_.begin[a];
        const double each = space / static_cast<double>(std::max<std::size_t>(1, task_.count));
        return std::min(1.0, 0.25 * std::cbrt(each) / (radius + 0.5 * task_.gap));
    }

    /// What pushes each body this round; returns how far the worst pair falls short of its gap, in cells.
    double press_all(double scale) {
        for (Body& body : bodies_) {
            if (body.moves)
                body.scale = scale;
            body.depth = 0.0;
            body.push = body.turn = {};
        }
        const double gap = task_.gap * scale + margin;
        double deepest = 0.0;
        for (std::size_t a = 0; a < bodies_.size(); ++a) {
            if (bodies_[a].moves)
                deepest = std::max(deepest, press_on_bounds(bodies_[a], scale));
            for (std::size_t b = a + 1; b < bodies_.size(); ++b)
                if (bodies_[a].moves || bodies_[b].moves)
                    deepest = std::max(deepest, press(bodies_[a], bodies_[b], gap));
        }
        return std::max(0.0, deepest - tolerance);
    }

    void make_room() {
        for (Body& body : bodies_)
            if (body.moves)
                make_room(body);
    }

    void make_room(Body& body) const {
        const double share = body.depth > 0.0 ? 1.0 / body.depth : 0.0;
        body.moved = momentum * body.moved + (0.6 * share) * body.push;
        body.centre = body.centre + body.moved;
        for (int a = 0; a < 3; ++a)
            if (!bounded(a))
                body.centre[a] -= task_.size[a] * std::floor(body.centre[a] / task_.size[a]);
        if (!task_.turning)
            return;
        body.turned = momentum * body.turned + (share / (body.radius() * body.radius())) * body.turn;
        turn_axis(body, cross(body.turned, body.axis));
    }

    static void turn_axis(Body& body, const Vec3<double>& by) {
        const Vec3<double> axis = body.axis + by;
        body.axis = (1.0 / norm(axis)) * axis;
        body.frame = Frame::along(body.axis);
    }

    const std::vector<InnerPoint>& points_of(const Body& body) const {
        return fine_ ? body.kind->fine : body.kind->coarse;
    }

    /// All images of b that come near a.
    double press(Body& a, Body& b, double gap) const {
        const double reach = a.radius() + b.radius() + gap;
        const Vec3<double> between = b.centre - a.centre;
        Vec3<double> nearest{};
        Vec3<double> other{}; ///< the next way round, or none
        for (int axis = 0; axis < 3; ++axis) {
            const double length = task_.size[axis];
            if (!task_.periodic[static_cast<std::size_t>(axis)])
                continue;
            nearest[axis] = -length * std::round(between[axis] / length);
            const double there = between[axis] + nearest[axis];
            if (length - std::abs(there) < reach)
                other[axis] = there > 0.0 ? -length : length;
        }
        double deepest = 0.0;
        for (int way = 0; way < 8; ++way) {
            Vec3<double> shift = nearest;
            bool exists = true;
            for (int axis = 0; axis < 3; ++axis)
                if ((way >> axis & 1) != 0) {
                    exists = exists && other[axis] != 0.0;
                    shift[axis] += other[axis];
                }
            const Vec3<double> d = between + shift;
            if (!exists || dot(d, d) > reach * reach)
                continue;
            deepest = std::max(deepest, press_points(a, b, shift, gap));
            deepest = std::max(deepest, press_points(b, a, -shift, gap));
        }
        return deepest;
    }

    /// Points of a from which a ball that touches a's surface from within lies less than a gap from b,
    /// shifted.
    double press_points(Body& a, Body& b, const Vec3<double>& shift, double gap) const {
        double deepest = 0.0;
        const double near = b.radius() + gap;
        for (const InnerPoint& point : points_of(a)) {
            const Vec3<double> place = a.place_of(point.place);
            const Vec3<double> from_b = place - (b.centre + shift);
            if (dot(from_b, from_b) > near * near)
                continue;
            const DistanceValue found = b.kind->table.at((1.0 / b.scale) * b.frame.components(from_b));
            const double by = gap + a.scale * point.depth - b.scale * found.distance;
            if (by <= 0.0)
                continue;
            const Vec3<double> away = b.frame.vector(found.gradient);
            const double share = a.moves && b.moves ? 0.5 * by : by;
            if (a.moves)
                a.pushed(place - a.centre, away, share);
            if (b.moves)
                b.pushed(from_b, -away, share);
            deepest = std::max(deepest, by);
        }
        return deepest;
    }

    double press_on_bounds(Body& body, double scale) const {
        double deepest = 0.0;
        const auto push = [&](const Vec3<double>& place, const Vec3<double>& away, double by) {
            if (by <= 0.0)
                return;
            body.pushed(place - body.centre, away, by);
            deepest = std::max(deepest, by);
        };
        bool near_plane = false;
        for (int axis = 0; axis < 3; ++axis)
            near_plane = near_plane || (bounded(axis) && std::min(body.centre[axis] - task_.begin[axis],
                                                                  task_.end[axis] - body.centre[axis]) <
                                                             body.radius() + task_.end_gaps[axis] + 1.0);
        const bool near_solid = task_.solids != nullptr &&
                                task_.solids->at(body.centre).distance < body.radius() + task_.gap + 2.0;
        if (!near_plane && !near_solid)
            return 0.0;
        for (const InnerPoint& point : points_of(body)) {
            const Vec3<double> place = body.place_of(point.place);
            const double depth = scale * point.depth;
            for (int axis = 0; near_plane && axis < 3; ++axis) {
                if (!bounded(axis))
                    continue;
                const double gap = task_.end_gaps[axis] * scale + margin + depth;
                Vec3<double> up{};
                up[axis] = 1.0;
                push(place, up, gap - (place[axis] - task_.begin[axis]));
                push(place, -up, gap - (task_.end[axis] - place[axis]));
            }
            if (near_solid) {
                const DistanceValue solid = task_.solids->at(place);
                push(place, solid.gradient, task_.gap * scale + margin + depth - solid.distance);
            }
        }
        return deepest;
    }

    bool bounded(int axis) const {
        return !task_.periodic[static_cast<std::size_t>(axis)] || task_.begin[axis] > 0.0 ||
               task_.end[axis] < task_.size[axis];
    }

    void shake() {
        for (Body& body : bodies_) {
            if (!body.moves)
                continue;
            body.centre = body.centre + (0.1 * body.radius()) * random_.direction();
            if (task_.turning)
                turn_axis(body, 0.3 * random_.direction());
        }
    }

    const PackingTask& task_;
    RandomNumbers random_;
    std::vector<Kind> kinds_;
    std::vector<Body> bodies_;
    bool fine_ = false;
};

} // namespace

PackingResult pack(const PackingTask& task) {
    return Crowd(task).grow();
}

} // namespace vesica
