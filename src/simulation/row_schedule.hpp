#pragma once

#include "core/vec3.hpp"

#include <algorithm>
#include <cstdint>

namespace vesica {

/// In which order a thread goes through its rows of the box, and when the populations of a row have settled:
/// as soon as the row and its eight neighbours have been collided and streamed nothing will write there any
/// more, and whoever reads them finds them still in the cache. Rows are numbered y + size.y z; a thread has
/// those from `begin` to `end`. Rows at the box's faces settle with the boundary only, and rows beside
/// another thread's with the slower of the two: they are left over.
class RowSchedule {
public:
    /// Blocks of `rows_in_block` rows along y, each through all z: three planes of a block are what a cache
    /// should hold. Where the rows' ends wait for other ranks (`ends_wait`) no row settles before the
    /// boundary.
    RowSchedule(const Vec3<int>& size, int rows_in_block, bool ends_wait = false)
        : size_(size), block_(rows_in_block), ends_wait_(ends_wait) {}

    std::int64_t rows() const { return std::int64_t{size_.y} * size_.z; }

    /// work(row, next row) for all rows, and settled(first, last) for those that have settled by then.
    template <class Work, class Settled>
    void in_turn(std::int64_t begin, std::int64_t end, const Work& work, const Settled& settled) const {
        for (int y = 0; y < size_.y; y += block_) {
            const int y_end = std::min(y + block_, size_.y);
            for (std::int64_t z = begin / size_.y; z * size_.y < end; ++z) {
                const std::int64_t last = std::min(end, row(y_end, z));
                for (std::int64_t k = std::max(begin, row(y, z)); k < last; ++k)
                    work(k, std::min(k + 1 < last ? k + 1 : std::max(begin, row(y, z + 1)), end - 1));
                // A plane behind, and a row: the block's last row waits for the block above.
                const Rows early = settling_in(z - 1, begin, end);
                const Rows now = {std::max(early.first, row(y - 1, z - 1)),
                                  std::min(early.last, row(y_end - 1, z - 1))};
                if (now.first < now.last)
                    settled(now.first, now.last);
            }
        }
    }

    /// settled(first, last) for all others, once the boundary is done.
    template <class Settled>
    void left_over(std::int64_t begin, std::int64_t end, const Settled& settled) const {
        for (std::int64_t z = begin / size_.y; z * size_.y < end; ++z) {
            const Rows own = {std::max(begin, row(0, z)), std::min(end, row(0, z + 1))};
            const Rows early = settling_in(z, begin, end);
            const bool none = early.first >= early.last;
            const Rows below = {own.first, none ? own.last : early.first};
            const Rows above = {none ? own.last : early.last, own.last};
            for (const Rows& rest : {below, above})
                if (rest.first < rest.last)
                    settled(rest.first, rest.last);
        }
    }

private:
    struct Rows {
        std::int64_t first;
        std::int64_t last;
    };

    std::int64_t row(int y, std::int64_t z) const { return y + z * size_.y; }

    /// Rows of a plane that have all neighbours among this thread's and none across a face.
    Rows settling_in(std::int64_t z, std::int64_t begin, std::int64_t end) const {
        if (ends_wait_ || z < 1 || z > size_.z - 2)
            return {0, 0};
        const std::int64_t to_corner = size_.y + 1;
        return {std::max(row(1, z), begin + to_corner), std::min(row(size_.y - 1, z), end - to_corner)};
    }

    Vec3<int> size_;
    int block_;
    bool ends_wait_;
};

} // namespace vesica
