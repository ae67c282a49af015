#pragma once

#include "case/parameters.hpp"
#include "parallel/block_layout.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace vesica {

/// What block boundaries are chosen for.
enum class Balance { cells, interface };

/// The blocks of so many ranks: those given, or the cheapest to exchange. Throws InputError where the box
/// cannot be cut so.
BlockLayout layout_for(const Vec3<int>& box, int ranks, const std::optional<Vec3<int>>& blocks,
                       const std::optional<Slide>& slide = {});

/// The slide of a case's box.
std::optional<Slide> slide_of(const Parameters& parameters);

/// Core cells of the interfaces in each plane of the whole box, by axis.
using PlaneCounts = std::array<std::vector<std::uint64_t>, 3>;

/// Those of a block, at the start of a case and in a checkpoint. Throw InputError, RunError.
PlaneCounts core_of_case(const Parameters& parameters, const Block& block, int threads);
PlaneCounts core_of_checkpoint(const std::filesystem::path& checkpoint, const Block& block);

/// Moves the layout's boundaries so that slabs weigh about the same, given the core of the whole box.
void balance_by_interface(BlockLayout& layout, const PlaneCounts& core);

} // namespace vesica
