#pragma once

#include "core/input_error.hpp"
#include "simulation/lattice_engine.hpp"

#include <cmath>
#include <cstring>
#include <span>

namespace vesica {

/// One pass over the block, row by row in any order, and over the ranks.
template <class Real>
Extremes LatticeEngine<Real>::extremes() const {
    const Vec3<int> size = grid_.size();
    const std::int64_t rows = std::int64_t{size.y} * size.z;
    const std::vector<std::uint8_t> in_band = layer_.cells_of_level(Band::outermost);
    std::vector<Extremes> of_row(static_cast<std::size_t>(rows));
    for_each_index(rows, setup_.threads, [&](std::int64_t r) {
        const int y = static_cast<int>(r % size.y);
        const int z = static_cast<int>(r / size.y);
        Extremes here = nothing_yet();
        for (int x = 0; x < size.x; ++x) {
            const std::int64_t cell = grid_.index(x, y, z);
            if (solids_.has(cell))
                continue;
            const Vec3<int> place = block_.own.begin + Vec3<int>{x, y, z};
            const bool in_layer =
                (in_band[static_cast<std::size_t>(cell / tile_width)] >> (cell % tile_width) & 1) != 0;
            const Moments<double> m = moments_at(cell);
            const Vec3<double> F = force_at(cell);
            here.speed.take(
                {norm(velocity_of(m, setup_.reference_density, whole_force_at(cell))), place, in_layer});
            here.density.take({std::abs(m.density_deviation), place, in_layer});
            here.force.take({norm(F), place, in_layer});
        }
        of_row[static_cast<std::size_t>(r)] = here;
    });
    Extremes here = nothing_yet();
    for (const Extremes& row : of_row)
        here.take(row);
    Extremes all = here;
    for (const Extremes& rank : ranks().gather_all(here))
        all.take(rank);
    return all;
}

/// The blocks' parts of a field put together, for the rank that leads.
template <class Real>
DenseField LatticeEngine<Real>::gathered(const DenseField& part) const {
    if (ranks().count() == 1)
        return part;
    const std::vector<CellBox> blocks = ranks().gather_all(block_.own);
    DenseField whole{block_.box, part.components, {}};
    ranks().gather(std::as_bytes(std::span(part.values)), [&](int rank, std::span<const std::byte> bytes) {
        if (whole.values.empty())
            whole.values.resize(static_cast<std::size_t>(CellBox{{}, block_.box}.volume() * part.components));
        const CellBox& block = blocks[static_cast<std::size_t>(rank)];
        const std::size_t row = static_cast<std::size_t>(block.size.x * part.components) * sizeof(double);
        const std::byte* from = bytes.data();
        for (int z = 0; z < block.size.z; ++z)
            for (int y = 0; y < block.size.y; ++y, from += row) {
                const std::int64_t cell =
                    (std::int64_t{block.begin.z + z} * block_.box.y + block.begin.y + y) * block_.box.x +
                    block.begin.x;
                std::memcpy(whole.values.data() + cell * part.components, from, row);
            }
    });
    return ranks().leads() ? whole : DenseField{};
}

template <class Real>
DenseField LatticeEngine<Real>::field(std::string_view name) const {
    return cropped(gathered(field_of_block(name)));
}

/// Without the walls' layers.
template <class Real>
DenseField LatticeEngine<Real>::cropped(DenseField field) const {
    const Vec3<int> size = setup_.drive.size();
    if (field.values.empty() || field.size == size)
        return field;
    const auto row = static_cast<std::size_t>(size.x * field.components);
    std::size_t to = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y, to += row) {
            const std::int64_t cell = (std::int64_t{z} * field.size.y + y) * field.size.x;
            std::copy_n(field.values.begin() + cell * field.components, row,
                        field.values.begin() + static_cast<std::ptrdiff_t>(to));
        }
    field.values.resize(to);
    field.size = size;
    return field;
}

