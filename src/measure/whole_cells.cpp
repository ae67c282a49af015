#include "measure/whole_cells.hpp"

#include <cmath>
#include <map>
#include <tuple>

namespace vesica {
namespace {

constexpr double least_part = 1e-9; // of a cell, that counts as displaced

double part_of(double centre) {
    return centre - 0.5 - std::floor(centre - 0.5);
}

bool is_displaced(double part) {
    return part > least_part && part < 1.0 - least_part;
}

/// A line's cells by the whole number below their place, of which all lie the same part of a cell away.
struct Line {
    double part = 0.0;
    std::map<int, const InterfaceCell*> cells; ///< null: purely inside
};

InterfaceCell between(const InterfaceCell& a, const InterfaceCell& b, double t, double beta) {
    const auto mean = [&](const auto& one, const auto& other) {
        return (1.0 - t) * one + t * other;
    };
    InterfaceCell cell;
    cell.position = mean(a.position, b.position);
    cell.s = mean(a.s, b.s);
    cell.phi = -std::tanh(beta * cell.s);
    cell.n = mean(a.n, b.n);
    cell.H = mean(a.H, b.H);
    cell.K = mean(a.K, b.K);
    cell.H0 = mean(a.H0, b.H0);
    cell.K0 = mean(a.K0, b.K0);
    cell.J = mean(a.J, b.J);
    cell.density = mean(a.density, b.density);
    cell.u = mean(a.u, b.u);
    cell.bending_force = mean(a.bending_force, b.bending_force);
    cell.tension_force = mean(a.tension_force, b.tension_force);
    cell.area_force = mean(a.area_force, b.area_force);
    cell.force = mean(a.force, b.force);
    cell.weight = 0.5 * beta * (1.0 - cell.phi * cell.phi);
    cell.has_geometry = a.has_geometry && b.has_geometry;
    return cell;
}

class Aligner {
public:
    Aligner(const VesicleSnapshot& vesicle, int along) : vesicle_(vesicle), along_(along), result_(vesicle) {
        result_.cells.clear();
        result_.inside.clear();
        for (const InterfaceCell& cell : vesicle.cells)
            if (is_displaced(part_of(cell.position[along])))
                add(cell.position, &cell);
            else
                result_.cells.push_back(cell);
        for (const InsideSpan& span : vesicle.inside) {
            if (!is_displaced(span.rest[along])) {
                result_.inside.push_back(span);
                continue;
            }
            for (int k = 0; k < span.count; ++k)
                add(Vec3<double>{span.begin + k + 0.5, span.y + 0.5, span.z + 0.5} + span.rest, nullptr);
        }
        for (const auto& [key, line] : lines_)
            align(line, key);
    }

    VesicleSnapshot result() && { return std::move(result_); }

private:
    using Key = std::tuple<int, int>; ///< the line's place along the two other axes

    void add(const Vec3<double>& centre, const InterfaceCell* cell) {
        const auto floor_of = [&](int axis) {
            return static_cast<int>(std::floor(centre[axis]));
        };
        Line& line = lines_[{floor_of((along_ + 1) % 3), floor_of((along_ + 2) % 3)}];
        line.part = part_of(centre[along_]);
        line.cells[static_cast<int>(std::floor(centre[along_] - 0.5))] = cell;
    }

    Vec3<int> cell_at(const Key& key, int place) const {
        Vec3<int> cell{};
        cell[along_] = place;
        cell[(along_ + 1) % 3] = std::get<0>(key);
        cell[(along_ + 2) % 3] = std::get<1>(key);
        return cell;
    }

    void align(const Line& line, const Key& key) {
        enum class Kind { outside, inside, layer };
        const auto kind_of = [&](auto found) {
            return found == line.cells.end()  ? Kind::outside
                   : found->second == nullptr ? Kind::inside
                                              : Kind::layer;
        };
        // Places just above one cell, or just below the next.
        std::map<int, bool> places;
        for (const auto& [below, cell] : line.cells)
            places[below] = places[below + 1] = true;
        for (const auto& [place, unused] : places) {
            const auto lower = line.cells.find(place - 1);
            const auto upper = line.cells.find(place);
            const Kind below = kind_of(lower);
            const Kind above = kind_of(upper);
            const Vec3<int> cell = cell_at(key, place);
            if (below != Kind::layer && above != Kind::layer) {
                if (below == Kind::inside && above == Kind::inside)
                    result_.inside.push_back({cell.x, 1, cell.y, cell.z, {}});
                continue;
            }
            // Beyond the layer the distance goes on, a cell by a cell.
            const auto continued = [](const InterfaceCell& last, Kind kind) {
                InterfaceCell next = last;
                next.s += kind == Kind::inside ? -1.0 : 1.0;
                return next;
            };
            const InterfaceCell a = below == Kind::layer ? *lower->second : continued(*upper->second, below);
            const InterfaceCell b = above == Kind::layer ? *upper->second : continued(*lower->second, above);
            InterfaceCell aligned = between(a, b, 1.0 - line.part, vesicle_.beta);
            aligned.position = {cell.x + 0.5, cell.y + 0.5, cell.z + 0.5};
            result_.cells.push_back(aligned);
        }
    }

    const VesicleSnapshot& vesicle_;
    int along_;
    VesicleSnapshot result_;
    std::map<Key, Line> lines_;
};

} // namespace

VesicleSnapshot on_whole_cells(const VesicleSnapshot& vesicle) {
    for (const InterfaceCell& cell : vesicle.cells)
        for (int a = 0; a < 3; ++a)
            if (is_displaced(part_of(cell.position[a])))
                return Aligner(vesicle, a).result();
    return vesicle;
}

} // namespace vesica
