#pragma once

#include <array>
#include <type_traits>
#include <utility>

/// For the lambdas of kernels: a call that stays a call costs more than what it does.
#define VESICA_INLINE_LAMBDA __attribute__((always_inline))

namespace vesica {

/// The D3Q19 velocity set in the order of Spendlove et al. 2021, Table I, which the rows of their collision
/// matrix follow. Everything that can be computed from the velocities is, and its laws are asserted below.
inline constexpr int direction_count = 19;

template <int i>
using Direction = std::integral_constant<int, i>;

namespace detail {

inline constexpr int velocities[direction_count][3] = {
    {0, 0, 0},  {1, 0, 0},  {1, -1, 0}, {0, -1, 0},  {-1, -1, 0}, {-1, 0, 0}, {-1, 1, 0},
    {0, 1, 0},  {1, 1, 0},  {0, 0, 1},  {1, 0, 1},   {0, 1, 1},   {-1, 0, 1}, {0, -1, 1},
    {0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, -1},
};

constexpr int squared_speed(int i) {
    int sum = 0;
    for (int a = 0; a < 3; ++a)
        sum += velocities[i][a] * velocities[i][a];
    return sum;
}

constexpr int find_opposite(int i) {
    for (int j = 0; j < direction_count; ++j) {
        bool opposes = true;
        for (int a = 0; a < 3; ++a)
            opposes = opposes && velocities[i][a] == -velocities[j][a];
        if (opposes)
            return j;
    }
    return -1;
}

} // namespace detail

constexpr int velocity(int i, int axis) {
    return detail::velocities[i][axis];
}

/// t_i: 1/3, 1/18, 1/36 for speeds 0, 1, sqrt 2.
constexpr double weight(int i) {
    const int c2 = detail::squared_speed(i);
    return c2 == 0 ? 1.0 / 3.0 : c2 == 1 ? 1.0 / 18.0 : 1.0 / 36.0;
}

/// g_i of the paper's Table I, the weights of its ghost modes: 1, -2, 1.
constexpr double ghost_weight(int i) {
    return detail::squared_speed(i) == 1 ? -2.0 : 1.0;
}

inline constexpr std::array<int, direction_count> opposites = [] {
    std::array<int, direction_count> table{};
    for (int i = 0; i < direction_count; ++i)
        table[static_cast<std::size_t>(i)] = detail::find_opposite(i);
    return table;
}();

constexpr int opposite(int i) {
    return opposites[static_cast<std::size_t>(i)];
}

inline constexpr double sound_speed_squared = 1.0 / 3.0;

namespace detail {

template <class Body, int... i>
[[gnu::always_inline]] constexpr void unroll(const Body& body, std::integer_sequence<int, i...>) {
    (body(Direction<i>{}), ...);
}

} // namespace detail

/// Calls body(Direction<0>{}) ... body(Direction<18>{}): direction indices are compile-time constants in
/// kernels.
template <class Body>
[[gnu::always_inline]] constexpr void for_each_direction(const Body& body) {
    detail::unroll(body, std::make_integer_sequence<int, direction_count>{});
}

namespace detail {

/// The first direction of each of the nine opposite pairs.
inline constexpr std::array<int, 9> pair_heads = [] {
    std::array<int, 9> heads{};
    std::size_t count = 0;
    for (int i = 1; i < direction_count; ++i)
        if (i < opposites[static_cast<std::size_t>(i)])
            heads[count++] = i;
    return heads;
}();

} // namespace detail

namespace detail {

template <class Body, std::size_t... k>
[[gnu::always_inline]] constexpr void unroll_pairs(const Body& body, std::index_sequence<k...>) {
    (body(Direction<pair_heads[k]>{}), ...);
}

} // namespace detail

/// Calls body(Direction<i>{}) for one direction of each of the nine opposite pairs.
template <class Body>
[[gnu::always_inline]] constexpr void for_each_pair(const Body& body) {
    detail::unroll_pairs(body, std::make_index_sequence<9>{});
}

namespace detail {

constexpr double weighted_moment(int px, int py, int pz) {
    double sum = 0.0;
    for (int i = 0; i < direction_count; ++i) {
        double term = weight(i);
        for (int k = 0; k < px; ++k)
            term *= velocity(i, 0);
        for (int k = 0; k < py; ++k)
            term *= velocity(i, 1);
        for (int k = 0; k < pz; ++k)
            term *= velocity(i, 2);
        sum += term;
    }
    return sum;
}

constexpr bool close(double a, double b) {
    return (a > b ? a - b : b - a) < 1e-15;
}

static_assert(close(weighted_moment(0, 0, 0), 1.0));
static_assert(close(weighted_moment(1, 0, 0), 0.0) && close(weighted_moment(1, 1, 0), 0.0));
static_assert(close(weighted_moment(2, 0, 0), 1.0 / 3.0) && close(weighted_moment(0, 2, 0), 1.0 / 3.0) &&
              close(weighted_moment(0, 0, 2), 1.0 / 3.0));
static_assert(close(weighted_moment(3, 0, 0), 0.0) && close(weighted_moment(1, 2, 0), 0.0));
static_assert(close(weighted_moment(4, 0, 0), 1.0 / 3.0) && close(weighted_moment(2, 2, 0), 1.0 / 9.0) &&
              close(weighted_moment(0, 2, 2), 1.0 / 9.0) && close(weighted_moment(2, 0, 2), 1.0 / 9.0));

} // namespace detail

} // namespace vesica
