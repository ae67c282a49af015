#include "parallel/lane_sum.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace vesica;

namespace {

std::vector<Pack<double>> random_terms(int count, double size) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> value(-size, size);
    std::vector<Pack<double>> terms;
    for (int k = 0; k < count; ++k) {
        double lanes[tile_width];
        for (double& lane : lanes)
            lane = value(random);
        terms.push_back(Pack<double>::load(lanes));
    }
    return terms;
}

} // namespace

TEST_CASE("the sum of packs has the same bits in any order and any partition", "[parallel]") {
    std::vector<Pack<double>> terms = random_terms(4000, 0.9);
    LaneSum<38> reference;
    for (const auto& term : terms)
        reference.add(term);
    std::mt19937_64 random(9);
    for (int trial = 0; trial < 10; ++trial) {
        std::shuffle(terms.begin(), terms.end(), random);
        std::vector<LaneSum<38>> parts(static_cast<std::size_t>(trial + 1));
        for (const auto& term : terms)
            parts[random() % parts.size()].add(term);
        std::shuffle(parts.begin(), parts.end(), random);
        LaneSum<38> total;
        for (const auto& part : parts)
            total.merge(part);
        CHECK(total.value() == reference.value());
    }
}

TEST_CASE("each number is rounded once to the nearest unit of the sum", "[parallel]") {
    const double unit = 0x1p-38;
    const auto sum_of = [](double term) {
        LaneSum<38> sum;
        sum.add(select<double>(Pack<double>::mask(0b00100000), Pack<double>(term), Pack<double>(0)));
        return sum.value();
    };
    for (const double sign : {1.0, -1.0}) {
        CHECK(sum_of(sign * 0.49 * unit) == 0.0);
        CHECK(sum_of(sign * 0.51 * unit) == sign * unit);
        CHECK(sum_of(sign * 12345.4 * unit) == sign * 12345.0 * unit);
        CHECK(sum_of(sign * 0x1.8p12) == sign * 0x1.8p12); // terms up to 2^13
    }
    LaneSum<38> many;
    const std::vector<Pack<double>> terms = random_terms(4000, 0.9);
    long double exact = 0.0L;
    for (const auto& term : terms) {
        many.add(term);
        for (int k = 0; k < tile_width; ++k)
            exact += term[k];
    }
    CHECK(many.value() == Approx(static_cast<double>(exact)).margin(32000 * 0.5 * unit));
}

TEST_CASE("single precision terms are summed without loss", "[parallel]") {
    LaneSum<38> sum;
    for (int k = 0; k < 1000; ++k)
        sum.add(Pack<float>(0.1f));
    CHECK(sum.value() == Approx(8000.0 * static_cast<double>(0.1f)).epsilon(1e-10));
}

TEST_CASE("a pack of sixteen adds what its two halves do", "[parallel]") {
    float terms[16];
    for (int k = 0; k < 16; ++k)
        terms[k] = 0.3f * static_cast<float>(k * k) - 7.0f;
    LaneSum<38> whole;
    whole.add(Pack<float, 16>::load(terms));
    LaneSum<38> halves;
    halves.add(Pack<float>::load(terms));
    halves.add(Pack<float>::load(terms + 8));
    CHECK(whole.value() == halves.value());
    CHECK(whole.value() != 0.0);
}
