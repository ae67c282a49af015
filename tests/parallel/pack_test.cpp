#include "parallel/pack.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace vesica;

using Doubles = Pack<double>;
using Floats = Pack<float>;
using SixteenDoubles = Pack<double, 16>;
using SixteenFloats = Pack<float, 16>;
#define PACKS Doubles, Floats, SixteenDoubles, SixteenFloats

namespace {

template <class P>
struct Lanes {
    using T = scalar_of_t<P>;
    T value[static_cast<std::size_t>(P::width)];

    P pack() const { return P::load(value); }
};

/// Numbers of all signs and many sizes, none of which overflows when squared.
template <class P>
Lanes<P> random_lanes(std::mt19937_64& random) {
    using T = scalar_of_t<P>;
    std::uniform_real_distribution<double> mantissa(1.0, 2.0);
    std::uniform_int_distribution<int> exponent(-18, 18);
    Lanes<P> lanes;
    for (T& v : lanes.value)
        v = static_cast<T>(
            std::ldexp(random() % 2 == 0 ? mantissa(random) : -mantissa(random), exponent(random)));
    return lanes;
}

template <class P>
void check_lanes(const P& found, const Lanes<P>& expected) {
    for (int k = 0; k < P::width; ++k)
        CHECK(found[k] == expected.value[k]);
}

} // namespace

TEMPLATE_TEST_CASE("arithmetic of packs is arithmetic of numbers, lane by lane and bit by bit", "[parallel]",
                   PACKS) {
    using P = TestType;
    using T = scalar_of_t<P>;
    constexpr int width = P::width;
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const Lanes<P> a = random_lanes<P>(random);
        const Lanes<P> b = random_lanes<P>(random);
        const Lanes<P> c = random_lanes<P>(random);
        Lanes<P> sum, difference, product, quotient, fused, root, most, least, absolute, minus;
        for (int k = 0; k < width; ++k) {
            sum.value[k] = a.value[k] + b.value[k];
            difference.value[k] = a.value[k] - b.value[k];
            product.value[k] = a.value[k] * b.value[k];
            quotient.value[k] = a.value[k] / b.value[k];
            fused.value[k] = vesica::fma(a.value[k], b.value[k], c.value[k]);
            root.value[k] = std::sqrt(std::abs(a.value[k]));
            most.value[k] = std::max(a.value[k], b.value[k]);
            least.value[k] = std::min(a.value[k], b.value[k]);
            absolute.value[k] = std::abs(a.value[k]);
            minus.value[k] = -a.value[k];
        }
        check_lanes(a.pack() + b.pack(), sum);
        check_lanes(a.pack() - b.pack(), difference);
        check_lanes(a.pack() * b.pack(), product);
        check_lanes(a.pack() / b.pack(), quotient);
        check_lanes(fma<T>(a.pack(), b.pack(), c.pack()), fused);
        check_lanes(square_root(magnitude(a.pack())), root);
        check_lanes(larger(a.pack(), b.pack()), most);
        check_lanes(smaller(a.pack(), b.pack()), least);
        check_lanes(magnitude(a.pack()), absolute);
        check_lanes(-a.pack(), minus);
        P in_place = a.pack();
        in_place += b.pack();
        in_place *= c.pack();
        in_place -= b.pack();
        for (int k = 0; k < width; ++k)
            CHECK(in_place[k] == sum.value[k] * c.value[k] - b.value[k]);
    }
}

TEMPLATE_TEST_CASE("a number is a pack of equal numbers, and storing gives back what was loaded",
                   "[parallel]", PACKS) {
    using P = TestType;
    using T = scalar_of_t<P>;
    constexpr int width = P::width;
    const T third = T(1) / T(3);
    for (int k = 0; k < width; ++k) {
        CHECK(P(third)[k] == third);
        CHECK(P()[k] == T(0));
        CHECK(std::signbit(P(T(-0.0))[k]));
    }
    // One element off any alignment, and not a byte beyond the last.
    constexpr std::size_t padded = width + 2;
    T from[padded], to[padded] = {};
    for (int k = 0; k < width + 2; ++k)
        from[k] = static_cast<T>(k + 1);
    P::load(from + 1).store(to + 1);
    CHECK(to[0] == T(0));
    CHECK(to[width + 1] == T(0));
    for (int k = 1; k <= width; ++k)
        CHECK(to[k] == from[k]);
}

