#include "collision/paper_mrt.hpp"
#include "collision/sample_states.hpp"
#include "measured.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace vesica;
using namespace vesica::sample;

namespace {

struct PublishedRow {
    int index;
    int entries[direction_count];
};

// Spendlove et al. 2021, Table VI with h14 = c_x c_y^2, written out by direction in the order of their Table
// I.
const PublishedRow rows_of_matrix[] = {
    {2, {0, 0, -1, -1, -1, 0, 1, 1, 1, 0, 0, 1, 0, -1, 0, 0, 1, 0, -1}},
    {8, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, -1, 0, 1, 0}},
    {10, {1, -2, 1, -2, 1, -2, 1, -2, 1, -2, 1, 1, 1, 1, -2, 1, 1, 1, 1}},
    {11, {0, -2, 1, 0, -1, 2, -1, 0, 1, 0, 1, 0, -1, 0, 0, 1, 0, -1, 0}},
    {14, {0, 0, 1, 0, -1, 0, -1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {15, {0, 0, -1, 0, -1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {16, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, -1, 0}},
    {17, {0, 0, 1, -2, 1, 0, 1, -2, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 1}},
    {18, {0, -2, 1, 0, 1, -2, 1, 0, 1, 0, 1, 0, 1, 0, 0, 1, 0, 1, 0}},
};

// 24 M^-1, from their columns k with the last term of A8 and A9 read as -4 g c_epsilon^2.
const PublishedRow rows_of_inverse[] = {
    {0, {20, 0, 0, 0, -12, -12, -12, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0}},
    {1, {0, 4, 0, 0, 4, 0, 0, 0, 0, 0, 0, -4, 0, 0, 0, 0, 0, 0, -4}},
    {2, {1, 0, 0, 0, 1, 1, -3, -6, 0, 0, -1, 0, 0, 0, 6, -6, 0, 2, 2}},
    {7, {0, 0, 4, 0, 0, 4, 0, 0, 0, 0, 0, 0, -4, 0, 0, 0, 0, -4, 0}},
    {9, {4, 0, 0, 4, -4, -4, 0, 0, 0, 0, -4, 0, 0, -4, 0, 0, 0, 4, 4}},
    {10, {-1, 4, 0, 0, 3, -1, 3, 0, 6, 0, 1, 2, 0, 0, -6, 0, 6, -2, 0}},
    {13, {-1, 0, -4, 4, -1, 3, 3, 0, 0, -6, 1, 0, -2, 2, 0, 6, -6, 0, -2}},
    {18, {-1, 0, -4, -4, -1, 3, 3, 0, 0, 6, 1, 0, -2, -2, 0, 6, 6, 0, -2}},
};

double paper_moment(int p, const Populations& f) {
    double sum = 0.0;
    for (int i = 0; i < direction_count; ++i)
        sum += paper_basis::row(p, i) * f[i];
    return sum;
}

/// The populations with the stored t_i rho0 added back.
Populations whole(Populations f, double rho0) {
    for (int i = 0; i < direction_count; ++i)
        f[i] += weight(i) * rho0;
    return f;
}

} // namespace

TEST_CASE("the matrix of the paper and its inverse are the published integers", "[collision]") {
    for (const PublishedRow& row : rows_of_matrix)
        for (int i = 0; i < direction_count; ++i)
            CHECK(paper_basis::M[static_cast<std::size_t>(row.index)][static_cast<std::size_t>(i)] ==
                  row.entries[i]);
    for (const PublishedRow& row : rows_of_inverse)
        for (int p = 0; p < direction_count; ++p)
            CHECK(24.0 * paper_basis::M_inverse[static_cast<std::size_t>(row.index)]
                                               [static_cast<std::size_t>(p)] ==
                  Approx(row.entries[p]).margin(1e-13));
}

TEST_CASE("the matrix times its inverse is the identity, from either side", "[collision]") {
    double largest = 0.0;
    for (std::size_t a = 0; a < direction_count; ++a)
        for (std::size_t b = 0; b < direction_count; ++b) {
            double right = 0.0;
            double left = 0.0;
            for (std::size_t k = 0; k < direction_count; ++k) {
                right += paper_basis::M[a][k] * paper_basis::M_inverse[k][b];
                left += paper_basis::M_inverse[a][k] * paper_basis::M[k][b];
            }
            CHECK(std::abs(right - (a == b ? 1.0 : 0.0)) < 1e-14);
            CHECK(std::abs(left - (a == b ? 1.0 : 0.0)) < 1e-14);
            largest = std::max(
                {largest, std::abs(right - (a == b ? 1.0 : 0.0)), std::abs(left - (a == b ? 1.0 : 0.0))});
        }
    test::measured("M times its inverse, less the identity", "largest element", largest);
}

TEST_CASE("the equilibrium has the paper's nineteen moments", "[collision]") {
    const double rho = 1.17;
    const Vec3<double> u{0.04, -0.07, 0.02};
    const Populations f = whole(equilibrium(rho, 1.0, u), 1.0);
    const double expected[direction_count] = {
        rho,
        rho * u.x,
        rho * u.y,
        rho * u.z,
        rho / 3 + rho * u.x * u.x,
        rho / 3 + rho * u.y * u.y,
        rho / 3 + rho * u.z * u.z,
        rho * u.x * u.y,
        rho * u.x * u.z,
        rho * u.y * u.z,
        0,
        0,
        0,
        0,
        rho * u.x / 3,
        rho * u.y / 3,
        rho * u.z / 3,
        (rho / 2) * (u.x * u.x + u.z * u.z),
        (rho / 2) * (u.y * u.y + u.z * u.z),
    };
    double largest = 0.0;
    for (int p = 0; p < direction_count; ++p) {
        INFO("moment " << p);
        CHECK(paper_moment(p, f) == Approx(expected[p]).margin(1e-15));
        largest = std::max(largest, std::abs(paper_moment(p, f) - expected[p]));
    }
    test::measured("moments of the equilibrium, paper's basis", "largest error", largest);
}

TEST_CASE("every moment of the paper's basis relaxes with its own rate and takes its share of the force",
          "[collision]") {
    std::mt19937_64 random(4);
    double largest = 0.0;
    const PaperMrt collision{1.2, 0.7, 1.5, 1.9};
    for (int trial = 0; trial < 20; ++trial) {
        const Cell cell = random_cell(random);
        const Populations after = collided(collision, cell);
        const double rho = cell.rho0 + moment(cell.before, 0, 0, 0);
        const Vec3<double> u = velocity_of(moments_of(cell.before.g), cell.rho0, cell.force);
        const Populations target = equilibrium(rho, cell.rho0, u);
        const Populations source = guo_term(cell.force, u);
        for (int p = 0; p < direction_count; ++p) {
            const double lambda = p <= 9 ? cell.rate : p == 10 ? 1.2 : p <= 13 ? 0.7 : p <= 16 ? 1.5 : 1.9;
            const double before = paper_moment(p, cell.before);
            const double expected = before + lambda * (paper_moment(p, target) - before) +
                                    (1.0 - 0.5 * lambda) * paper_moment(p, source);
            INFO("moment " << p);
            CHECK(std::abs(paper_moment(p, after) - expected) < 1e-14);
            largest = std::max(largest, std::abs(paper_moment(p, after) - expected));
        }
    }
    test::measured("moments after collision with source, paper's basis", "largest error", largest);
}
