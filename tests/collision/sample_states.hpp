#pragma once

#include "collision/paper_mrt.hpp"
#include "collision/regularised.hpp"
#include "collision/symmetric_mrt.hpp"

#include <cmath>
#include <cstddef>
#include <random>

/// Cells to collide: populations near equilibrium, with ghosts, in a force.
namespace vesica::sample {

struct Populations {
    double g[direction_count] = {};

    double& operator[](int i) { return g[i]; }
    double operator[](int i) const { return g[i]; }
};

struct Cell {
    Populations before;
    Vec3<double> force;
    double rate = 1.0;
    double rho0 = 1.0;
};

inline Cell random_cell(std::mt19937_64& random) {
    std::uniform_real_distribution<double> small(-0.02, 0.02);
    std::uniform_real_distribution<double> rate(0.3, 1.9);
    Cell cell;
    for (int i = 0; i < direction_count; ++i)
        cell.before[i] = weight(i) * 0.1 + small(random);
    cell.force = {small(random), small(random), small(random)};
    cell.rate = rate(random);
    cell.rho0 = 1.3;
    return cell;
}

template <class Collision>
Populations collided(const Collision& collision, const Cell& cell) {
    Populations after = cell.before;
    collision(after.g, cell.force, cell.rate, cell.rho0);
    return after;
}

inline double largest_difference(const Populations& a, const Populations& b) {
    double largest = 0.0;
    for (int i = 0; i < direction_count; ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// sum_i g_i c_x^px c_y^py c_z^pz
inline double moment(const Populations& p, int px, int py, int pz) {
    double sum = 0.0;
    for (int i = 0; i < direction_count; ++i)
        sum +=
            p[i] * std::pow(velocity(i, 0), px) * std::pow(velocity(i, 1), py) * std::pow(velocity(i, 2), pz);
    return sum;
}

/// f_i^eq - t_i rho0 = t_i {rho [1 + 3 u.c + (9/2) (u.c)^2 - (3/2) u^2] - rho0}
inline Populations equilibrium(double rho, double rho0, const Vec3<double>& u) {
    Populations p;
    for (int i = 0; i < direction_count; ++i) {
        const double cu = u.x * velocity(i, 0) + u.y * velocity(i, 1) + u.z * velocity(i, 2);
        p[i] = weight(i) * (rho * (1.0 + 3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u)) - rho0);
    }
    return p;
}

/// Guo's term before its factor (Guo et al. 2002, Eq 20): t_i [3 (c - u).F + 9 (c.u)(c.F)].
inline Populations guo_term(const Vec3<double>& F, const Vec3<double>& u) {
    Populations p;
    for (int i = 0; i < direction_count; ++i) {
        const Vec3<double> c{double(velocity(i, 0)), double(velocity(i, 1)), double(velocity(i, 2))};
        p[i] = weight(i) * (3.0 * dot(c - u, F) + 9.0 * dot(c, u) * dot(c, F));
    }
    return p;
}

/// body(collision, name) for every collision there is, with rates of its own.
template <class Body>
void for_each_collision(const Body& body) {
    body(RegularisedCollision{}, "regularised");
    body(SymmetricMrt<SingleRelaxationTime>{}, "single relaxation time");
    body(SymmetricMrt<TwoRelaxationTimes>{}, "two relaxation times");
    body(SymmetricMrt<FreeGhostRates>{{1.1, 1.3, 0.9, 1.7}}, "free ghost rates");
    body(PaperMrt{1.2, 0.7, 1.5, 1.9}, "paper");
}

} // namespace vesica::sample
