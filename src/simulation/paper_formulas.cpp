#include "simulation/paper_formulas.hpp"

#include "collision/equilibrium.hpp"
#include "collision/paper_mrt.hpp"
#include "core/real.hpp"
#include "geometry/normal.hpp"
#include "geometry/paper_frames.hpp"

#include <nlohmann/json.hpp>

#include <random>

namespace vesica {

namespace {

using Json = nlohmann::ordered_json;

constexpr int collision_samples = 12;
constexpr int surface_samples = 500;

Json row_of(const Vec3<double>& v) {
    return {v.x, v.y, v.z};
}

Json velocity_set() {
    Json set;
    for (int i = 0; i < direction_count; ++i) {
        set["velocities"].push_back({velocity(i, 0), velocity(i, 1), velocity(i, 2)});
        set["weights"].push_back(weight(i));
        set["ghost_weights"].push_back(ghost_weight(i));
    }
    return set;
}

/// Deviations from t_i rho0 with all moments, physical and not, and a force.
Json collide(std::mt19937_64& random) {
    std::uniform_real_distribution<double> small(-0.02, 0.02);
    std::uniform_real_distribution<double> rate(0.3, 1.9);
    const double rho0 = 1.0;
    double g[direction_count];
    for (double& entry : g)
        entry = small(random);
    Json sample;
    sample["reference_density"] = rho0;
    sample["before"] = g;
    const Vec3<double> force{small(random), small(random), small(random)};
    const double l4 = rate(random);
    const PaperMrt collision{rate(random), rate(random), rate(random), rate(random)};
    collision(g, force, l4, rho0);
    sample["force"] = row_of(force);
    sample["rates"] = {{"l4", l4},
                       {"l10", collision.l10},
                       {"l11", collision.l11},
                       {"l14", collision.l14},
                       {"l17", collision.l17}};
    sample["after"] = g;
    return sample;
}

Vec3<double> random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return unit_vector(Vec3<double>{normal(random), normal(random), normal(random)});
}

Json pair_of(const Curvatures<double>& c) {
    return {c.H, c.K};
}

/// A surface's point: d_j n_i = kappa1 e1 e1 + kappa2 e2 e2 for tangents e1, e2 across the normal.
Json surface_point(std::mt19937_64& random) {
    std::uniform_real_distribution<double> curvature(-0.2, 0.2);
    const Vec3<double> n = random_direction(random);
    const Vec3<double> e1 = unit_vector(cross(n, random_direction(random)));
    const Vec3<double> e2 = cross(n, e1);
    const double kappa1 = curvature(random);
    const double kappa2 = curvature(random);
    const auto row = [&](int i) {
        return kappa1 * e1[i] * e1 + kappa2 * e2[i] * e2;
    };
    const Jacobian<double> G{row(0), row(1), row(2)};
    Json sample;
    sample["principal_curvatures"] = {kappa1, kappa2};
    sample["normal"] = row_of(n);
    sample["derivatives"] = {row_of(G.x), row_of(G.y), row_of(G.z)};
    sample["frame_free"] = pair_of(curvatures_of(G, n));
    // The paper's frames 1, 2, 3 divide by what is left of the normal across z, x and y.
    sample["frames"] = {pair_of(curvatures_in_frame_of<2>(G, n)), pair_of(curvatures_in_frame_of<0>(G, n)),
                        pair_of(curvatures_in_frame_of<1>(G, n))};
    sample["chosen"] = pair_of(paper_curvatures_of(G, n));
    return sample;
}

} // namespace

std::string paper_formulas_json() {
    std::mt19937_64 random(20210);
    Json all;
    all["lattice"] = velocity_set();
    all["M"] = paper_basis::M;
    all["M_inverse"] = paper_basis::M_inverse;
    for (int k = 0; k < collision_samples; ++k)
        all["collisions"].push_back(collide(random));
    for (int k = 0; k < surface_samples; ++k)
        all["surfaces"].push_back(surface_point(random));
    return all.dump() + "\n";
}

} // namespace vesica
