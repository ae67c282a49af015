#include "simulation/block_plan.hpp"

#include "core/input_error.hpp"
#include "io/state_file.hpp"
#include "simulation/engine_setup.hpp"

#include <fmt/format.h>

namespace vesica {

namespace {

PlaneCounts none_in(const Vec3<int>& box) {
    PlaneCounts counts;
    for (int a = 0; a < 3; ++a)
        counts[static_cast<std::size_t>(a)].assign(static_cast<std::size_t>(box[a]), 0);
    return counts;
}

void count(const Vec3<int>& cell, PlaneCounts& counts) {
    for (int a = 0; a < 3; ++a)
        ++counts[static_cast<std::size_t>(a)][static_cast<std::size_t>(cell[a])];
}

/// A plane's neighbours within the band's reach have a share in its core.
std::vector<double> band_cells(const std::vector<std::uint64_t>& core) {
    constexpr int reach = Band::outermost;
    constexpr double band_per_core = 3.7; // cells, of a discocyte of R0 = 20
    const auto planes = static_cast<int>(core.size());
    std::vector<double> cells(core.size(), 0.0);
    for (int plane = 0; plane < planes; ++plane)
        for (int away = -reach; away <= reach; ++away) {
            const int other = ((plane + away) % planes + planes) % planes;
            cells[static_cast<std::size_t>(other)] +=
                band_per_core / (2 * reach + 1) * static_cast<double>(core[static_cast<std::size_t>(plane)]);
        }
    return cells;
}

} // namespace

std::optional<Slide> slide_of(const Parameters& parameters) {
    if (const ShearFlow* shear = parameters.sliding())
        return Slide{shear->gradient, shear->velocity};
    return {};
}

BlockLayout layout_for(const Vec3<int>& box, int ranks, const std::optional<Vec3<int>>& blocks,
                       const std::optional<Slide>& slide) {
    const std::string size = fmt::format("{} x {} x {}", box.x, box.y, box.z);
    if (blocks) {
        const std::int64_t wanted = std::int64_t{blocks->x} * blocks->y * blocks->z;
        const std::string given = fmt::format("--blocks is {},{},{}", blocks->x, blocks->y, blocks->z);
        if (wanted != ranks)
            throw InputError(fmt::format("{}, {} blocks in all; expected one for each of the {} ranks; try "
                                         "without it, or mpirun -n {}",
                                         given, wanted, ranks, wanted));
        if (slide && (*blocks)[slide->velocity] != 1)
            throw InputError(fmt::format("{}; expected one block along {}, along which flow.shear with "
                                         "lees-edwards moves the box's images; try without it",
                                         given, "xyz"[slide->velocity]));
        if (!fits(box, *blocks))
            throw InputError(fmt::format("{}; expected blocks of at least {} cells along each axis that is "
                                         "cut, in a box of {}; try without it",
                                         given, BlockLayout::narrowest, size));
        return {box, *blocks, slide};
    }
    const std::optional<Vec3<int>> chosen = choose_blocks(box, ranks, slide);
    if (!chosen)
        throw InputError(
            fmt::format("lattice.size is {}; expected a box that {} ranks can share in blocks of "
                        "at least {} cells along each axis{}; try mpirun -n {}",
                        size, ranks, BlockLayout::narrowest,
                        slide ? fmt::format(", of which there is one along {}, where the images slide",
                                            "xyz"[slide->velocity])
                              : std::string(),
                        most_blocks(box, ranks, slide)));
    return {box, *chosen, slide};
}

PlaneCounts core_of_case(const Parameters& parameters, const Block& block, int threads) {
    PlaneCounts counts = none_in(parameters.lattice());
    const std::shared_ptr<const InitialColours> colours = initial_colours(parameters, block, threads);
    if (colours == nullptr)
        return counts;
    const Grid grid(block.own.size);
    for (const Band::Seed& seed : colours->core()) {
        const Vec3<int> first = grid.tile_origin(seed.tile) + block.own.begin;
        for (int k = 0; k < Grid::tile; ++k)
            if ((seed.bits >> k & 1) != 0)
                count(first + Vec3<int>{k, 0, 0}, counts);
    }
    return counts;
}

PlaneCounts core_of_checkpoint(const std::filesystem::path& checkpoint, const Block& block) {
    PlaneCounts counts = none_in(block.box);
    const std::vector<std::uint8_t> band = read_band(checkpoint, block.own);
    std::size_t at = 0;
    for (int z = 0; z < block.own.size.z; ++z)
        for (int y = 0; y < block.own.size.y; ++y)
            for (int x = 0; x < block.own.size.x; ++x)
                if ((band[at++] & 1) != 0)
                    count(block.own.begin + Vec3<int>{x, y, z}, counts);
    return counts;
}

void balance_by_interface(BlockLayout& layout, const PlaneCounts& core) {
    constexpr double cost =
        5.8; // what a cell of the band costs more, in cells of fluid (docs/performance.md)
    const double volume = static_cast<double>(CellBox{{}, layout.box()}.volume());
    for (int a = 0; a < 3; ++a) {
        std::vector<double> weight = band_cells(core[static_cast<std::size_t>(a)]);
        for (double& cells : weight)
            cells = cells * cost + volume / layout.box()[a];
        layout.balance(a, weight);
    }
}

} // namespace vesica
