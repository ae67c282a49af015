#include "shape/spherical_harmonics.hpp"

#include <cassert>
#include <cmath>
#include <cstdlib>

namespace vesica {

void HarmonicSeries::add(int l, int m, double coefficient) {
    assert(l >= 0 && std::abs(m) <= l);
    if (l > highest_) {
        highest_ = l;
        coefficients_.resize(static_cast<std::size_t>((l + 1) * (l + 1)), 0.0);
        polynomial_coefficients_.resize(coefficients_.size(), 0.0);
    }
    coefficients_[static_cast<std::size_t>(l * (l + 1) + m)] += coefficient;
    double ratio = m == 0 ? 1.0 : 2.0; // (l - |m|)!/(l + |m|)!, twice that
    for (int k = l - std::abs(m) + 1; k <= l + std::abs(m); ++k)
        ratio /= k;
    polynomial_coefficients_[static_cast<std::size_t>(l * (l + 1) + m)] += std::sqrt(ratio) * coefficient;
}

double HarmonicSeries::root_mean_square() const {
    double sum = 0.0;
    for (int l = 0; l <= highest_; ++l)
        for (int m = -l; m <= l; ++m)
            sum += coefficient(l, m) * coefficient(l, m) / (2 * l + 1);
    return std::sqrt(sum);
}

/// On the unit sphere P_l^m = sin^m(theta) Q_lm(z) with polynomials Q_lm = d^m P_l/dz^m, and sin^m e^(i m
/// azimuth) = (x + i y)^m, so that everything is a polynomial in x, y, z: smooth at the poles. The gradient
/// of the sum's extension by polynomials is made tangential at the end.
HarmonicSeries::Value HarmonicSeries::operator()(const Vec3<double>& direction) const {
    const auto [x, y, z] = direction;
    Value sum;
    double real = 1.0, imaginary = 0.0;             // (x + i y)^m
    double real_below = 0.0, imaginary_below = 0.0; // (x + i y)^(m - 1)
    double diagonal = 1.0;                          // Q_mm = (2m - 1)!!
    for (int m = 0; m <= highest_; ++m) {
        double q = diagonal, q_below = 0.0;    // Q_lm, Q_(l-1)m
        double slope = 0.0, slope_below = 0.0; // their derivatives by z
        for (int l = m; l <= highest_; ++l) {
            const double a = polynomial_coefficients_[static_cast<std::size_t>(l * (l + 1) + m)];
            const double b =
                m == 0 ? 0.0 : polynomial_coefficients_[static_cast<std::size_t>(l * (l + 1) - m)];
            const double angular = a * real + b * imaginary;
            sum.value += q * angular;
            sum.gradient.z += slope * angular;
            sum.gradient.x += q * m * (a * real_below + b * imaginary_below);
            sum.gradient.y += q * m * (b * real_below - a * imaginary_below);

            const double q_next = ((2 * l + 1) * z * q - (l + m) * q_below) / (l + 1 - m);
            const double slope_next = ((2 * l + 1) * (q + z * slope) - (l + m) * slope_below) / (l + 1 - m);
            q_below = q;
            q = q_next;
            slope_below = slope;
            slope = slope_next;
        }
        real_below = real;
        imaginary_below = imaginary;
        real = x * real_below - y * imaginary_below;
        imaginary = x * imaginary_below + y * real_below;
        diagonal *= 2 * m + 1;
    }
    sum.gradient = sum.gradient - dot(sum.gradient, direction) * direction;
    return sum;
}

} // namespace vesica
