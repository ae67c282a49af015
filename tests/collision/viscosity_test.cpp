#include "collision/paper_mrt.hpp"
#include "collision/regularised.hpp"
#include "collision/relaxation.hpp"
#include "collision/symmetric_mrt.hpp"
#include "lattice/velocity_set.hpp"
#include "measured.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace vesica;

namespace {

/// A shear wave u = e cos(k.x) with e across k, started with the stress that belongs to it.
struct ShearWave {
    Vec3<int> size;  ///< periodic box
    Vec3<int> waves; ///< k = 2 pi waves/size
    Vec3<double> e;  ///< unit vector, e.k = 0

    Vec3<double> k() const {
        const double turn = 2.0 * std::numbers::pi;
        return {turn * waves.x / size.x, turn * waves.y / size.y, turn * waves.z / size.z};
    }
    double phase(int x, int y, int z) const {
        return dot(k(), Vec3<double>{double(x), double(y), double(z)});
    }
};

template <class Body>
void for_each_cell(const Vec3<int>& size, const Body& body) {
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                body(x, y, z);
}

/// Fluid without packs, bands or boundaries: collide every cell, then stream to another copy.
struct PlainFluid {
    using Populations = std::array<double, direction_count>;

    Vec3<int> size;
    std::vector<Populations> cells;
    std::vector<Populations> next;

    explicit PlainFluid(const Vec3<int>& box)
        : size(box), cells(static_cast<std::size_t>(box.x * box.y * box.z)), next(cells.size()) {}

    std::size_t at(int x, int y, int z) const {
        const auto home = [](int a, int n) {
            return a < 0 ? a + n : a >= n ? a - n : a;
        };
        return static_cast<std::size_t>(home(x, size.x) +
                                        size.x * (home(y, size.y) + size.y * home(z, size.z)));
    }

    template <class Collision>
    void step(const Collision& collision, double rate) {
        for (Populations& cell : cells) {
            double g[direction_count];
            std::copy(cell.begin(), cell.end(), g);
            collision(g, Vec3<double>{}, rate, 1.0);
            std::copy(g, g + direction_count, cell.begin());
        }
        for_each_cell(size, [&](int x, int y, int z) {
            const Populations& from = cells[at(x, y, z)];
            for (int i = 0; i < direction_count; ++i)
                next[at(x + velocity(i, 0), y + velocity(i, 1), z + velocity(i, 2))]
                    [static_cast<std::size_t>(i)] = from[static_cast<std::size_t>(i)];
        });
        std::swap(cells, next);
    }
};

/// The viscosity found from the wave's decay to about three quarters.
template <class Collision>
double measured_viscosity(const Collision& collision, double nu, const ShearWave& wave) {
    PlainFluid fluid(wave.size);
    const double rate = relaxation_rate(nu);
    const double amplitude = 1e-3;
    const Vec3<double> k = wave.k();
    for_each_cell(wave.size, [&](int x, int y, int z) {
        const Vec3<double> u = amplitude * std::cos(wave.phase(x, y, z)) * wave.e;
        Moments<double> m = equilibrium_moments(1.0, 1.0, u);
        // Pi - Pi_eq = -(1/(3 lambda)) rho (d_a u_b + d_b u_a), here d_a u_b = -k_a e_b sin(k.x)
        const double s = amplitude * std::sin(wave.phase(x, y, z)) / (3.0 * rate);
        const Vec3<double>& e = wave.e;
        m.stress.xx += 2.0 * s * k.x * e.x;
        m.stress.yy += 2.0 * s * k.y * e.y;
        m.stress.zz += 2.0 * s * k.z * e.z;
        m.stress.xy += s * (k.x * e.y + k.y * e.x);
        m.stress.xz += s * (k.x * e.z + k.z * e.x);
        m.stress.yz += s * (k.y * e.z + k.z * e.y);
        double g[direction_count];
        populations_of(m, g);
        std::copy(g, g + direction_count, fluid.cells[fluid.at(x, y, z)].begin());
    });
    const auto height = [&] {
        double sum = 0.0;
        for_each_cell(wave.size, [&](int x, int y, int z) {
            double g[direction_count];
            const auto& cell = fluid.cells[fluid.at(x, y, z)];
            std::copy(cell.begin(), cell.end(), g);
            sum += dot(moments_of(g).momentum, wave.e) * std::cos(wave.phase(x, y, z));
        });
        return sum;
    };
    const int steps = 2 * static_cast<int>(std::lround(0.15 / (nu * dot(k, k))));
    const double before = height();
    for (int step = 0; step < steps; ++step)
        fluid.step(collision, rate);
    return std::log(before / height()) / (dot(k, k) * steps);
}

template <class Collision>
void check_viscosity(const std::string& name, const Collision& collision, double nu) {
    const double half = std::sqrt(0.5);
    const auto error = [&](const ShearWave& wave) {
        return std::abs(measured_viscosity(collision, nu, wave) / nu - 1.0);
    };
    SECTION("along an axis: 0.1 % at 64 cells, second order") {
        const auto at = [&](int cells) {
            const double found = error({{cells, 1, 1}, {1, 0, 0}, {0, 0.6, 0.8}});
            test::measured("viscosity from a decaying shear wave, relative error",
                           name + ", " + std::to_string(cells) + " cells", found);
            return found;
        };
        const double errors[] = {at(8), at(16), at(32), at(64)};
        CHECK(errors[3] < 1e-3);
        CHECK(std::log2(errors[1] / errors[2]) == Approx(2.0).margin(0.1));
        CHECK(std::log2(errors[2] / errors[3]) == Approx(2.0).margin(0.1));
    }
    SECTION("along a face's diagonal, sheared in the face and out of it: 0.1 % at 48 cells") {
        for (const Vec3<double>& e : {Vec3<double>{0, 0, 1}, Vec3<double>{half, -half, 0}})
            CHECK(error({{48, 48, 1}, {1, 1, 0}, e}) < 1e-3);
    }
    SECTION("along the body's diagonal: 2 % at 24 cells, fourteen from crest to crest") {
        CHECK(error({{24, 24, 24}, {1, 1, 1}, {half, -half, 0}}) < 2e-2);
    }
}

} // namespace

TEST_CASE("a shear wave decays with nu = (1/3)(1/lambda - 1/2): regularised", "[collision]") {
    check_viscosity("regularised", RegularisedCollision{}, 0.08);
}

TEST_CASE("a shear wave decays with nu = (1/3)(1/lambda - 1/2): two relaxation times", "[collision]") {
    check_viscosity("two relaxation times", SymmetricMrt<TwoRelaxationTimes>{}, 0.08);
}

TEST_CASE("a shear wave decays with nu = (1/3)(1/lambda - 1/2): free ghost rates", "[collision]") {
    check_viscosity("free ghost rates", SymmetricMrt<FreeGhostRates>{{1.1, 1.3, 0.9, 1.7}}, 0.08);
}

TEST_CASE("a shear wave decays with nu = (1/3)(1/lambda - 1/2): single relaxation time", "[collision]") {
    check_viscosity("single relaxation time", SymmetricMrt<SingleRelaxationTime>{}, 0.08);
}

TEST_CASE("a shear wave decays with nu = (1/3)(1/lambda - 1/2): the paper's basis", "[collision]") {
    check_viscosity("paper's basis", PaperMrt{1.2, 0.7, 1.5, 1.9}, 0.08);
}
