#include "core/scales.hpp"

namespace vesica {
namespace {

// Repeated multiplication gives the same bits whatever the C library's pow does.
double power(double base, int exponent) {
    double result = 1.0;
    for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i)
        result *= base;
    return exponent < 0 ? 1.0 / result : result;
}

} // namespace

double Scales::unit(const Dimension& dimension) const {
    return power(cell, dimension.length + 3 * dimension.mass) * power(step, dimension.time) *
           power(density, dimension.mass);
}

double Scales::to_lattice(const Quantity& quantity) const {
    return quantity.value / unit(quantity.dimension);
}

Quantity Scales::to_si(double lattice, const Dimension& dimension) const {
    return {lattice * unit(dimension), dimension};
}

} // namespace vesica