template <class Real>
DenseField LatticeEngine<Real>::field_of_block(std::string_view name) const {
    const Vec3<int> size = grid_.size();
    const bool vector = name == "velocity" || name == "force" || name == "normal";
    DenseField field{size, vector ? 3 : 1, {}};
    // What solid cells are said to hold: outer fluid at rest.
    const double in_solids = name == "phase" ? -1.0 : name == "density" ? setup_.reference_density : 0.0;
    field.values.assign(static_cast<std::size_t>(grid_.volume() * field.components), in_solids);
    const auto fill = [&](const auto& value_at) {
        for_each_index(std::int64_t{size.y} * size.z, setup_.threads, [&](std::int64_t r) {
            const int y = static_cast<int>(r % size.y);
            const int z = static_cast<int>(r / size.y);
            for (int x = 0; x < size.x; ++x) {
                const std::int64_t cell = grid_.index(x, y, z);
                const auto at = static_cast<std::size_t>((r * size.x + x) * field.components);
                if (!solids_.has(cell))
                    value_at(cell, field.values.data() + at);
            }
        });
    };
    const auto holds = [](const std::vector<std::uint8_t>& bits, std::int64_t cell) {
        return (bits[static_cast<std::size_t>(cell / tile_width)] >> (cell % tile_width) & 1) != 0;
    };
    // Whole tiles are worked on, and in cells beyond a quantity's level what comes out means nothing. Where
    // several layers have a cell, the membrane that lies nearest counts.
    const auto fill_level = [&](int level, const auto& components) {
        const std::vector<std::uint8_t> known = layer_.cells_of_level(level);
        fill([&](std::int64_t cell, double* out) {
            if (!holds(known, cell))
                return;
            const BandTile* const t = layer_.nearest_tile(cell, level);
            for (const std::span<Real> component : components)
                *out++ =
                    static_cast<double>(component[static_cast<std::size_t>(t->slot() + cell % tile_width)]);
        });
    };
    const auto alone = [](std::span<Real> array) {
        return std::array<std::span<Real>, 1>{array};
    };
    const LayerFields<Real>& layer = layer_.fields();
    if (name == "phase") {
        // Of all vesicles together against the fluid outside.
        fill([&](std::int64_t cell, double* out) {
            *out = -1.0;
            layer_.for_each_colour(cell, layer.chi, [&](int, Real chi) {
                if (sign_bit(chi) || chi > Real(0)) // nothing else: whose tiles are there must not show
                    *out = *out + 1.0 + static_cast<double>(phase_of(chi));
            });
            if (layer_.interior()[static_cast<std::size_t>(cell / tile_width)] >= 0)
                *out = 1.0;
        });
    } else if (name == "density" || name == "pressure") {
        const double scale = name == "pressure" ? sound_speed_squared : 1.0;
        fill([&](std::int64_t cell, double* out) {
            const double deviation = moments_at(cell).density_deviation;
            *out = name == "pressure" ? scale * deviation : setup_.reference_density + deviation;
        });
    } else if (name == "velocity") {
        fill([&](std::int64_t cell, double* out) {
            const Vec3<double> u =
                velocity_of(moments_at(cell), setup_.reference_density, whole_force_at(cell));
            for (int a = 0; a < 3; ++a)
                out[a] = u[a];
        });
    } else if (name == "force") {
        fill([&](std::int64_t cell, double* out) {
            const Vec3<double> F = force_at(cell);
            for (int a = 0; a < 3; ++a)
                out[a] = F[a];
        });
    } else if (name == "normal") {
        fill_level(reach::colour, layer.n);
    } else if (name == "mean_curvature") {
        std::vector<Real> values(layer.s.size(), Real(0));
        for (const std::int32_t index : layer_.band().of_level(reach::curvature)) {
            const TileRun<Real> t{&layer_.band().tiles()[static_cast<std::size_t>(index)]};
            layer_.mean_curvature(t).store(values.data() + t.slot());
        }
        fill_level(reach::curvature, alone(values));
    } else if (name == "gaussian_curvature") {
        fill_level(reach::curvature, alone(layer.K0));
    } else if (name == "bending_force" || name == "tension_force" || name == "area_force") {
        std::vector<Real> values(layer.s.size(), Real(0));
        for (const std::int32_t index : layer_.band().of_level(reach::force)) {
            const BandTile& t = layer_.band().tiles()[static_cast<std::size_t>(index)];
            const V H = layer_.mean_curvature(TileRun<Real>{&t});
            const V K = V::load(layer.K0.data() + t.slot());
            const Membrane& membrane = membranes_[static_cast<std::size_t>(t.label)];
            const V bending = std::visit(
                [&](const auto& law) {
                    return law.force(H, K, layer_.laplace_beltrami_of_H(TileRun<Real>{&t}));
                },
                membrane.bending);
            const double tension = name == "area_force" ? membrane.constraint_tension : membrane.sigma;
            const V value = name == "bending_force" ? bending : TensionLaw{tension}.force(H);
            value.store(values.data() + t.slot());
        }
        fill_level(reach::force, alone(values));
    } else {
        throw InputError("field \"" + std::string(name) + "\" is unknown");
    }
    return field;
}

