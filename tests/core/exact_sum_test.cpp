#include "core/exact_sum.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using vesica::ExactSum;

namespace {

std::vector<double> terms_of_all_sizes(int count) {
    std::mt19937_64 random(20210907);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-70, 30);
    std::vector<double> terms;
    for (int i = 0; i < count; ++i)
        terms.push_back(std::ldexp(mantissa(random), exponent(random)));
    return terms;
}

ExactSum sum_of(const std::vector<double>& terms, std::size_t begin, std::size_t end) {
    ExactSum sum;
    for (std::size_t i = begin; i < end; ++i)
        sum.add(terms[i]);
    return sum;
}

} // namespace

TEST_CASE("the order of the terms does not change a bit of the sum", "[core]") {
    std::vector<double> terms = terms_of_all_sizes(5000);
    const ExactSum reference = sum_of(terms, 0, terms.size());
    std::mt19937_64 random(7);
    for (int trial = 0; trial < 20; ++trial) {
        std::shuffle(terms.begin(), terms.end(), random);
        const ExactSum sum = sum_of(terms, 0, terms.size());
        REQUIRE(sum == reference);
        REQUIRE(sum.value() == reference.value());
    }
    std::sort(terms.begin(), terms.end());
    REQUIRE(sum_of(terms, 0, terms.size()) == reference);
}

TEST_CASE("any partition among threads and ranks gives the same bits, in any order of merging", "[core]") {
    const std::vector<double> terms = terms_of_all_sizes(5000);
    const ExactSum reference = sum_of(terms, 0, terms.size());
    std::mt19937_64 random(11);
    for (std::size_t parts : {2u, 3u, 8u, 64u}) {
        std::vector<std::size_t> cuts{0, terms.size()};
        std::uniform_int_distribution<std::size_t> anywhere(0, terms.size());
        for (std::size_t i = 1; i < parts; ++i)
            cuts.push_back(anywhere(random));
        std::sort(cuts.begin(), cuts.end());
        std::vector<ExactSum> partial;
        for (std::size_t i = 0; i < parts; ++i)
            partial.push_back(sum_of(terms, cuts[i], cuts[i + 1]));
        std::shuffle(partial.begin(), partial.end(), random);
        ExactSum total;
        for (const ExactSum& part : partial)
            total += ExactSum::from_words(part.words());
        REQUIRE(total == reference);
    }
}

TEST_CASE("what a plain sum loses to cancellation is kept", "[core]") {
    ExactSum sum;
    for (double term : {1e12, 1.0, 0x1p-40, -1e12, -1.0})
        sum.add(term);
    CHECK(sum.value() == 0x1p-40);

    ExactSum small; // a tiny step is rounded to a multiple of 2^-64, once
    for (int i = 0; i < 1000; ++i)
        small.add(1e-15);
    CHECK(small.value() == Approx(1e-12).epsilon(3e-5));
}

TEST_CASE("each term is rounded to the nearest multiple of 2^-64, symmetrically about zero", "[core]") {
    const double unit = 0x1p-64;
    for (double sign : {1.0, -1.0}) {
        const auto once = [&](double term) {
            ExactSum sum;
            sum.add(sign * term);
            return sign * sum.value();
        };
        CHECK(once(0.49 * unit) == 0.0);
        CHECK(once(0.5 * unit) == unit);
        CHECK(once(1.49 * unit) == unit);
        CHECK(once(2.75 * unit) == 3.0 * unit);
        CHECK(once(1e-300) == 0.0);
        CHECK(once(5e-324) == 0.0);
        CHECK(once(0.1) == 0.1);
        CHECK(once(ExactSum::largest_term) == ExactSum::largest_term);
    }
}

TEST_CASE("a term that is not a number poisons the sum, whatever is merged into it", "[core]") {
    ExactSum good;
    good.add(1.0);
    ExactSum bad;
    bad.add(std::nan(""));
    CHECK(std::isnan(bad.value()));
    good += ExactSum::from_words(bad.words());
    CHECK(std::isnan(good.value()));
    ExactSum infinite;
    infinite.add(HUGE_VAL);
    CHECK(std::isnan(infinite.value()));
}
