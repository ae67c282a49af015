#include "shape/perturbed_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace vesica {
namespace {

using std::numbers::pi;

constexpr int fewest_rows = 72;
constexpr int rows_per_degree = 8;  // a harmonic of degree l has l/2 waves from pole to pole
constexpr double difference = 1e-4; // step of numerical derivatives over the radius

Vec3<double> rotated(double r, double z, double azimuth) {
    return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

} // namespace

PerturbedShape::PerturbedShape(std::unique_ptr<const AxisymmetricShape> shape, HarmonicSeries series,
                               double radius)
    : shape_(std::move(shape)), series_(std::move(series)) {
    integrate(radius);
    lay_net();
}

/// With a = 1 + Y and g = grad Y (orthogonal to x), the map's derivative a I + x g has the determinant a^3,
/// so an element n dA of the smooth surface becomes a^2 (n - g (x.n)/a) dA, the cone under it a^3 times as
/// large.
void PerturbedShape::integrate(double radius) {
    // The trapezoidal rule is exact for the cubes and fourth powers of 1 + Y.
    const int columns = 4 * series_.highest() + 32;
    double area = 0.0;
    for (const MeridianSample& sample : shape_->meridian().samples(8)) {
        const MeridianPoint& p = sample.point;
        const double v = p.speed();
        const double element = 2.0 * pi / columns * p.r * v * sample.weight;
        for (int j = 0; j < columns; ++j) {
            const double azimuth = 2.0 * pi * j / columns;
            const Vec3<double> x = rotated(p.r, p.z, azimuth);
            const Vec3<double> n = rotated(-p.dz / v, p.dr / v, azimuth);
            const double distance = norm(x);
            const auto [value, slope] = series_((1.0 / distance) * x);
            const double a = 1.0 + value;
            const double height = dot(x, n);
            const double cone = a * a * a * height * element;
            volume_ += cone / 3.0;
            centre_ = centre_ + (a * cone / 4.0) * x;
            area += a * a * norm(n - (height / (a * distance)) * slope) * element;
        }
    }
    centre_ = (1.0 / volume_) * centre_;
    scale_ = radius / std::cbrt(volume_ * 3.0 / (4.0 * pi));
    volume_ *= scale_ * scale_ * scale_;
    area_ = area * scale_ * scale_;
}

void PerturbedShape::lay_net() {
    const Meridian& meridian = shape_->meridian();
    const int net_rows = std::max(fewest_rows, rows_per_degree * series_.highest());
    const int net_columns = 3 * net_rows / 2;
    const auto point = [&](int row, int column) {
        const MeridianPoint p = meridian.at(meridian.length() * row / net_rows);
        return moved(rotated(p.r, p.z, 2.0 * pi * column / net_columns));
    };
    const auto index = [=](int row, int column) {
        if (row == 0)
            return 0;
        if (row == net_rows)
            return 1;
        return 2 + (row - 1) * net_columns + column % net_columns;
    };
    net_.vertices = {point(0, 0), point(net_rows, 0)};
    for (int row = 1; row < net_rows; ++row)
        for (int column = 0; column < net_columns; ++column)
            net_.vertices.push_back(point(row, column));
    for (int row = 0; row < net_rows; ++row)
        for (int column = 0; column < net_columns; ++column) {
            const int a = index(row, column), b = index(row + 1, column);
            const int c = index(row + 1, column + 1), d = index(row, column + 1);
            if (b != c)
                net_.triangles.push_back({a, b, c});
            if (a != d)
                net_.triangles.push_back({a, c, d});
        }
    tree_ = std::make_unique<const TriangleTree>(net_);

    double longest_edge = 0.0;
    for (const auto& [a, b, c] : net_.triangles) {
        const auto vertex = [&](int i) {
            return net_.vertices[static_cast<std::size_t>(i)];
        };
        longest_edge = std::max({longest_edge, norm(vertex(a) - vertex(b)), norm(vertex(b) - vertex(c))});
    }
    for (const Vec3<double>& x : net_.vertices)
        bounding_radius_ = std::max(bounding_radius_, norm(x - centre_));
    bounding_radius_ = scale_ * (bounding_radius_ + longest_edge);

    double largest_curvature = 0.0;
    for (const Vec3<double>& x : net_.vertices) {
        const Curvature c = curvature(x, unit_normal(x));
        const double mean = 0.5 * (c.w11 + c.w22);
        const double deviation = std::hypot(0.5 * (c.w11 - c.w22), c.w12);
        largest_curvature = std::max(largest_curvature, std::abs(mean) + deviation);
    }
    smallest_radius_ = scale_ / largest_curvature;
}

Vec3<double> PerturbedShape::moved(const Vec3<double>& x) const {
    const double distance = norm(x);
    if (distance == 0.0)
        return x;
    return (1.0 + series_((1.0 / distance) * x).value) * x;
}

PerturbedShape::Level PerturbedShape::level(const Vec3<double>& x) const {
    const double distance = norm(x);
    if (distance == 0.0)
        return {shape_->signed_distance(x), {}};
    const auto [value, slope] = series_((1.0 / distance) * x);
    const double factor = 1.0 / (1.0 + value);
    const Foot foot = shape_->foot(factor * x);
    const double radial = dot(x, foot.normal) * factor * factor / distance;
    return {foot.distance, factor * foot.normal - radial * slope};
}

Vec3<double> PerturbedShape::unit_normal(const Vec3<double>& x) const {
    const Vec3<double> gradient = level(x).gradient;
    return (1.0 / norm(gradient)) * gradient;
}

PerturbedShape::Curvature PerturbedShape::curvature(const Vec3<double>& x, const Vec3<double>& n) const {
    Curvature c;
    const Vec3<double> aside =
        std::abs(n.x) < 0.6 ? Vec3<double>{1.0, 0.0, 0.0} : Vec3<double>{0.0, 1.0, 0.0};
    const Vec3<double> across = cross(n, aside);
    c.first = (1.0 / norm(across)) * across;
    c.second = cross(n, c.first);
    const double h = difference * shape_->bounding_radius();
    const auto derivative = [&](const Vec3<double>& e) {
        return (0.5 / h) * (unit_normal(x + h * e) - unit_normal(x - h * e));
    };
    const Vec3<double> along_first = derivative(c.first), along_second = derivative(c.second);
    c.w11 = dot(c.first, along_first);
    c.w12 = 0.5 * (dot(c.second, along_first) + dot(c.first, along_second));
    c.w22 = dot(c.second, along_second);
    return c;
}

/// Newton's method for y on the surface with x = y + d n(y). A tangential step e changes y + d n(y) by
/// (I + d W) e with W = dn, the shape operator, taken anew only where the last one no longer helps. What is
/// left over changes the distance in second order. Gives the fallback where the method does not converge: at
/// the centres of curvature, far from the surface.
double PerturbedShape::polished(const Vec3<double>& x, Vec3<double> y, double fallback) const {
    const double size = shape_->bounding_radius();
    double last = std::numeric_limits<double>::max();
    Curvature c;
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Level off = level(y);
        y = y - (off.value / dot(off.gradient, off.gradient)) * off.gradient;
        const Level on = level(y);
        const double slope = norm(on.gradient);
        const Vec3<double> n = (1.0 / slope) * on.gradient;
        const double d = dot(x - y, n);
        const Vec3<double> rest = x - y - d * n;
        const double missing = norm(rest);
        if (missing <= 2e-7 * size && std::abs(on.value) < 1e-7 * size)
            return d + on.value / slope;

        if (missing > 0.1 * last || iteration == 0)
            c = curvature(y, n);
        last = missing;
        const double m11 = 1.0 + d * c.w11, m12 = d * c.w12, m22 = 1.0 + d * c.w22;
        const double determinant = m11 * m22 - m12 * m12;
        // At a minimum of the distance both eigenvalues are positive.
        if (!(determinant > 1e-6) || !(m11 > 0.0))
            return fallback;
        const double r1 = dot(rest, c.first), r2 = dot(rest, c.second);
        Vec3<double> step = ((m22 * r1 - m12 * r2) / determinant) * c.first +
                            ((m11 * r2 - m12 * r1) / determinant) * c.second;
        const double longest = 0.05 * size;
        if (norm(step) > longest)
            step = (longest / norm(step)) * step;
        y = y + step;
    }
    return fallback;
}

double PerturbedShape::signed_distance(const Vec3<double>& position) const {
    const double beyond = norm(position) - bounding_radius_;
    if (beyond > reach)
        return beyond;
    const Vec3<double> x = (1.0 / scale_) * position + centre_;
    // The image of the smooth shape's closest point is on the surface and nearly the closest: the search has
    // only to look for something nearer.
    const double from_centre = norm(x);
    const double factor = from_centre > 0.0 ? 1.0 / (1.0 + series_((1.0 / from_centre) * x).value) : 1.0;
    const Foot foot = shape_->foot(factor * x);
    Vec3<double> y = moved(factor * x - foot.distance * foot.normal);
    const ClosestPoint nearer = tree_->closest(x, dot(x - y, x - y));
    if (nearer.triangle >= 0)
        y = nearer.position;
    const double distance = std::copysign(norm(x - y), foot.distance);
    if (scale_ * std::abs(distance) > reach)
        return scale_ * distance;
    return scale_ * polished(x, y, distance);
}

} // namespace vesica
