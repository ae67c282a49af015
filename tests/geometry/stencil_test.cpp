#include "geometry/normal.hpp"
#include "geometry/stencil.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>

using namespace vesica;

namespace {

/// A function of space seen from a point, at lattice spacing h: what a stencil asks for.
template <class Function>
struct Around {
    Function function;
    Vec3<double> centre;
    double h;

    template <int i>
    double operator()(Direction<i>) const {
        return function(centre + h * Vec3<double>{double(velocity(i, 0)), double(velocity(i, 1)),
                                                  double(velocity(i, 2))});
    }
};

template <class Function>
Around<Function> around(const Function& function, const Vec3<double>& centre, double h = 1.0) {
    return {function, centre, h};
}

constexpr auto wave = [](const Vec3<double>& x) {
    return std::sin(0.7 * x.x + 0.2) * std::cos(1.1 * x.y) * std::sin(0.9 * x.z - 0.5);
};

Vec3<double> wave_gradient(const Vec3<double>& x) {
    const double a = 0.7 * x.x + 0.2;
    const double b = 1.1 * x.y;
    const double c = 0.9 * x.z - 0.5;
    return {0.7 * std::cos(a) * std::cos(b) * std::sin(c), -1.1 * std::sin(a) * std::sin(b) * std::sin(c),
            0.9 * std::sin(a) * std::cos(b) * std::cos(c)};
}

const Vec3<double> point{0.3, 0.8, -1.2};

} // namespace

TEST_CASE("the gradient of a quadratic function is exact", "[geometry]") {
    const auto q = [](const Vec3<double>& x) {
        return 3.0 - 2.0 * x.x + 0.5 * x.y + x.z + 0.7 * x.x * x.x - 0.3 * x.y * x.y + x.z * x.z + x.x * x.y -
               2.0 * x.y * x.z + 0.4 * x.x * x.z;
    };
    const Vec3<double> expected{-2.0 + 1.4 * point.x + point.y + 0.4 * point.z,
                                0.5 - 0.6 * point.y + point.x - 2.0 * point.z,
                                1.0 + 2.0 * point.z - 2.0 * point.y + 0.4 * point.x};
    CHECK(norm(gradient<double>(around(q, point)) - expected) < 1e-14);
}

TEST_CASE("the Laplacian of a cubic function is exact", "[geometry]") {
    const auto q = [](const Vec3<double>& x) {
        return 1.0 - x.x + 0.7 * x.x * x.x - 0.3 * x.y * x.y + x.z * x.z + x.x * x.y - 2.0 * x.y * x.z +
               x.x * x.x * x.x - x.x * x.y * x.y + 3.0 * x.x * x.y * x.z;
    };
    CHECK(laplacian<double>(around(q, point)) ==
          Approx(1.4 - 0.6 + 2.0 + 6.0 * point.x - 2.0 * point.x).epsilon(1e-13));
}

TEST_CASE("gradient and Laplacian are second order", "[geometry]") {
    double gradient_error[3];
    double laplacian_error[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const double h = 0.2 / static_cast<double>(1 << k);
        const Vec3<double> found = gradient<double>(around(wave, point, h));
        gradient_error[k] = norm((1.0 / h) * found - wave_gradient(point));
        const double exact = -(0.49 + 1.21 + 0.81) * wave(point);
        laplacian_error[k] = std::abs(laplacian<double>(around(wave, point, h)) / (h * h) - exact);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::log2(gradient_error[k] / gradient_error[k + 1]) == Approx(2.0).margin(0.05));
        CHECK(std::log2(laplacian_error[k] / laplacian_error[k + 1]) == Approx(2.0).margin(0.05));
    }
    // The leading error of the gradient is (h^2/6) grad Lap q: that of a wave, along the gradient itself.
    const double h = 0.05;
    const Vec3<double> error = (1.0 / h) * gradient<double>(around(wave, point, h)) - wave_gradient(point);
    const Vec3<double> leading = (-h * h / 6.0 * (0.49 + 1.21 + 0.81)) * wave_gradient(point);
    CHECK(norm(error - leading) < 1e-3 * norm(leading));
}

