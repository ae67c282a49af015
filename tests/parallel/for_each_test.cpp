#include "parallel/for_each.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
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

TEST_CASE("numbers below the smallest normal one are zero to the bodies, and to nobody else", "[parallel]") {
    volatile double smallest = std::numeric_limits<double>::min();
    volatile double half = 0.5;
    for (int threads = 1; threads <= 3; ++threads) {
        std::vector<double> halved(static_cast<std::size_t>(threads), 1.0);
        for_each_block(threads, threads, [&](int thread, std::int64_t, std::int64_t) {
            halved[static_cast<std::size_t>(thread)] = smallest * half;
        });
#if defined(__SSE2__)
        CHECK(std::count(halved.begin(), halved.end(), 0.0) == threads);
#endif
        CHECK(smallest * half > 0.0);
    }
}
