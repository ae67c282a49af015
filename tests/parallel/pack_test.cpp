#include "parallel/pack.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace vesica;

namespace {

template <class T>
struct Lanes {
    T value[tile_width];

    Pack<T> pack() const { return Pack<T>::load(value); }
};

/// Numbers of all signs and many sizes, none of which overflows when squared.
template <class T>
Lanes<T> random_lanes(std::mt19937_64& random) {
    std::uniform_real_distribution<double> mantissa(1.0, 2.0);
    std::uniform_int_distribution<int> exponent(-18, 18);
    Lanes<T> lanes;
    for (T& v : lanes.value)
        v = static_cast<T>(
            std::ldexp(random() % 2 == 0 ? mantissa(random) : -mantissa(random), exponent(random)));
    return lanes;
}

template <class T>
void check_lanes(const Pack<T>& found, const T (&expected)[tile_width]) {
    for (int k = 0; k < tile_width; ++k)
        CHECK(found[k] == expected[k]);
}

} // namespace

TEMPLATE_TEST_CASE("arithmetic of packs is arithmetic of numbers, lane by lane and bit by bit", "[parallel]",
                   double, float) {
    using T = TestType;
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const Lanes<T> a = random_lanes<T>(random);
        const Lanes<T> b = random_lanes<T>(random);
        const Lanes<T> c = random_lanes<T>(random);
        T sum[tile_width], difference[tile_width], product[tile_width], quotient[tile_width],
            fused[tile_width], root[tile_width], most[tile_width], least[tile_width], absolute[tile_width],
            minus[tile_width];
        for (int k = 0; k < tile_width; ++k) {
            sum[k] = a.value[k] + b.value[k];
            difference[k] = a.value[k] - b.value[k];
            product[k] = a.value[k] * b.value[k];
            quotient[k] = a.value[k] / b.value[k];
            fused[k] = vesica::fma(a.value[k], b.value[k], c.value[k]);
            root[k] = std::sqrt(std::abs(a.value[k]));
            most[k] = std::max(a.value[k], b.value[k]);
            least[k] = std::min(a.value[k], b.value[k]);
            absolute[k] = std::abs(a.value[k]);
            minus[k] = -a.value[k];
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
        Pack<T> in_place = a.pack();
        in_place += b.pack();
        in_place *= c.pack();
        in_place -= b.pack();
        for (int k = 0; k < tile_width; ++k)
            CHECK(in_place[k] == sum[k] * c.value[k] - b.value[k]);
    }
}

TEMPLATE_TEST_CASE("a number is a pack of equal numbers, and storing gives back what was loaded",
                   "[parallel]", double, float) {
    using T = TestType;
    const T third = T(1) / T(3);
    for (int k = 0; k < tile_width; ++k) {
        CHECK(Pack<T>(third)[k] == third);
        CHECK(Pack<T>()[k] == T(0));
        CHECK(std::signbit(Pack<T>(T(-0.0))[k]));
    }
    // One element off any alignment, and not a byte beyond the eight.
    T from[10], to[10] = {};
    for (int k = 0; k < 10; ++k)
        from[k] = static_cast<T>(k + 1);
    Pack<T>::load(from + 1).store(to + 1);
    CHECK(to[0] == T(0));
    CHECK(to[9] == T(0));
    for (int k = 1; k < 9; ++k)
        CHECK(to[k] == from[k]);
}

TEMPLATE_TEST_CASE("masks compare, combine and choose lane by lane", "[parallel]", double, float) {
    using T = TestType;
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 50; ++trial) {
        Lanes<T> a = random_lanes<T>(random);
        const Lanes<T> b = random_lanes<T>(random);
        a.value[trial % tile_width] = b.value[trial % tile_width]; // equality decides < from <=
        const auto less = a.pack() < b.pack();
        const auto at_most = a.pack() <= b.pack();
        const auto greater = a.pack() > b.pack();
        const auto at_least = a.pack() >= b.pack();
        const auto some = Pack<T>::mask(static_cast<std::uint8_t>(trial * 37));
        const Pack<T> chosen = select<T>(less & some, a.pack(), b.pack());
        for (int k = 0; k < tile_width; ++k) {
            const T x = a.value[k];
            const T y = b.value[k];
            const bool bit = ((trial * 37) >> k & 1) != 0;
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

TEMPLATE_TEST_CASE("a choice keeps what is not a number out of the other lanes", "[parallel]", double,
                   float) {
    using T = TestType;
    const Pack<T> bad(std::numeric_limits<T>::quiet_NaN());
    const Pack<T> chosen = select<T>(Pack<T>::mask(0b00001111), bad, Pack<T>(1));
    for (int k = 0; k < tile_width; ++k)
        CHECK(std::isnan(chosen[k]) == (k < 4));
    for (int k = 0; k < tile_width; ++k)
        CHECK(!(bad < Pack<T>(1))[k]);
}

TEMPLATE_TEST_CASE("the sign is a bit of its own: zero has one, and it can be set and read", "[parallel]",
                   double, float) {
    using T = TestType;
    const Lanes<T> values{{T(0), T(-0.0), T(1), T(-1), std::numeric_limits<T>::min(),
                           -std::numeric_limits<T>::min(), std::numeric_limits<T>::max(),
                           std::numeric_limits<T>::lowest()}};
    const auto negative = sign_bit(values.pack());
    for (int k = 0; k < tile_width; ++k) {
        CHECK(negative[k] == std::signbit(values.value[k]));
        CHECK(sign_bit(values.value[k]) == std::signbit(values.value[k]));
    }
    const Pack<T> set = with_sign_bit<T>(Pack<T>::mask(0b10010110), values.pack());
    for (int k = 0; k < tile_width; ++k) {
        CHECK(std::signbit(set[k]) == ((0b10010110 >> k & 1) != 0));
        CHECK(std::abs(set[k]) == std::abs(values.value[k]));
        CHECK(with_sign_bit(true, values.value[k]) == -std::abs(values.value[k]));
        CHECK(std::signbit(with_sign_bit(true, values.value[k])));
        CHECK(!std::signbit(with_sign_bit(false, values.value[k])));
    }
}

TEMPLATE_TEST_CASE("the logarithm is right to the last digits over the whole range, and most of all near one",
                   "[parallel]", double, float) {
    using T = TestType;
    const double tolerance = sizeof(T) == 8 ? 5e-16 : 3e-7;
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> any_size(-37.0, 37.0); // powers of ten
    std::uniform_real_distribution<double> near_one(-6.0, -0.5);
    std::uniform_real_distribution<double> around(0.5, 2.0);
    double worst = 0.0;
    for (int trial = 0; trial < 60000; ++trial) {
        Lanes<T> x;
        for (T& v : x.value) {
            const int kind = trial % 3;
            const double distance = std::pow(10.0, near_one(random));
            v = static_cast<T>(kind == 0   ? std::pow(10.0, any_size(random))
                               : kind == 1 ? 1.0 + (random() % 2 == 0 ? distance : -distance)
                                           : around(random));
        }
        const Pack<T> found = logarithm(x.pack());
        for (int k = 0; k < tile_width; ++k) {
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
    CHECK(logarithm(Pack<T>(1))[0] == T(0));
}
