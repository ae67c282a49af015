#include "parallel/block_layout.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace vesica {

namespace {

constexpr int narrowest = BlockLayout::narrowest;

/// Cuts with which no slab is heavier than `limit`; empty if there are none. sums[k] is the weight of the
/// first k planes.
std::vector<int> cuts_below(const std::vector<double>& sums, int blocks, double limit) {
    const int planes = static_cast<int>(sums.size()) - 1;
    const auto at = [](int k) {
        return static_cast<std::size_t>(k);
    };
    // before[k][end]: where slab k can begin if it ends there and all before it are light enough; -1:
    // nowhere.
    std::vector<std::vector<int>> before(at(blocks), std::vector<int>(sums.size(), -1));
    for (int k = 0; k < blocks; ++k) {
        int lightest = 0; // the farthest begin that is light enough, by end
        int nearest = -1; // the last begin that slabs before can reach
        int looked_at = -1;
        for (int end = narrowest; end <= planes; ++end) {
            while (looked_at < end - narrowest) {
                ++looked_at;
                const bool reached = k == 0 ? looked_at == 0 : before[at(k - 1)][at(looked_at)] >= 0;
                if (reached)
                    nearest = looked_at;
            }
            while (sums[at(end)] - sums[at(lightest)] > limit)
                ++lightest;
            if (nearest >= lightest)
                before[at(k)][at(end)] = nearest;
        }
    }
    std::vector<int> cuts{planes};
    for (int k = blocks - 1; k >= 0; --k) {
        const int begin = before[at(k)][at(cuts.back())];
        if (begin < 0)
            return {};
        cuts.push_back(begin);
    }
    std::reverse(cuts.begin(), cuts.end());
    return cuts;
}

} // namespace

BlockLayout::BlockLayout(const Vec3<int>& box, const Vec3<int>& blocks, const std::optional<Slide>& slide)
    : box_(box), slide_(slide) {
    assert(fits(box, blocks, slide));
    for (int a = 0; a < 3; ++a)
        for (int k = 0; k <= blocks[a]; ++k)
            cuts_[a].push_back(static_cast<int>(std::int64_t{box[a]} * k / blocks[a]));
}

Vec3<int> BlockLayout::blocks() const {
    return {static_cast<int>(cuts_[0].size()) - 1, static_cast<int>(cuts_[1].size()) - 1,
            static_cast<int>(cuts_[2].size()) - 1};
}

int BlockLayout::count() const {
    const Vec3<int> n = blocks();
    return n.x * n.y * n.z;
}

Block BlockLayout::block(const Vec3<int>& place) const {
    Block block;
    block.box = box_;
    block.slide = slide_;
    const Vec3<int> n = blocks();
    for (int a = 0; a < 3; ++a) {
        block.own.begin[a] = cut(a, place[a]);
        block.own.size[a] = cut(a, place[a] + 1) - cut(a, place[a]);
        block.divided[a] = n[a] > 1 || (slide_ && slide_->gradient == a);
    }
    return block;
}

void BlockLayout::balance(int axis, const std::vector<double>& weight) {
    assert(static_cast<int>(weight.size()) == box_[axis]);
    const int n = blocks()[axis];
    if (n == 1)
        return;
    std::vector<double> sums(weight.size() + 1, 0.0);
    std::partial_sum(weight.begin(), weight.end(), sums.begin() + 1);
    // Bisection on the heaviest slab's weight: 50 halvings tell any two sums apart that matter.
    double too_light = 0.0;
    double enough = sums.back();
    std::vector<int> best;
    for (int halving = 0; halving < 50; ++halving) {
        const double limit = 0.5 * (too_light + enough);
        std::vector<int> cuts = cuts_below(sums, n, limit);
        (cuts.empty() ? too_light : enough) = limit;
        if (!cuts.empty())
            best = std::move(cuts);
    }
    if (!best.empty())
        cuts_[axis] = std::move(best);
}

bool fits(const Vec3<int>& box, const Vec3<int>& blocks, const std::optional<Slide>& slide) {
    if (slide && (blocks[slide->velocity] != 1 || box[slide->gradient] < narrowest))
        return false;
    for (int a = 0; a < 3; ++a)
        if (blocks[a] < 1 || (blocks[a] > 1 && box[a] / blocks[a] < narrowest))
            return false;
    return true;
}

std::optional<Vec3<int>> choose_blocks(const Vec3<int>& box, int count, const std::optional<Slide>& slide) {
    std::optional<Vec3<int>> best;
    double least = std::numeric_limits<double>::max();
    const double volume = 1.0 * box.x * box.y * box.z;
    for (int z = count; z >= 1; --z) {
        if (count % z != 0)
            continue;
        for (int y = count / z; y >= 1; --y) {
            if (count / z % y != 0)
                continue;
            const Vec3<int> blocks{count / z / y, y, z};
            if (!fits(box, blocks, slide))
                continue;
            double faces = 0.0; // cells on the faces of one block, by the whole box
            for (int a = 0; a < 3; ++a)
                if (blocks[a] > 1)
                    faces += (a == 0 ? 2.0 : 1.0) * blocks[a] * volume / box[a];
            if (faces < least) {
                least = faces;
                best = blocks;
            }
        }
    }
    return best;
}

int most_blocks(const Vec3<int>& box, int count, const std::optional<Slide>& slide) {
    while (count > 1 && !choose_blocks(box, count, slide))
        --count;
    return count;
}

} // namespace vesica