TEMPLATE_TEST_CASE("masks compare, combine and choose lane by lane", "[parallel]", PACKS) {
    using P = TestType;
    using T = scalar_of_t<P>;
    constexpr int width = P::width;
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 50; ++trial) {
        Lanes<P> a = random_lanes<P>(random);
        const Lanes<P> b = random_lanes<P>(random);
        a.value[trial % width] = b.value[trial % width]; // equality decides < from <=
        const auto less = a.pack() < b.pack();
        const auto at_most = a.pack() <= b.pack();
        const auto greater = a.pack() > b.pack();
        const auto at_least = a.pack() >= b.pack();
        const auto some = P::mask(static_cast<std::uint32_t>(trial * 3737));
        const P chosen = select<T>(less & some, a.pack(), b.pack());
        for (int k = 0; k < width; ++k) {
            const T x = a.value[k];
            const T y = b.value[k];
            const bool bit = ((trial * 3737) >> k & 1) != 0;
            CHECK(less[k] == (x < y));
            CHECK(at_most[k] == (x <= y));
            CHECK(greater[k] == (x > y));
            CHECK(at_least[k] == (x >= y));
            CHECK(some[k] == bit);
            CHECK((less & some)[k] == (x < y && bit));
            CHECK((less | some)[k] == (x < y || bit));
            CHECK((!less)[k] == !(x < y));
            CHECK(chosen[k] == (x < y && bit ? x : y));
        }
    }
}

TEMPLATE_TEST_CASE("a choice keeps what is not a number out of the other lanes", "[parallel]", PACKS) {
    using P = TestType;
    using T = scalar_of_t<P>;
    constexpr int width = P::width;
    const P bad(std::numeric_limits<T>::quiet_NaN());
    const P chosen = select<T>(P::mask(0b00001111), bad, P(1));
    for (int k = 0; k < width; ++k)
        CHECK(std::isnan(chosen[k]) == (k < 4));
    for (int k = 0; k < width; ++k)
        CHECK(!(bad < P(1))[k]);
}

TEMPLATE_TEST_CASE("the sign is a bit of its own: zero has one, and it can be set and read", "[parallel]",
                   PACKS) {
    using P = TestType;
    using T = scalar_of_t<P>;
    constexpr int width = P::width;
    using Limits = std::numeric_limits<T>;
    constexpr T samples[8] = {T(0),          T(-0.0),        T(1),          T(-1),
                              Limits::min(), -Limits::min(), Limits::max(), Limits::lowest()};
    Lanes<P> values;
    for (int k = 0; k < width; ++k)
        values.value[k] = samples[k % 8];
    const auto negative = sign_bit(values.pack());
    for (int k = 0; k < width; ++k) {
        CHECK(negative[k] == std::signbit(values.value[k]));
        CHECK(sign_bit(values.value[k]) == std::signbit(values.value[k]));
    }
    const P set = with_sign_bit(P::mask(0b1101001010010110), values.pack());
    for (int k = 0; k < width; ++k) {
        CHECK(std::signbit(set[k]) == ((0b1101001010010110 >> k & 1) != 0));
        CHECK(std::abs(set[k]) == std::abs(values.value[k]));
        CHECK(with_sign_bit(true, values.value[k]) == -std::abs(values.value[k]));
        CHECK(std::signbit(with_sign_bit(true, values.value[k])));
        CHECK(!std::signbit(with_sign_bit(false, values.value[k])));
    }
}

TEMPLATE_TEST_CASE("the logarithm is right to the last digits over the whole range, and most of all near one",
                   "[parallel]", PACKS) {
    using P = TestType;
    using T = scalar_of_t<P>;
    constexpr int width = P::width;
    const double tolerance = sizeof(T) == 8 ? 5e-16 : 3e-7;
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> any_size(-37.0, 37.0); // powers of ten
    std::uniform_real_distribution<double> near_one(-6.0, -0.5);
    std::uniform_real_distribution<double> around(0.5, 2.0);
    double worst = 0.0;
    for (int trial = 0; trial < 30000; ++trial) {
        Lanes<P> x;
        for (T& v : x.value) {
            const int kind = trial % 3;
            const double distance = std::pow(10.0, near_one(random));
            v = static_cast<T>(kind == 0   ? std::pow(10.0, any_size(random))
                               : kind == 1 ? 1.0 + (random() % 2 == 0 ? distance : -distance)
                                           : around(random));
        }
        const P found = logarithm(x.pack());
        for (int k = 0; k < width; ++k) {
            const long double exact = std::log(static_cast<long double>(x.value[k]));
            if (exact == 0.0L) {
                CHECK(found[k] == T(0));
                continue;
            }
            const long double error = std::abs((static_cast<long double>(found[k]) - exact) / exact);
            worst = std::max(worst, static_cast<double>(error));
        }
    }
    INFO("worst relative error " << worst);
    CHECK(worst < tolerance);
    CHECK(logarithm(P(1))[0] == T(0));
}