/// A cell of a membrane that lies too near to an end of the box where fluid enters or leaves; of several the
/// first.
template <class Real>
std::optional<Vec3<int>> LatticeEngine<Real>::cell_at_open_end() const {
    constexpr int too_near = 6;
    const FlowDrive& drive = setup_.drive;
    const auto precedes = [](const Vec3<int>& a, const Vec3<int>& b) {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    };
    const Vec3<int> none = block_.box;
    Vec3<int> first = none;
    for (const BandTile& t : layer_.band().tiles())
        for (int k = 0; k < tile_width; ++k) {
            if ((t.bits[0] >> k & 1) == 0)
                continue;
            const Vec3<int> cell = grid_.tile_origin(t.tile) + block_.own.begin + Vec3<int>{k, 0, 0};
            for (int a = 0; a < 3; ++a)
                if (drive.is_open(a) && (cell[a] < too_near || cell[a] >= drive.size()[a] - too_near) &&
                    precedes(cell, first))
                    first = cell;
        }
    for (const Vec3<int>& cell : ranks().gather_all(first))
        if (precedes(cell, first))
            first = cell;
    return first == none ? std::nullopt : std::optional(first);
}

/// The one whose membrane lies nearest to a cell of the whole box, of those whose layers have it; -1: none.
template <class Real>
int LatticeEngine<Real>::vesicle_at(const Vec3<int>& place) const {
    const Vec3<int> cell = place - block_.own.begin;
    bool here = !layer_.empty();
    for (int a = 0; a < 3; ++a)
        here = here && cell[a] >= 0 && cell[a] < grid_.size()[a];
    const BandTile* const nearest = here ? layer_.nearest_tile(grid_.index(cell), Band::outermost) : nullptr;
    int label = nearest != nullptr ? nearest->label : -1;
    for (const int of_rank : ranks().gather_all(label))
        label = std::max(label, of_rank);
    return label;
}

/// Speeds beyond the range of the equilibrium, densities far from the reference, forces that would move a
/// cell's fluid by a fair part of its sound speed within a step: a run that shows them is lost.
template <class Real>
std::optional<Trouble> LatticeEngine<Real>::trouble() const {
    const auto text = [](const char* what, double found, double limit) {
        return std::string(what) + " is " + std::to_string(found) + ", beyond " + std::to_string(limit);
    };
    const double fastest_allowed = 0.3;
    const double density_allowed = 0.3 * setup_.reference_density;
    const double force_allowed = 0.1 * setup_.reference_density;
    const Extremes worst = extremes();
    const auto at = [&](const Extreme& place, const std::string& cause) {
        return Trouble{step_, place.cell, place.in_layer ? vesicle_at(place.cell) : -1, cause};
    };
    if (const std::optional<Vec3<int>> place = cell_at_open_end())
        return Trouble{
            step_, *place, vesicle_at(*place),
            "the vesicle has come within 6 cells of an inlet or outlet, which know nothing of membranes"};
    for (std::size_t label = 0; label < membranes_.size() && !layer_.empty(); ++label)
        if (!std::isfinite(membranes_[label].tension()))
            return Trouble{step_, worst.speed.cell, static_cast<int>(label), "tension is not a number"};
    if (!(worst.force.size <= force_allowed))
        return at(worst.force, text("force", worst.force.size, force_allowed));
    if (!(worst.density.size <= density_allowed))
        return at(worst.density,
                  text("density's distance from that at rest", worst.density.size, density_allowed));
    if (!(worst.speed.size <= fastest_allowed))
        return at(worst.speed, text("speed", worst.speed.size, fastest_allowed));
    return std::nullopt;
}

template <class Real>
RankTraffic LatticeEngine<Real>::traffic() const {
    RankTraffic traffic;
    traffic.band_bytes = layer_.messages().bytes_sent();
    traffic.band_messages = layer_.messages().messages_sent();
    if (others_) {
        traffic.population_bytes = others_->messages().bytes_sent();
        traffic.population_messages = others_->messages().messages_sent();
    }
    return traffic;
}

} // namespace vesica
