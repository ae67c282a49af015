#pragma once

#include "case/parameters.hpp"
#include "core/cell_box.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vesica {

/// What a state is of, and what of it belongs to no cell.
struct StateHead {
    std::int64_t step = 0;
    Precision precision = Precision::double_precision;
    Vec3<int> size{};                ///< of the whole box
    CellBox part{};                  ///< the cells the arrays are of
    std::vector<double> controllers; ///< area constraint state, vesicle by vesicle
};

/// Everything that must be kept to continue bit for bit, of a part of the box. Arrays are in the part's
/// canonical order (z, y, x), independent of threads and instruction sets.
struct EngineState : StateHead {
    std::vector<std::vector<double>> populations; ///< 19 x cells, f_i - t_i rho0
    // Slot by slot, cells each: a cell's colours in ascending order of labels, and as many slots as any cell
    // of the whole box needs, at least one.
    std::vector<double> minority;    ///< signed minority fraction of the colour against everything else
    std::vector<std::uint8_t> band;  ///< bit 0 core at the last rebuild, bit 1 inside (red) side
    std::vector<std::int32_t> label; ///< whose colour, -1 in unused slots; empty with one vesicle

    std::size_t slots() const {
        return minority.size() / std::max<std::size_t>(1, static_cast<std::size_t>(part.volume()));
    }
};

/// A state that gives its arrays plane by plane, z from 0 in its part, so that whoever writes them needs no
/// copy of the whole.
class StatePlanes {
public:
    StatePlanes() = default;
    StatePlanes(const StatePlanes&) = delete;
    StatePlanes& operator=(const StatePlanes&) = delete;
    virtual ~StatePlanes() = default;

    virtual const StateHead& head() const = 0;
    /// Whether no number of the planes loses anything as a float, signs of zeros and bits of NaNs included.
    virtual bool all_floats() const = 0;
    virtual std::size_t population_count() const = 0;
    virtual void population(std::size_t i, int z, std::span<double> plane) const = 0;
    /// Colours per cell, and whether the slots have labels.
    virtual std::size_t slots() const = 0;
    virtual bool is_labelled() const = 0;
    virtual void minority(std::size_t slot, int z, std::span<double> plane) const = 0;
    virtual void band(std::size_t slot, int z, std::span<std::uint8_t> plane) const = 0;
    virtual void label(std::size_t slot, int z, std::span<std::int32_t> plane) const = 0;
};

/// The planes of a state in memory, which must outlive them.
class PlanesOfState final : public StatePlanes {
public:
    explicit PlanesOfState(const EngineState& state) : state_(state) {}

    const StateHead& head() const override { return state_; }
    bool all_floats() const override {
        return std::all_of(state_.populations.begin(), state_.populations.end(), are_floats) &&
               are_floats(state_.minority);
    }
    std::size_t population_count() const override { return state_.populations.size(); }
    void population(std::size_t i, int z, std::span<double> plane) const override {
        copy(state_.populations[i], 0, z, plane);
    }
    std::size_t slots() const override { return state_.slots(); }
    bool is_labelled() const override { return !state_.label.empty(); }
    void minority(std::size_t slot, int z, std::span<double> plane) const override {
        copy(state_.minority, slot, z, plane);
    }
    void band(std::size_t slot, int z, std::span<std::uint8_t> plane) const override {
        copy(state_.band, slot, z, plane);
    }
    void label(std::size_t slot, int z, std::span<std::int32_t> plane) const override {
        copy(state_.label, slot, z, plane);
    }

private:
    static bool are_floats(const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double value) {
            return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(value))) ==
                   std::bit_cast<std::uint64_t>(value);
        });
    }

    template <class T>
    void copy(const std::vector<T>& values, std::size_t slot, int z, std::span<T> plane) const {
        const std::size_t planes =
            slot * static_cast<std::size_t>(state_.part.size.z) + static_cast<std::size_t>(z);
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(plane.size() * planes);
        std::copy(first, first + static_cast<std::ptrdiff_t>(plane.size()), plane.begin());
    }

    const EngineState& state_;
};

/// The same as arrays.
inline EngineState collected(const StatePlanes& planes) {
    EngineState state;
    static_cast<StateHead&>(state) = planes.head();
    const Vec3<int> size = state.part.size;
    const auto plane = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const auto collect = [&]<class T>(std::vector<T>& values, const auto& copy_plane) {
        for (int z = 0; z < size.z; ++z) {
            values.resize(values.size() + plane);
            copy_plane(z, std::span(values).last(plane));
        }
    };
    state.populations.resize(planes.population_count());
    for (std::size_t i = 0; i < state.populations.size(); ++i)
        collect(state.populations[i],
                [&](int z, std::span<double> values) { planes.population(i, z, values); });
    for (std::size_t slot = 0; slot < planes.slots(); ++slot) {
        collect(state.minority, [&](int z, std::span<double> values) { planes.minority(slot, z, values); });
        collect(state.band, [&](int z, std::span<std::uint8_t> values) { planes.band(slot, z, values); });
        if (planes.is_labelled())
            collect(state.label,
                    [&](int z, std::span<std::int32_t> values) { planes.label(slot, z, values); });
    }
    return state;
}

} // namespace vesica
