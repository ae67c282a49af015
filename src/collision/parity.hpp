#pragma once

#include "lattice/velocity_set.hpp"

namespace vesica {

/// Calls body(Direction<0>{}), body(Direction<1>{}), body(Direction<2>{}): x, y, z.
template <class Body>
[[gnu::always_inline]] constexpr void for_each_axis(const Body& body) {
    detail::unroll(body, std::make_integer_sequence<int, 3>{});
}

/// The 19 populations as sums (even) and differences (odd) of opposite ones. Every moment and every mode of
/// the collisions is even or odd under c -> -c, and a short sum of these numbers. A plane is named by the
/// axis k across it; its diagonals run along the axes k + 1 (its first) and k + 2 (its second). After a
/// collision they hold what `join` makes populations of: each direction's own share, not the pair's.
template <class V>
struct EvenParts {
    V rest;
    V axis[3];  ///< the pair along the axis
    V plane[3]; ///< both pairs of the plane's diagonals
    V shear[3]; ///< the pair on the rising diagonal less the one on the falling diagonal
};

template <class V>
struct OddParts {
    V axis[3];   ///< momentum the pair along the axis has
    V first[3];  ///< momentum the plane's diagonals have along its first axis, and
    V second[3]; ///< along its second one
};

namespace detail {

/// The direction with one along an axis, `second` along the axis after it, and nothing else.
constexpr int find_direction(int axis, int second) {
    for (int i = 1; i < direction_count; ++i)
        if (velocity(i, axis) == 1 && velocity(i, (axis + 1) % 3) == second &&
            velocity(i, (axis + 2) % 3) == 0)
            return i;
    return -1;
}

} // namespace detail

constexpr int along_axis(int axis) {
    return detail::find_direction(axis, 0);
}
constexpr int rising_diagonal(int plane) {
    return detail::find_direction((plane + 1) % 3, 1);
}
constexpr int falling_diagonal(int plane) {
    return detail::find_direction((plane + 1) % 3, -1);
}

namespace detail {

constexpr bool parts_cover_all_directions() {
    int times[direction_count] = {1};
    for (int k = 0; k < 3; ++k)
        for (const int head : {along_axis(k), rising_diagonal(k), falling_diagonal(k)}) {
            if (head < 0)
                return false;
            ++times[head];
            ++times[opposite(head)];
        }
    for (const int count : times)
        if (count != 1)
            return false;
    return true;
}
static_assert(parts_cover_all_directions());

} // namespace detail

template <class V>
[[gnu::always_inline]] constexpr EvenParts<V> even_parts(const V (&g)[direction_count]) {
    EvenParts<V> even;
    even.rest = g[0];
    for_each_axis([&](auto k) VESICA_INLINE_LAMBDA {
        constexpr int along = along_axis(k);
        constexpr int rising = rising_diagonal(k);
        constexpr int falling = falling_diagonal(k);
        even.axis[k] = g[along] + g[opposite(along)];
        const V on_rising = g[rising] + g[opposite(rising)];
        const V on_falling = g[falling] + g[opposite(falling)];
        even.plane[k] = on_rising + on_falling;
        even.shear[k] = on_rising - on_falling;
    });
    return even;
}

template <class V>
[[gnu::always_inline]] constexpr OddParts<V> odd_parts(const V (&g)[direction_count]) {
    OddParts<V> odd;
    for_each_axis([&](auto k) VESICA_INLINE_LAMBDA {
        constexpr int along = along_axis(k);
        constexpr int rising = rising_diagonal(k);
        constexpr int falling = falling_diagonal(k);
        odd.axis[k] = g[along] - g[opposite(along)];
        const V on_rising = g[rising] - g[opposite(rising)];
        const V on_falling = g[falling] - g[opposite(falling)];
        odd.first[k] = on_rising + on_falling;
        odd.second[k] = on_rising - on_falling;
    });
    return odd;
}

/// The populations of which each direction has `even` plus `odd` and its opposite `even` less `odd`, where
/// the rising diagonal has plane + shear and first + second, the falling one plane - shear and
/// first - second. Of what even_parts and odd_parts find, `rest` is whole, `axis` halves, the others
/// quarters.
template <class V>
[[gnu::always_inline]] constexpr void join(const EvenParts<V>& even, const OddParts<V>& odd,
                                           V (&g)[direction_count]) {
    g[0] = even.rest;
    for_each_axis([&](auto k) VESICA_INLINE_LAMBDA {
        const auto pair = [&](auto head, const V& sum, const V& difference) VESICA_INLINE_LAMBDA {
            g[head] = sum + difference;
            g[opposite(head)] = sum - difference;
        };
        pair(Direction<along_axis(k)>{}, even.axis[k], odd.axis[k]);
        pair(Direction<rising_diagonal(k)>{}, even.plane[k] + even.shear[k], odd.first[k] + odd.second[k]);
        pair(Direction<falling_diagonal(k)>{}, even.plane[k] - even.shear[k], odd.first[k] - odd.second[k]);
    });
}

} // namespace vesica