TEST_CASE("the Jacobian's rows are the gradients of the components", "[geometry]") {
    // q_i = A_ij x_j
    const double A[3][3] = {{1, 2, 3}, {-4, 5, 6}, {7, -8, 9}};
    const auto component = [&](int i) {
        return [&A, i](const Vec3<double>& x) {
            return A[i][0] * x.x + A[i][1] * x.y + A[i][2] * x.z;
        };
    };
    const Jacobian<double> J = jacobian<double>(Vec3<decltype(around(component(0), point))>{
        around(component(0), point), around(component(1), point), around(component(2), point)});
    for (int j = 0; j < 3; ++j) {
        CHECK(J.x[j] == Approx(A[0][j]));
        CHECK(J.y[j] == Approx(A[1][j]));
        CHECK(J.z[j] == Approx(A[2][j]));
    }
    CHECK(J.divergence() == Approx(15.0));
    const Vec3<double> n{0.6, 0.0, 0.8};
    CHECK(J.normal_component(n) == Approx(0.36 * 1 + 0.48 * (3 + 7) + 0.64 * 9));
}

namespace {

/// Unit normals of gently bent surfaces about z.
constexpr auto bent = [](const Vec3<double>& x) {
    return unit_vector(Vec3<double>{0.05 * x.x + 0.02 * x.y, -0.03 * x.y, 1.0 + 0.01 * x.z});
};

template <class Field>
Jacobian<double> jacobian_of_normals_at(const Field& n, const Vec3<double>& x) {
    const auto component = [&](int a) {
        return [&n, a](const Vec3<double>& y) {
            return n(y)[a];
        };
    };
    using Component = decltype(around(component(0), x));
    return jacobian_of_normals(
        Vec3<Component>{around(component(0), x), around(component(1), x), around(component(2), x)}, n(x));
}

Jacobian<double> reversed(const Jacobian<double>& J) {
    return {-J.x, -J.y, -J.z};
}

double difference(const Jacobian<double>& a, const Jacobian<double>& b) {
    return norm(a.x - b.x) + norm(a.y - b.y) + norm(a.z - b.z);
}

} // namespace

TEST_CASE("the Jacobian of normals does not see that those of another sheet point the other way",
          "[geometry]") {
    const Jacobian<double> one = jacobian_of_normals_at(bent, point);
    const auto component = [](int a) {
        return [a](const Vec3<double>& x) {
            return bent(x)[a];
        };
    };
    using Component = decltype(around(component(0), point));
    const Jacobian<double> plain = jacobian<double>(Vec3<Component>{
        around(component(0), point), around(component(1), point), around(component(2), point)});
    CHECK(difference(one, plain) < 1e-15);
    for (const double middle : {point.z - 0.5, point.z + 0.2}) {
        const auto sheets = [&](const Vec3<double>& x) {
            return (x.z > middle ? 1.0 : -1.0) * bent(x);
        };
        const Jacobian<double> found = jacobian_of_normals_at(sheets, point);
        CHECK(difference(point.z > middle ? found : reversed(found), one) < 1e-15);
    }
}

TEST_CASE("the Jacobian of normals takes a normal that is missing to be the one here", "[geometry]") {
    const auto above = [&](const Vec3<double>& x) {
        return x.z > point.z + 0.5;
    };
    const auto missing = [&](const Vec3<double>& x) {
        return (above(x) ? 0.0 : 1.0) * bent(x);
    };
    const auto repeated = [&](const Vec3<double>& x) {
        return above(x) ? bent(point) : bent(x);
    };
    const Jacobian<double> found = jacobian_of_normals_at(missing, point);
    CHECK(difference(found, jacobian_of_normals_at(repeated, point)) < 1e-15);
    CHECK(found.x.x > 0.7 * jacobian_of_normals_at(bent, point).x.x);
}

TEST_CASE("a distance has a normal but midway between two sheets", "[geometry]") {
    const Vec3<double> along = unit_vector(Vec3<double>{1.0, -2.0, 0.5});
    CHECK(norm(normal_of_distance(0.55 * along) - along) < 1e-15);
    CHECK(norm(normal_of_distance(1.1 * along) - along) < 1e-15);
    CHECK(norm(normal_of_distance(0.45 * along)) == 0.0);
    CHECK(norm(normal_of_distance(Vec3<double>{})) == 0.0);
    CHECK(normal_of_distance(Vec3<float>{0.3f, 0.3f, 0.3f}).x == Approx(std::sqrt(1.0 / 3.0)));
}

TEST_CASE("the gradient of a sharpened field is fourth order", "[geometry]") {
    const auto error = [&](double h) {
        const auto sharp = [&](const Vec3<double>& x) {
            return sharpened<double>(around(wave, x, h), 1.0);
        };
        return norm((1.0 / h) * gradient<double>(around(sharp, point, h)) - wave_gradient(point));
    };
    CHECK(std::log2(error(0.2) / error(0.1)) == Approx(4.0).margin(0.1));
    CHECK(std::log2(error(0.1) / error(0.05)) == Approx(4.0).margin(0.1));
}
