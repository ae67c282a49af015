#pragma once

#include "lattice/field.hpp"
#include "lattice/grid.hpp"
#include "lattice/velocity_set.hpp"

namespace vesica {

/// Where the populations of a cell lie at present. Streaming is done in place, in one array per direction, by
/// alternating two kinds of step (the AA pattern, Bailey et al. 2009):
///
/// - arrived: f_i(x) lies in slot i of x. A step reads and writes the cell itself only, f_i* to slot
///   opposite(i).
/// - turned: f_i(x) lies in slot opposite(i) of x - c_i. A step reads there and writes f_i* to slot i of x +
///   c_i, the very places it has read, so that afterwards everything has arrived.
enum class Streaming { arrived, turned };

constexpr Streaming after_step(Streaming streaming) {
    return streaming == Streaming::arrived ? Streaming::turned : Streaming::arrived;
}

/// Finds populations: the only place that knows the two addressings. What is stored is g_i = f_i - t_i rho0.
template <class Real>
class PopulationView {
public:
    PopulationView() = default;
    PopulationView(const FieldView<Real>& field, const Grid& grid) {
        for (int i = 0; i < direction_count; ++i) {
            slots_[i] = field.component(i);
            offsets_[i] = grid.offset(velocity(i, 0), velocity(i, 1), velocity(i, 2));
        }
    }

    Real* slot(int i) const { return slots_[i]; }

    /// Where f_i of this cell lies, before collision.
    template <Streaming streaming, int i>
    [[gnu::always_inline]] Real* arriving(std::int64_t cell) const {
        if constexpr (streaming == Streaming::arrived)
            return slots_[i] + cell;
        else
            return slots_[opposite(i)] + cell - offsets_[i];
    }

    /// Where f_i* of this cell goes, after collision.
    template <Streaming streaming, int i>
    [[gnu::always_inline]] Real* departing(std::int64_t cell) const {
        if constexpr (streaming == Streaming::arrived)
            return slots_[opposite(i)] + cell;
        else
            return slots_[i] + cell + offsets_[i];
    }

    /// Asks for the cache line of an arriving population to be brought to the second level.
    template <Streaming streaming, int i>
    [[gnu::always_inline]] void fetch(std::int64_t cell) const {
        __builtin_prefetch(arriving<streaming, i>(cell), 0, 2);
    }

    /// The same as arriving(), for the rare reader that does not know the phase at compile time.
    const Real* find(Streaming streaming, int i, std::int64_t cell) const {
        return streaming == Streaming::arrived ? slots_[i] + cell : slots_[opposite(i)] + cell - offsets_[i];
    }

private:
    Real* slots_[direction_count] = {};
    std::int64_t offsets_[direction_count] = {};
};

} // namespace vesica
