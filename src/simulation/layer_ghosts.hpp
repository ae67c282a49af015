#pragma once

#include "simulation/layer.hpp"

namespace vesica {

/// for_tiles, after which the ghosts of `arrays` have the values of the cells they stand for. What other
/// ranks wait for comes first and travels while the rest is worked on.
template <class Real>
template <class Body>
void Layer<Real>::share(int level, int threads, std::initializer_list<std::span<Real>> arrays,
                        const Body& body) {
    if (neighbourhood_->block().is_whole()) {
        for_tiles(level, threads, body);
        copy_ghosts(arrays, threads);
        return;
    }
    for_listed_tiles(band_.rim_of_level(level), threads, body);
    halo_.start(arrays, threads);
    for_listed_tiles(band_.inner_of_level(level), threads, body);
    copy_ghosts(arrays, threads);
    halo_.finish(arrays, threads);
    blend_slid_ghosts(arrays, level, threads);
}

/// Beside solids, after arrays have been shared: what a layer of solid cells stands for.
template <class Real>
void Layer<Real>::extend_into_solids(std::initializer_list<std::span<Real>> arrays, int level, double slope,
                                     int threads) {
    if (!near_solids_)
        return;
    margin_.fill(arrays, level, slope, threads);
    if (!neighbourhood_->block().is_whole())
        halo_.start(arrays, threads);
    copy_ghosts(arrays, threads);
    if (!neighbourhood_->block().is_whole())
        halo_.finish(arrays, threads);
    blend_slid_ghosts(arrays, level, threads);
}

/// Those that stand for cells of this block.
template <class Real>
void Layer<Real>::copy_ghosts(std::initializer_list<std::span<Real>> arrays, int threads) {
    const std::vector<Band::GhostCopy>& copies = band_.ghost_copies();
    if (copies.empty())
        return;
    for_each_block(static_cast<std::int64_t>(copies.size()), threads,
                   [&](int, std::int64_t begin, std::int64_t end) {
                       for (const std::span<Real>& array : arrays)
                           for (std::int64_t k = begin; k < end; ++k)
                               array[at(copies[at(k)].to)] = array[at(copies[at(k)].from)];
                   });
}

} // namespace vesica
