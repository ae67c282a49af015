#pragma once

#include "lattice/band.hpp"
#include "lattice/velocity_set.hpp"
#include "parallel/pack.hpp"

#include <span>
#include <vector>

namespace vesica {

/// Tiles of a band that lie side by side, as do all their neighbours (BandTile::followed): worked on at once,
/// in packs of `width` cells.
template <class Real, int width = tile_width>
struct TileRun {
    using V = Pack<Real, width>;
    static constexpr int count = width / tile_width;

    const BandTile* tiles;

    std::int64_t cell() const { return tiles->cell; }
    std::int32_t slot() const { return tiles->slot(); }
    int label() const { return tiles->label; }
    const std::int32_t* rows() const { return tiles->rows; }

    /// Bit k: cell k belongs to the level.
    VESICA_INLINE std::uint32_t bits(int level) const {
        std::uint32_t bits = tiles->bits[level];
        for (int k = 1; k < count; ++k)
            bits |= std::uint32_t{tiles[k].bits[level]} << (k * tile_width);
        return bits;
    }
    VESICA_INLINE bool beside_solid() const {
        bool beside = tiles->beside_solid;
        for (int k = 1; k < count; ++k)
            beside = beside || tiles[k].beside_solid;
        return beside;
    }
    VESICA_INLINE typename V::Mask cells_of(int level) const { return V::mask(bits(level)); }

    VESICA_INLINE V load(const std::span<Real>& a) const { return V::load(a.data() + slot()); }
    VESICA_INLINE Vec3<V> load(const std::span<Real> (&a)[3]) const {
        return {load(a[0]), load(a[1]), load(a[2])};
    }
    VESICA_INLINE void store(const V& value, const std::span<Real>& a) const {
        value.store(a.data() + slot());
    }
    VESICA_INLINE void store(const Vec3<V>& value, const std::span<Real> (&a)[3]) const {
        store(value.x, a[0]);
        store(value.y, a[1]);
        store(value.z, a[2]);
    }
};

/// body(run, index of its first tile) for the band's tiles of an ascending list, from the begin-th to the one
/// before the end-th: as many tiles at once as lie side by side and fill a register.
template <class Real, int most = tiles_per_register<Real>, class Body>
VESICA_INLINE void for_each_run(const Band& band, const std::vector<std::int32_t>& tiles, std::int64_t begin,
                                std::int64_t end, const Body& body) {
    static_assert(most <= 2);
    const std::int32_t* const list = tiles.data();
    for (std::int64_t k = begin; k < end; ++k) {
        const auto index = static_cast<std::size_t>(list[k]);
        const BandTile* const first = band.tiles().data() + index;
        if constexpr (most == 2)
            if (first->followed && k + 1 < end && list[k + 1] == list[k] + 1) {
                body(TileRun<Real, 2 * tile_width>{first}, index);
                ++k;
                continue;
            }
        body(TileRun<Real>{first}, index);
    }
}

/// The value of a compact array in a run's cells shifted by a lattice link.
template <class Real, int width>
struct Around {
    const Real* values;
    const std::int32_t* rows;

    template <int i>
    VESICA_INLINE Pack<Real, width> operator()(Direction<i>) const {
        constexpr int row = (velocity(i, 1) + 1) + 3 * (velocity(i, 2) + 1);
        return Pack<Real, width>::load(values + rows[row] + velocity(i, 0));
    }
};

template <class Real, int width>
VESICA_INLINE Around<Real, width> around(const std::span<Real>& a, const TileRun<Real, width>& t) {
    return {a.data(), t.rows()};
}

template <class Real, int width>
VESICA_INLINE Vec3<Around<Real, width>> around(const std::span<Real> (&a)[3], const TileRun<Real, width>& t) {
    return {around(a[0], t), around(a[1], t), around(a[2], t)};
}

} // namespace vesica
