#pragma once

#include "core/vec3.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>

/// What drives the fluid, and what bounds it, in lattice units.
namespace vesica {

/// When a flow is driven: it grows from `start` on and dies from `stop` on, each over `ramp` steps.
struct FlowTimes {
    static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

    std::int64_t start = 0;
    std::int64_t stop = never;
    std::int64_t ramp = 0;

    /// The share of its full strength that is felt in the step that leads from `step` to the next.
    double strength(std::int64_t step) const {
        const auto passed = [&](std::int64_t since) {
            if (step < since)
                return 0.0;
            return ramp == 0 ? 1.0
                             : std::min(1.0, static_cast<double>(step - since) / static_cast<double>(ramp));
        };
        return std::max(0.0, passed(start) - passed(stop));
    }

    /// The sum of the strengths of all steps before this one.
    double total(std::int64_t step) const {
        const auto passed = [&](std::int64_t since) {
            if (step <= since)
                return 0.0;
            const auto n = static_cast<double>(step - since);
            const auto r = static_cast<double>(ramp);
            if (n <= r)
                return 0.5 * n * (n - 1.0) / r;
            return n - r + (ramp > 0 ? 0.5 * (r - 1.0) : 0.0);
        };
        return passed(start) - passed(stop);
    }

    friend bool operator==(const FlowTimes&, const FlowTimes&) = default;
};

/// The ends of an axis are joined.
struct PeriodicEnds {
    friend bool operator==(const PeriodicEnds&, const PeriodicEnds&) = default;
};
/// The fluid ends at impermeable walls to which it sticks, at 0 and at the box's size.
struct WallEnds {
    Vec3<double> lower_velocity{}; ///< along the wall, cells/step
    Vec3<double> upper_velocity{};
    FlowTimes lower_times{}; ///< of each velocity
    FlowTimes upper_times{};

    friend bool operator==(const WallEnds&, const WallEnds&) = default;
};
/// The fluid enters at one end with a velocity and leaves at the other against a pressure.
struct OpenEnds {
    bool enters_below = true;     ///< at 0
    double velocity = 0.0;        ///< mean, into the box, cells/step
    bool parabolic = false;       ///< between the walls of the other axes; uniform otherwise
    double outlet_pressure = 0.0; ///< above that of the fluid at rest
    FlowTimes times;

    friend bool operator==(const OpenEnds&, const OpenEnds&) = default;
};
using AxisEnds = std::variant<PeriodicEnds, WallEnds, OpenEnds>;

/// What drives a shear: walls that move against each other, or the box's own images that slide past it
/// (Lees-Edwards).
enum class ShearBy { walls, lees_edwards };

/// u = rate (x_gradient - middle) along `velocity`.
struct ShearFlow {
    double rate = 0.0; ///< 1/steps
    int velocity = 0;  ///< axis
    int gradient = 2;  ///< axis
    FlowTimes times;
    ShearBy with = ShearBy::walls;

    friend bool operator==(const ShearFlow&, const ShearFlow&) = default;
};

/// A pressure that falls along an axis, as a force on every cell.
struct PoiseuilleFlow {
    double pressure_gradient = 0.0;      ///< -dp/dx: force per volume
    std::optional<double> mean_velocity; ///< of the channel without vesicles, if the case states it
    int velocity = 0;                    ///< axis
    FlowTimes times;

    friend bool operator==(const PoiseuilleFlow&, const PoiseuilleFlow&) = default;
};

/// The same force per volume everywhere.
struct BodyForce {
    Vec3<double> force{};
    FlowTimes times;

    friend bool operator==(const BodyForce&, const BodyForce&) = default;
};

/// u = rate ((x_stretch - middle) along `stretch` - (x_squeeze - middle) along `squeeze`), as the box's ends
/// of both axes move.
struct ExtensionFlow {
    double rate = 0.0; ///< 1/steps
    int stretch = 0;   ///< axis
    int squeeze = 2;   ///< axis
    FlowTimes times;

    friend bool operator==(const ExtensionFlow&, const ExtensionFlow&) = default;
};

struct FlowParameters {
    std::optional<ShearFlow> shear;
    std::optional<PoiseuilleFlow> poiseuille;
    std::optional<BodyForce> body_force;
    std::optional<ExtensionFlow> extension;

    bool any() const { return shear || poiseuille || body_force || extension; }

    friend bool operator==(const FlowParameters&, const FlowParameters&) = default;
};

} // namespace vesica
