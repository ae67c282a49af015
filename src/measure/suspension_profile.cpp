#include "measure/suspension_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace vesica {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Across {
public:
    Across(const DenseField& phase, const DenseField& velocity, const SolidVoxels* solids,
           const ProfileOutput& output)
        : phase_(phase),
          velocity_(velocity),
          solids_(solids),
          along_(output.along),
          axis_(output.across_axis),
          first_((output.along + 1) % 3),
          second_((output.along + 2) % 3) {}

    bool radial() const { return axis_ < 0; }
    bool solid(const Vec3<int>& cell) const { return solids_ != nullptr && solids_->at(cell); }
    double phase(const Vec3<int>& cell) const { return phase_.values[index(cell)]; }
    double velocity(const Vec3<int>& cell) const {
        return velocity_.values[3 * index(cell) + static_cast<std::size_t>(along_)];
    }

    /// From the box's middle line, or along the axis.
    double place(const Vec3<int>& cell) const {
        if (!radial())
            return cell[axis_] + 0.5;
        return std::hypot(cell[first_] + 0.5 - 0.5 * phase_.size[first_],
                          cell[second_] + 0.5 - 0.5 * phase_.size[second_]);
    }

    template <class Body>
    void for_each_cell(const Body& body) const {
        Vec3<int> cell{};
        for (cell.z = 0; cell.z < phase_.size.z; ++cell.z)
            for (cell.y = 0; cell.y < phase_.size.y; ++cell.y)
                for (cell.x = 0; cell.x < phase_.size.x; ++cell.x)
                    if (!solid(cell))
                        body(cell);
    }

    /// Between two walls, in every column of cells from one to the other and back.
    double free_layer_of_walls() const {
        const int n = phase_.size[axis_];
        double sum = 0.0;
        std::int64_t count = 0;
        Vec3<int> ends = phase_.size;
        ends[axis_] = 1;
        Vec3<int> column{};
        for (column.z = 0; column.z < ends.z; ++column.z)
            for (column.y = 0; column.y < ends.y; ++column.y)
                for (column.x = 0; column.x < ends.x; ++column.x)
                    for (const bool upper : {false, true}) {
                        const auto at = [&](int k) {
                            Vec3<int> cell = column;
                            cell[axis_] = upper ? n - 1 - k : k;
                            return solid(cell) ? nothing : phase(cell);
                        };
                        add_first_crossing(n, 1.0, at, sum, count);
                    }
        return count > 0 ? sum / static_cast<double>(count) : nothing;
    }

    /// In a tube along the box: from where it becomes solid, inwards along rays from its middle line.
    double free_layer_of_tube() const {
        if (solids_ == nullptr)
            return nothing;
        constexpr int rays = 96;
        constexpr double step = 0.25;
        double sum = 0.0;
        std::int64_t count = 0;
        for (int slice = 0; slice < phase_.size[along_]; ++slice)
            for (int ray = 0; ray < rays; ++ray) {
                const double angle = 2.0 * std::numbers::pi * ray / rays;
                const auto cell_at = [&](double r) {
                    Vec3<int> cell{};
                    cell[along_] = slice;
                    cell[first_] =
                        static_cast<int>(std::floor(0.5 * phase_.size[first_] + r * std::cos(angle)));
                    cell[second_] =
                        static_cast<int>(std::floor(0.5 * phase_.size[second_] + r * std::sin(angle)));
                    return cell;
                };
                const auto inside = [&](const Vec3<int>& cell) {
                    return cell[first_] >= 0 && cell[second_] >= 0 && cell[first_] < phase_.size[first_] &&
                           cell[second_] < phase_.size[second_];
                };
                int wall = 0;
                while (inside(cell_at(wall * step)) && !solid(cell_at(wall * step)))
                    ++wall;
                if (!inside(cell_at(wall * step)))
                    continue; // this way the tube is open
                const auto at = [&](int k) {
                    return phase(cell_at((wall - 1 - k) * step));
                };
                add_first_crossing(wall, step, at, sum, count);
            }
        return count > 0 ? sum / static_cast<double>(count) : nothing;
    }

private:
    /// Where phase(0), phase(1), ..., `step` apart and the first of them half a step from the wall, first
    /// becomes positive.
    template <class Phase>
    static void add_first_crossing(int points, double step, const Phase& phase_at, double& sum,
                                   std::int64_t& count) {
        if (points > 0 && phase_at(0) > 0.0) { // a membrane touches the wall
            ++count;
            return;
        }
        for (int k = 1; k < points; ++k) {
            const double before = phase_at(k - 1);
            const double here = phase_at(k);
            if (!(before <= 0.0 && here > 0.0))
                continue;
            sum += step * (k - 0.5 + before / (before - here));
            ++count;
            return;
        }
    }

    std::size_t index(const Vec3<int>& cell) const {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(phase_.size.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(phase_.size.x) +
               static_cast<std::size_t>(cell.x);
    }

    const DenseField& phase_;
    const DenseField& velocity_;
    const SolidVoxels* solids_;
    int along_;
    int axis_;
    int first_;
    int second_;
};

struct BinSums {
    std::int64_t cells = 0;
    double inside = 0.0;
    double velocity = 0.0;
    double inner_velocity = 0.0;

    void add(const BinSums& other) {
        cells += other.cells;
        inside += other.inside;
        velocity += other.velocity;
        inner_velocity += other.inner_velocity;
    }
};

} // namespace

SuspensionProfile suspension_profile(const DenseField& phase, const DenseField& velocity,
                                     const SolidVoxels* solids, const ProfileOutput& output,
                                     bool walls_across) {
    const Across across(phase, velocity, solids, output);
    std::vector<BinSums> sums;
    across.for_each_cell([&](const Vec3<int>& cell) {
        const auto bin = static_cast<std::size_t>(across.place(cell));
        if (bin >= sums.size())
            sums.resize(bin + 1);
        const double inside = std::clamp(0.5 * (1.0 + across.phase(cell)), 0.0, 1.0);
        const double u = across.velocity(cell);
        sums[bin].add({1, inside, u, inside * u});
    });
    SuspensionProfile profile;
    BinSums all;
    for (std::size_t bin = 0; bin < sums.size(); ++bin) {
        const BinSums& sum = sums[bin];
        all.add(sum);
        if (sum.cells == 0)
            continue;
        const auto cells = static_cast<double>(sum.cells);
        profile.bins.push_back({static_cast<double>(bin) + 0.5, sum.cells, sum.inside / cells,
                                sum.velocity / cells,
                                sum.inside > 1e-6 * cells ? sum.inner_velocity / sum.inside : nothing});
    }
    const auto cells = static_cast<double>(std::max<std::int64_t>(1, all.cells));
    profile.haematocrit = all.inside / cells;
    profile.velocity = all.velocity / cells;
    profile.discharge_haematocrit =
        std::abs(all.velocity) > 1e-9 * cells ? all.inner_velocity / all.velocity : nothing;
    profile.cell_free_layer = across.radial() ? across.free_layer_of_tube()
                              : walls_across  ? across.free_layer_of_walls()
                                              : nothing;
    return profile;
}

} // namespace vesica
