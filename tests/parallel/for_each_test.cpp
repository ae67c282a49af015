#include "parallel/for_each.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace vesica;

TEST_CASE("every index is visited exactly once by any number of threads", "[parallel]") {
    for (int threads = 1; threads <= 4; ++threads)
        for (const std::int64_t count :
             {std::int64_t{0}, std::int64_t{1}, std::int64_t{3}, std::int64_t{1000}}) {
            std::vector<int> visits(static_cast<std::size_t>(count), 0);
            for_each_index(count, threads, [&](std::int64_t k) { ++visits[static_cast<std::size_t>(k)]; });
            CHECK(std::count(visits.begin(), visits.end(), 1) == count);
        }
}

TEST_CASE("blocks are contiguous, cover every index once and know whose they are", "[parallel]") {
    for (int threads = 1; threads <= 4; ++threads)
        for (const std::int64_t count :
             {std::int64_t{0}, std::int64_t{1}, std::int64_t{3}, std::int64_t{1000}}) {
            std::vector<int> visits(static_cast<std::size_t>(count), 0);
            std::vector<int> calls(static_cast<std::size_t>(threads), 0);
            for_each_block(count, threads, [&](int thread, std::int64_t begin, std::int64_t end) {
                ++calls[static_cast<std::size_t>(thread)];
                for (std::int64_t k = begin; k < end; ++k)
                    ++visits[static_cast<std::size_t>(k)];
            });
            CHECK(std::count(visits.begin(), visits.end(), 1) == count);
            CHECK(*std::max_element(calls.begin(), calls.end()) == 1);
            CHECK(calls[0] == 1);
        }
}
