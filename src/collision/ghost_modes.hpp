#pragma once

#include "lattice/velocity_set.hpp"

namespace vesica {

/// The nine ghost modes of D3Q19 that are orthogonal, under the weights t_i, to each other and to rho, j and
/// Pi. Their equilibria vanish, and each family below is mapped onto itself by the 48 symmetries of the cube,
/// so a rate per family treats x, y and z alike.
enum class GhostFamily { odd_vector, odd_twist, even_scalar, even_tensor };

inline constexpr int ghost_mode_count = 9;

constexpr GhostFamily ghost_family(int mode) {
    return mode < 3    ? GhostFamily::odd_vector
           : mode < 6  ? GhostFamily::odd_twist
           : mode == 6 ? GhostFamily::even_scalar
                       : GhostFamily::even_tensor;
}

constexpr double ghost_mode(int mode, int i) {
    const double c[3] = {double(velocity(i, 0)), double(velocity(i, 1)), double(velocity(i, 2))};
    const double c2 = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    if (mode < 3)
        return (3 * c2 - 5) * c[mode];
    if (mode < 6) {
        const int x = mode - 3;
        const int y = (x + 1) % 3;
        const int z = (x + 2) % 3;
        return (c[y] * c[y] - c[z] * c[z]) * c[x];
    }
    if (mode == 6)
        return 3 * c2 * c2 - 6 * c2 + 1;
    if (mode == 7)
        return (2 * c2 - 3) * (3 * c[0] * c[0] - c2);
    return (2 * c2 - 3) * (c[1] * c[1] - c[2] * c[2]);
}

/// sum_i t_i h_i^2
constexpr double ghost_norm(int mode) {
    double sum = 0.0;
    for (int i = 0; i < direction_count; ++i)
        sum += weight(i) * ghost_mode(mode, i) * ghost_mode(mode, i);
    return sum;
}

namespace detail {

constexpr double ghost_overlap(int mode, int px, int py, int pz) {
    double sum = 0.0;
    for (int i = 0; i < direction_count; ++i) {
        double term = weight(i) * ghost_mode(mode, i);
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

constexpr bool ghosts_are_orthogonal_to_hydrodynamics() {
    for (int mode = 0; mode < ghost_mode_count; ++mode)
        for (int px = 0; px <= 2; ++px)
            for (int py = 0; px + py <= 2; ++py)
                for (int pz = 0; px + py + pz <= 2; ++pz)
                    if (!close(ghost_overlap(mode, px, py, pz), 0.0))
                        return false;
    return true;
}

/// The first six change sign under c -> -c, the others do not.
constexpr bool ghosts_are_odd_and_even() {
    for (int mode = 0; mode < ghost_mode_count; ++mode)
        for (int i = 0; i < direction_count; ++i)
            if (ghost_mode(mode, opposite(i)) != (mode < 6 ? -1.0 : 1.0) * ghost_mode(mode, i))
                return false;
    return true;
}
static_assert(ghosts_are_odd_and_even());

constexpr bool ghosts_are_orthogonal_to_each_other() {
    for (int a = 0; a < ghost_mode_count; ++a)
        for (int b = 0; b < a; ++b) {
            double sum = 0.0;
            for (int i = 0; i < direction_count; ++i)
                sum += weight(i) * ghost_mode(a, i) * ghost_mode(b, i);
            if (!close(sum, 0.0))
                return false;
        }
    return true;
}

static_assert(ghosts_are_orthogonal_to_hydrodynamics());
static_assert(ghosts_are_orthogonal_to_each_other());
static_assert(close(ghost_norm(0), 2.0 / 3.0) && close(ghost_norm(3), 2.0 / 9.0) &&
              close(ghost_norm(6), 2.0) && close(ghost_norm(7), 4.0 / 3.0) &&
              close(ghost_norm(8), 4.0 / 9.0));

} // namespace detail

} // namespace vesica
