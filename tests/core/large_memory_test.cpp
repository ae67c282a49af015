#include "core/large_memory.hpp"

#include <catch2/catch.hpp>

#include <cstdint>

using namespace vesica;

TEST_CASE("large arrays begin at a cache line, and at a huge page once they fill two") {
    const auto address = [](const auto& array) {
        return reinterpret_cast<std::uintptr_t>(array.get());
    };
    const auto small = large_array<float>(1000);
    CHECK(address(small) % 64 == 0);
    constexpr std::size_t count = (std::size_t{2} << 21) / sizeof(double);
    const auto large = large_array<double>(count);
    CHECK(address(large) % (std::uintptr_t{1} << 21) == 0);
    large[0] = 1.0;
    large[count - 1] = 2.0;
    CHECK(large[0] + large[count - 1] == 3.0);
}

TEST_CASE("a large array of nothing is no error") {
    CHECK_NOTHROW(large_array<double>(0));
}

TEST_CASE("a count whose bytes cannot be counted is refused") {
    CHECK_THROWS_AS(large_array<double>(std::size_t{1} << 61), std::bad_alloc);
}
