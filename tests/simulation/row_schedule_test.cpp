#include "simulation/row_schedule.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace vesica;

namespace {

/// What happens to the rows of a box when threads go through their shares one after the other.
struct Rows {
    Vec3<int> size;
    std::vector<int> worked;
    std::vector<int> settled;

    explicit Rows(const Vec3<int>& box) : size(box), worked(count(), 0), settled(count(), 0) {}

    std::size_t count() const { return static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z); }
    int y_of(std::int64_t row) const { return static_cast<int>(row % size.y); }
    int z_of(std::int64_t row) const { return static_cast<int>(row / size.y); }

    /// Have the row and all its neighbours been worked on, none of them across a face?
    bool neighbours_are_done(std::int64_t row) const {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                const int y = y_of(row) + dy;
                const int z = z_of(row) + dz;
                if (y < 0 || y >= size.y || z < 0 || z >= size.z ||
                    worked[static_cast<std::size_t>(y + size.y * z)] == 0)
                    return false;
            }
        return true;
    }
};

} // namespace

TEST_CASE("every row is worked on once and settles once, never before its neighbours are done") {
    const Vec3<int> size = GENERATE(Vec3<int>{8, 1, 1}, Vec3<int>{8, 2, 5}, Vec3<int>{8, 5, 2},
                                    Vec3<int>{8, 9, 7}, Vec3<int>{8, 16, 16}, Vec3<int>{8, 3, 40});
    const int block = GENERATE(1, 4, 5, 100);
    const std::int64_t threads = GENERATE(1, 2, 3, 7);
    const RowSchedule schedule(size, block);
    Rows rows(size);
    std::int64_t early = 0;
    for (std::int64_t thread = 0; thread < threads; ++thread) {
        const std::int64_t begin = schedule.rows() * thread / threads;
        const std::int64_t end = schedule.rows() * (thread + 1) / threads;
        Rows own(size); // a thread knows of its own rows only
        schedule.in_turn(
            begin, end,
            [&](std::int64_t row, std::int64_t next) {
                CHECK((row >= begin && row < end && next >= begin && next < end));
                ++rows.worked[static_cast<std::size_t>(row)];
                ++own.worked[static_cast<std::size_t>(row)];
            },
            [&](std::int64_t first, std::int64_t last) {
                for (std::int64_t row = first; row < last; ++row) {
                    CHECK(own.neighbours_are_done(row));
                    ++rows.settled[static_cast<std::size_t>(row)];
                    ++early;
                }
            });
        schedule.left_over(begin, end, [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t row = first; row < last; ++row) {
                CHECK((row >= begin && row < end));
                ++rows.settled[static_cast<std::size_t>(row)];
            }
        });
    }
    CHECK(rows.worked == std::vector<int>(rows.count(), 1));
    CHECK(rows.settled == std::vector<int>(rows.count(), 1));
    // No row waits that need not: those whose neighbours are all the same thread's settle early.
    std::int64_t can = 0;
    for (std::int64_t thread = 0; thread < threads; ++thread) {
        Rows share(size);
        for (std::int64_t row = schedule.rows() * thread / threads;
             row < schedule.rows() * (thread + 1) / threads; ++row)
            share.worked[static_cast<std::size_t>(row)] = 1;
        for (std::int64_t row = 0; row < schedule.rows(); ++row)
            can += share.neighbours_are_done(row) ? 1 : 0;
    }
    CHECK(early == can);
}

TEST_CASE("the row announced as the next is the next, but for the last of a block") {
    const RowSchedule schedule({8, 10, 6}, 4);
    std::int64_t announced = -1;
    int surprises = 0;
    schedule.in_turn(
        0, schedule.rows(),
        [&](std::int64_t row, std::int64_t next) {
            if (announced >= 0 && row != announced)
                ++surprises;
            announced = next;
        },
        [](std::int64_t, std::int64_t) {});
    CHECK(surprises == 2); // three blocks
}
