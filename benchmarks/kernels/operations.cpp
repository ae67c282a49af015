// Counts the arithmetic of every kernel, by running it once on numbers that count what is done to them.
#include "collision/regularised.hpp"
#include "collision/symmetric_mrt.hpp"
#include "colour/phase.hpp"
#include "colour/recolouring.hpp"
#include "geometry/curvature.hpp"
#include "geometry/laplace_beltrami.hpp"
#include "geometry/normal.hpp"
#include "membrane/bending.hpp"
#include "membrane/layer_force.hpp"
#include "membrane/tension.hpp"

#include <cmath>
#include <cstdio>

namespace vesica {

struct Operations {
    int sums = 0;     ///< additions, subtractions
    int products = 0; ///< multiplications
    int fused = 0;    ///< multiply-adds
    int divisions = 0;
    int others = 0; ///< roots, logarithms, comparisons, choices
    int reads = 0;  ///< of neighbours' values

    /// As people count: a fused multiply-add is two.
    int flops() const { return sums + products + 2 * fused + divisions; }
};

namespace {

Operations counted;

struct Number {
    double value = 0.0;

    Number() = default;
    template <class A>
    requires std::is_arithmetic_v<A> Number(A a) // NOLINT(google-explicit-constructor): as packs do
        : value(static_cast<double>(a)) {}

    static Number of(double value, int& count) {
        ++count;
        return Number(value);
    }
    friend Number operator+(const Number& a, const Number& b) {
        return std::signbit(a.value) && a.value == 0.0 ? b : of(a.value + b.value, counted.sums);
    }
    friend Number operator-(const Number& a, const Number& b) { return of(a.value - b.value, counted.sums); }
    friend Number operator*(const Number& a, const Number& b) {
        return of(a.value * b.value, counted.products);
    }
    friend Number operator/(const Number& a, const Number& b) {
        return of(a.value / b.value, counted.divisions);
    }
    friend Number operator-(const Number& a) { return Number(-a.value); }
    Number& operator+=(const Number& b) { return *this = *this + b; }
    Number& operator-=(const Number& b) {
        return *this = std::signbit(value) && value == 0.0 ? Number(-b.value) : *this - b;
    }
    friend bool operator<(const Number& a, const Number& b) { return a.value < b.value; }
    friend bool operator>(const Number& a, const Number& b) { return b < a; }
};

Number fma(const Number& a, const Number& b, const Number& c) {
    return Number::of(std::fma(a.value, b.value, c.value), counted.fused);
}
Number select(bool mask, const Number& yes, const Number& no) {
    ++counted.others;
    return mask ? yes : no;
}
Number larger(const Number& a, const Number& b) {
    return Number::of(std::fmax(a.value, b.value), counted.others);
}
Number smaller(const Number& a, const Number& b) {
    return Number::of(std::fmin(a.value, b.value), counted.others);
}
Number square_root(const Number& a) {
    return Number::of(std::sqrt(a.value), counted.others);
}
Number logarithm(const Number& a) {
    return Number::of(std::log(a.value), counted.others);
}
Number magnitude(const Number& a) {
    return Number(std::abs(a.value));
}
bool sign_bit(const Number& a) {
    return std::signbit(a.value);
}
Number dot(const Vec3<Number>& a, const Vec3<Number>& b) {
    return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}

} // namespace

template <>
struct scalar_of<Number> {
    using type = double;
};

namespace {

struct Around {
    template <int i>
    Number operator()(Direction<i>) const {
        ++counted.reads;
        return Number(0.1 + 0.01 * (7 * i % 11));
    }
};

template <class Kernel>
void report(const char* name, const Kernel& kernel) {
    counted = {};
    kernel();
    std::printf("| %-46s | %6d | %6d | %6d | %6d | %6d | %6d | %6d |\n", name, counted.sums, counted.products,
                counted.fused, counted.divisions, counted.others, counted.reads, counted.flops());
}

void report_all() {
    std::printf("| %-46s | %6s | %6s | %6s | %6s | %6s | %6s | %6s |\n", "kernel", "sums", "prod.", "fused",
                "div.", "others", "reads", "flops");
    Number g[direction_count];
    for (int i = 0; i < direction_count; ++i)
        g[i] = 0.01 + 0.003 * (5 * i % 7);
    const Vec3<Number> v{0.1, 0.2, 0.3};
    const Vec3<Around> field;
    const Curvatures<Number> c{0.1, 0.01};
    report("regularised collision", [&] { RegularisedCollision{}(g, v, Number(1.2), Number(1)); });
    report("two relaxation times",
           [&] { SymmetricMrt<TwoRelaxationTimes>{{0.25}}(g, v, Number(1.2), Number(1)); });
    report("four ghost rates", [&] {
        SymmetricMrt<FreeGhostRates>{{1.2, 1.1, 1.3, 1.4}}(g, v, Number(1.2), Number(1));
    });
    report("one relaxation time",
           [&] { SymmetricMrt<SingleRelaxationTime>{}(g, v, Number(1.2), Number(1)); });
    report("colours gathered", [&] { gather_colours(g, Number(1), Number(1), true, Around{}, field); });
    report("signed distance", [&] { signed_distance_of(Number(0.3), Number(1e-8), 0.67); });
    report("sharpened field", [&] { sharpened<Number>(Around{}, 1.0); });
    report("normal and segregation flux",
           [&] { segregation_flux(Number(0.3), Number(1), unit_vector(gradient<Number>(Around{})), 0.67); });
    report("curvatures mapped to the surface",
           [&] { map_to_mid_surface(curvatures_of(jacobian_of_normals(field, v), v), Number(0.5)); });
    report("surface gradient of H mapped to the surface", [&] {
        flux_on_mid_surface(tangential(gradient<Number>(Around{}), v), jacobian<Number>(field), v,
                            Number(0.5), Number(0.1), Number(1.1));
    });
    report("Laplace-Beltrami, bending, tension, force", [&] {
        const Number laplacian = surface_divergence(jacobian<Number>(field), v) / Number(1.1);
        const Number force = HelfrichLaw{0.1, 0.0}.force(c.H, c.K, laplacian) + TensionLaw{0.01}.force(c.H);
        LayerForce(1e-2)(gradient<Number>(Around{}), force);
    });
}

} // namespace
} // namespace vesica

int main() {
    vesica::report_all();
}
