#pragma once

#include "boundary/bounce_back.hpp"
#include "case/parameters.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace vesica {

/// The cells of the box that a case's obstacles make solid; null without obstacles. Throws InputError for a
/// surface that is not closed.
std::shared_ptr<const SolidVoxels> solid_voxels(const Parameters& parameters);

/// What drives and bounds a case's fluid, as the engine uses it: ends of the box that stand still, move or
/// let fluid through, and forces that push. Wall 0 stands for obstacles at rest; the lower end of axis a is 1
/// + 2 a and the upper one 2 + 2 a.
class FlowDrive {
public:
    static constexpr int wall_count = 7;

    FlowDrive() = default;
    explicit FlowDrive(const Parameters& parameters);

    bool has_solids() const { return has_solids_; }
    /// Of a cell of the lattice.
    bool is_solid(const Vec3<int>& cell) const {
        return wall_of(cell) != 0 || (obstacles_ != nullptr && obstacles_->at(cell));
    }
    /// Null without obstacles.
    const SolidVoxels* obstacles() const { return obstacles_.get(); }
    /// What the link of a fluid cell in a direction meets, which must be solid.
    WallLink link(const Vec3<int>& cell, int direction) const;

    /// In the step that leads from `step` to the next.
    std::array<WallState, wall_count> walls(std::int64_t step) const;
    /// Per volume, in every cell; without the answer to buoyancy.
    Vec3<double> body_force(std::int64_t step) const;
    /// Of the shear that is driven, along its own plane.
    double shear_rate(std::int64_t step) const {
        return flow_.shear ? flow_.shear->times.strength(step) * flow_.shear->rate : 0.0;
    }

    /// How fast the images above a sliding box move in the step that leads from `step` to the next, and how
    /// far they have moved by then, cells.
    double slide_speed(std::int64_t step) const { return shear_rate(step) * size_[flow_.shear->gradient]; }
    double displacement(std::int64_t step) const {
        return flow_.shear->times.total(step) * flow_.shear->rate * size_[flow_.shear->gradient];
    }

    /// Of the fluid's box.
    const Vec3<int>& size() const { return size_; }
    bool has_walls(int axis) const {
        return std::holds_alternative<WallEnds>(ends_[static_cast<std::size_t>(axis)]);
    }
    bool is_open(int axis) const {
        return std::holds_alternative<OpenEnds>(ends_[static_cast<std::size_t>(axis)]);
    }
    std::int64_t fluid_cells() const {
        const auto solid =
            obstacles_ != nullptr ? static_cast<std::int64_t>(obstacles_->count()) : std::int64_t{0};
        return std::int64_t{size_.x} * size_.y * size_.z - solid;
    }

private:
    int wall_of(const Vec3<int>& cell) const;
    Vec3<double> velocity_of(int axis, bool upper, const Vec3<double>& place) const;
    double inlet_profile(int axis, const Vec3<double>& place) const;
    const FlowTimes* times_of(int axis) const;

    Vec3<int> size_{};
    Vec3<int> lattice_{};
    std::array<AxisEnds, 3> ends_{};
    FlowParameters flow_;
    std::shared_ptr<const SolidVoxels> obstacles_;
    bool has_solids_ = false;
};

} // namespace vesica
