#pragma once

#include "collision/forcing.hpp"
#include "lattice/velocity_set.hpp"

#include <array>
#include <utility>

namespace vesica {

/// The basis of Spendlove et al. 2021, Table VI, with its misprint h14 = c_x^2 c_y read as c_x c_y^2 (as
/// printed the rank is 18). Not symmetric: x, y and z are treated alike only if lambda_11 = lambda_14 and
/// lambda_10 = lambda_17 = lambda_4.
namespace paper_basis {

constexpr double row(int p, int i) {
    const double x = velocity(i, 0);
    const double y = velocity(i, 1);
    const double z = velocity(i, 2);
    const double g = ghost_weight(i);
    const double rows[direction_count] = {1,         x,         y,         z,         x * x,    y * y, z * z,
                                          x * y,     x * z,     y * z,     g,         g * x,    g * y, g * z,
                                          x * y * y, x * x * y, x * x * z, g * y * y, g * x * x};
    return rows[p];
}

using Matrix = std::array<std::array<double, direction_count>, direction_count>;

constexpr Matrix matrix() {
    Matrix m{};
    for (std::size_t p = 0; p < direction_count; ++p)
        for (std::size_t i = 0; i < direction_count; ++i)
            m[p][i] = row(static_cast<int>(p), static_cast<int>(i));
    return m;
}

/// Gauss-Jordan elimination with row pivoting, at compile time; entries are multiples of 1/24.
constexpr Matrix inverse() {
    Matrix a = matrix();
    Matrix b{};
    for (std::size_t k = 0; k < direction_count; ++k)
        b[k][k] = 1.0;
    const auto absolute = [](double value) {
        return value < 0 ? -value : value;
    };
    for (std::size_t column = 0; column < direction_count; ++column) {
        std::size_t pivot = column;
        for (std::size_t r = column + 1; r < direction_count; ++r)
            if (absolute(a[r][column]) > absolute(a[pivot][column]))
                pivot = r;
        std::swap(a[column], a[pivot]);
        std::swap(b[column], b[pivot]);
        const double scale = 1.0 / a[column][column];
        for (std::size_t k = 0; k < direction_count; ++k) {
            a[column][k] *= scale;
            b[column][k] *= scale;
        }
        for (std::size_t r = 0; r < direction_count; ++r) {
            if (r == column)
                continue;
            const double factor = a[r][column];
            if (factor == 0.0)
                continue;
            for (std::size_t k = 0; k < direction_count; ++k) {
                a[r][k] -= factor * a[column][k];
                b[r][k] -= factor * b[column][k];
            }
        }
    }
    for (auto& entries : b)
        for (double& entry : entries) {
            const double units = entry * 24.0;
            const double rounded =
                static_cast<double>(static_cast<long long>(units < 0 ? units - 0.5 : units + 0.5));
            entry = rounded / 24.0;
        }
    return b;
}

inline constexpr Matrix M = matrix();
inline constexpr Matrix M_inverse = inverse();

constexpr bool inverse_is_exact() {
    for (std::size_t p = 0; p < direction_count; ++p)
        for (std::size_t q = 0; q < direction_count; ++q) {
            double sum = 0.0;
            for (std::size_t i = 0; i < direction_count; ++i)
                sum += M[p][i] * M_inverse[i][q];
            if (!detail::close(sum, p == q ? 1.0 : 0.0))
                return false;
        }
    return true;
}

static_assert(inverse_is_exact());

} // namespace paper_basis

/// f* = f + M^-1 [Lambda (m0 - m) + S] with the consistent source S_p = (1 - lambda_p/2) x moment p of Guo's
/// term.
struct PaperMrt {
    double l10 = 1.0;
    double l11 = 1.0;
    double l14 = 1.0;
    double l17 = 1.0;

    template <class V>
    [[gnu::always_inline]] constexpr void operator()(V (&g)[direction_count], const Vec3<V>& F, const V& rate,
                                                     const V& reference_density) const {
        const Moments<V> hydrodynamic = moments_of(g);
        const Vec3<V> u = velocity_of(hydrodynamic, reference_density, F);
        const V density = reference_density + hydrodynamic.density_deviation;
        // Equilibrium and Guo's term carry no t-orthogonal ghost part: both are the populations of ten
        // moments.
        V equilibrium[direction_count];
        V source[direction_count];
        populations_of(equilibrium_moments(density, reference_density, u), equilibrium);
        populations_of(Moments<V>{V(0), F, source_stress(F, u)}, source);

        V change[direction_count];
        for_each_direction([&](auto p) VESICA_INLINE_LAMBDA {
            V deficit = V(0);
            V forced = V(0);
            for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
                constexpr double entry = paper_basis::M[decltype(p)::value][decltype(i)::value];
                if constexpr (entry != 0.0) {
                    deficit = fma(V(entry), equilibrium[i] - g[i], deficit);
                    forced = fma(V(entry), source[i], forced);
                }
            });
            const V lambda = rate_of<decltype(p)::value>(rate);
            change[p] = fma(lambda, deficit, fma(V(-0.5), lambda, V(1)) * forced);
        });
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            V sum = g[i];
            for_each_direction([&](auto p) VESICA_INLINE_LAMBDA {
                constexpr double entry = paper_basis::M_inverse[decltype(i)::value][decltype(p)::value];
                if constexpr (entry != 0.0)
                    sum = fma(V(entry), change[p], sum);
            });
            g[i] = sum;
        });
    }

private:
    template <int p, class V>
    [[gnu::always_inline]] constexpr V rate_of(const V& rate) const {
        if constexpr (p == 0)
            return V(0);
        // With u holding F/2, m0 - m is F/2 here; any rate r gives r F/2 + (1 - r/2) F = F: momentum changes
        // by F.
        else if constexpr (p <= 3)
            return V(0.5);
        else if constexpr (p <= 9)
            return rate;
        else if constexpr (p == 10)
            return V(l10);
        else if constexpr (p <= 13)
            return V(l11);
        else if constexpr (p <= 16)
            return V(l14);
        else
            return V(l17);
    }
};

} // namespace vesica
