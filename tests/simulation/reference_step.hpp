#pragma once

#include "case/engine_state.hpp"
#include "lattice/velocity_set.hpp"
#include "simulation/layer_reach.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vesica::test {

/// A step of the method written down as plainly as it can be: whole boxes of doubles, a loop over the cells
/// for each formula, two lattices, no tiles, no packs, no threads and none of the program's kernels. It keeps
/// the program's rule of where colours, geometry and forces are worked out: cells within so many links of
/// those that had a force when the band was last laid out. A Helfrich membrane with constant tension and
/// C0 = 0, the regularised collision, the mapped geometry.
class ReferenceStep {
public:
    struct Constants {
        double nu = 1.0 / 6.0;
        double beta = 0.67;
        double kappa = 0.1;
        double sigma = 0.0;
        double cutoff = 1e-2;
    };

    ReferenceStep(const EngineState& state, const Constants& constants)
        : size_(state.size), constants_(constants), cells_(state.minority.size()) {
        for (int i = 0; i < direction_count; ++i) {
            w_[i] = weight(i);
            for (int a = 0; a < 3; ++a) {
                c_[i][a] = velocity(i, a);
                for (int b = 0; b < 3; ++b)
                    cc_[i][a][b] = velocity(i, a) * velocity(i, b) - (a == b ? 1.0 / 3.0 : 0.0);
            }
        }
        neighbour_.resize(cells_);
        f_.resize(cells_);
        red_.assign(cells_, 0.0);
        blue_.assign(cells_, 0.0);
        std::vector<bool> core(cells_);
        for_each_cell([&](int x, int y, int z, std::size_t at) {
            for (int i = 0; i < direction_count; ++i) {
                neighbour_[at][i] = index(x + velocity(i, 0), y + velocity(i, 1), z + velocity(i, 2));
                f_[at][i] = state.populations[static_cast<std::size_t>(i)][at] + weight(i);
            }
            core[at] = (state.band[at] & 1) != 0;
            const double minor = std::abs(state.minority[at]);
            const bool inside = std::signbit(state.minority[at]);
            red_[at] = inside ? 1.0 - minor : minor;
            blue_[at] = inside ? minor : 1.0 - minor;
        });
        lay_out(core);
        weigh();
        surface();
        geometry();
    }

    void step() {
        collide();
        stream();
        carry_colours();
        give_back();
        surface();
        if (std::any_of(all_.begin(), all_.end(), [&](std::size_t c) { return core_[c] && level_[c] > 1; })) {
            follow_core();
            give_back();
            surface();
        }
        geometry();
    }

    /// f_i - t_i of a cell, cells in canonical order.
    double deviation(int i, std::size_t cell) const { return f_[cell][i] - weight(i); }
    /// Mass fraction of the colour in the minority, with the sign bit where that is blue.
    double minority(std::size_t cell) const { return blue_[cell] < red_[cell] ? -blue_[cell] : red_[cell]; }
    std::size_t layouts() const { return layouts_; }

private:
    template <class T, std::size_t count>
    struct List {
        T values[count] = {};
        T& operator[](int k) { return values[k]; }
        const T& operator[](int k) const { return values[k]; }
        const T* begin() const { return values; }
        const T* end() const { return values + count; }
    };
    static constexpr int outermost = reach::receiving + 1;
    using Vector = List<double, 3>;
    using Matrix = List<Vector, 3>;
    using Populations = List<double, direction_count>;
    using Scalars = std::vector<double>;
    using Vectors = std::vector<Vector>;

    std::size_t index(int x, int y, int z) const {
        const auto wrap = [](int a, int n) {
            return (a + n) % n;
        };
        return static_cast<std::size_t>((wrap(z, size_.z) * size_.y + wrap(y, size_.y)) * size_.x +
                                        wrap(x, size_.x));
    }
    template <class Body>
    void for_each_cell(const Body& body) const {
        std::size_t at = 0;
        for (int z = 0; z < size_.z; ++z)
            for (int y = 0; y < size_.y; ++y)
                for (int x = 0; x < size_.x; ++x)
                    body(x, y, z, at++);
    }
    template <class Body>
    void within(int level, const Body& body) const {
        for (const std::size_t c : all_)
            if (level_[c] <= level)
                body(c);
    }
    double layer(std::size_t c) const { return 4.0 * red_[c] * blue_[c]; }

    /// Links from the nearest cell of the core; ten beyond nine.
    void lay_out(const std::vector<bool>& core) {
        ++layouts_;
        level_.assign(cells_, outermost + 1);
        for (std::size_t c = 0; c < cells_; ++c)
            if (core[c])
                level_[c] = 0;
        for (int level = 0; level < outermost; ++level)
            for (std::size_t c = 0; c < cells_; ++c)
                if (level_[c] == level)
                    for (const std::size_t next : neighbour_[c])
                        level_[next] = std::min(level_[next], level + 1);
        all_.clear();
        for (std::size_t c = 0; c < cells_; ++c)
            if (level_[c] <= outermost)
                all_.push_back(c);
        core_ = core;
        force_.assign(cells_, {});
        flux_.assign(cells_, {});
    }

    void weigh() {
        density_.assign(cells_, 1.0);
        for (const std::size_t c : all_) {
            density_[c] = 0.0;
            for (const double f : f_[c])
                density_[c] += f;
        }
    }

    void collide() {
        const double rate = 1.0 / (3.0 * constants_.nu + 0.5);
        for (std::size_t c = 0; c < cells_; ++c) {
            const Vector F = force_[c];
            double rho = 0.0;
            Vector j{};
            Matrix P{};
            for (int i = 0; i < direction_count; ++i) {
                rho += f_[c][i];
                for (int a = 0; a < 3; ++a) {
                    j[a] += f_[c][i] * c_[i][a];
                    for (int b = 0; b <= a; ++b)
                        P[a][b] += f_[c][i] * cc_[i][a][b];
                }
            }
            Vector u{};
            for (int a = 0; a < 3; ++a)
                u[a] = (j[a] + 0.5 * F[a]) / rho;
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b <= a; ++b)
                    P[a][b] = (1.0 - rate) * P[a][b] + rate * rho * u[a] * u[b] +
                              (1.0 - 0.5 * rate) * (F[a] * u[b] + F[b] * u[a]);
            for (int i = 0; i < direction_count; ++i) {
                double sum = rho;
                for (int a = 0; a < 3; ++a) {
                    sum += 3.0 * (j[a] + F[a]) * c_[i][a];
                    for (int b = 0; b <= a; ++b)
                        sum += (a == b ? 4.5 : 9.0) * P[a][b] * cc_[i][a][b];
                }
                f_[c][i] = w_[i] * sum;
            }
        }
    }

    void stream() {
        std::vector<Populations> streamed(cells_);
        for (std::size_t c = 0; c < cells_; ++c)
            for (int i = 0; i < direction_count; ++i)
                streamed[neighbour_[c][i]][i] = f_[c][i];
        f_ = std::move(streamed);
    }

    /// rho_R = sum_i [ (rho_R/rho) f_i - t_i c_i.w ] of where f_i came from, and blue likewise.
    void carry_colours() {
        Scalars red = red_;
        Scalars blue = blue_;
        weigh();
        within(reach::receiving, [&](std::size_t c) {
            double reds = 0.0;
            double blues = 0.0;
            for (int i = 0; i < direction_count; ++i) {
                const std::size_t from = neighbour_[c][opposite(i)];
                double separated = 0.0;
                for (int a = 0; a < 3; ++a)
                    separated += w_[i] * c_[i][a] * flux_[from][a];
                reds += red_[from] * f_[c][i] - separated;
                blues += blue_[from] * f_[c][i] + separated;
            }
            const bool blue_is_minor = blues < reds;
            const double minor = std::min(reds, blues);
            const double stays = level_[c] <= reach::colour ? std::max(minor, 0.0) : 0.0;
            leaked_ += (blue_is_minor ? -1.0 : 1.0) * (minor - stays);
            (blue_is_minor ? blue : red)[c] = stays / density_[c];
            (blue_is_minor ? red : blue)[c] = 1.0 - stays / density_[c];
        });
        red_ = std::move(red);
        blue_ = std::move(blue);
    }

    /// What has left the band, to its cells in proportion to 1 - phi^2.
    void give_back() {
        double sum = 0.0;
        within(reach::colour, [&](std::size_t c) { sum += layer(c); });
        const double share = leaked_ / sum;
        leaked_ = 0.0;
        within(reach::colour, [&](std::size_t c) {
            const double more_red = share * layer(c) / density_[c];
            red_[c] += more_red;
            blue_[c] -= more_red;
        });
    }

    /// Signed distance, the force's profile, and the cells that have a force.
    void surface() {
        s_.assign(cells_, 0.0);
        psi_.assign(cells_, 0.0);
        core_.assign(cells_, false);
        for (const std::size_t c : all_) {
            const double floor = 1e-8;
            const bool inside = blue_[c] < red_[c];
            const double minor = std::max(inside ? blue_[c] : red_[c], floor);
            s_[c] = (inside ? -1.0 : 1.0) * std::log((1.0 - minor) / minor) / (2.0 * constants_.beta);
            const double x = std::clamp((red_[c] - blue_[c]) / std::sqrt(1.0 - constants_.cutoff), -1.0, 1.0);
            psi_[c] = 0.5 * (3.0 * x - x * x * x);
            core_[c] = level_[c] <= reach::colour && layer(c) > constants_.cutoff;
        }
    }

    /// The band around where the core is now; what it lets go of has leaked.
    void follow_core() {
        const std::vector<int> old_level = level_;
        const std::vector<bool> core = core_;
        lay_out(core);
        for (std::size_t c = 0; c < cells_; ++c)
            if (old_level[c] <= reach::colour && level_[c] > reach::colour) {
                const bool inside = blue_[c] < red_[c];
                leaked_ += density_[c] * (inside ? -blue_[c] : red_[c]);
                red_[c] = inside ? 1.0 : 0.0;
                blue_[c] = inside ? 0.0 : 1.0;
            }
        weigh();
    }

    Vector gradient(const Scalars& q, std::size_t c) const {
        Vector g{};
        for (int i = 1; i < direction_count; ++i)
            for (int a = 0; a < 3; ++a)
                g[a] += 3.0 * w_[i] * c_[i][a] * q[neighbour_[c][i]];
        return g;
    }
    double laplacian(const Scalars& q, std::size_t c) const {
        double sum = 0.0;
        for (int i = 1; i < direction_count; ++i)
            sum += 6.0 * w_[i] * (q[neighbour_[c][i]] - q[c]);
        return sum;
    }
    /// [i][j] = d_j v_i. Of normals: those that point away from the one here count the other way round, and
    /// one that is missing as the one here.
    Matrix jacobian(const Vectors& v, std::size_t c, bool of_normals = false) const {
        Matrix d{};
        for (int i = 1; i < direction_count; ++i) {
            const Vector& there = v[neighbour_[c][i]];
            const double along = dot(there, v[c]);
            const double sign = !of_normals || along > 0.0 ? 1.0 : -1.0;
            const Vector& counted = of_normals && along == 0.0 ? v[c] : there;
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                    d[a][b] += 3.0 * w_[i] * c_[i][b] * (along == 0.0 ? 1.0 : sign) * counted[a];
        }
        return d;
    }
    static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

    /// W = P G P for a unit normal n.
    static Matrix projected(const Matrix& G, const Vector& n) {
        Matrix W{};
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                for (int k = 0; k < 3; ++k)
                    for (int l = 0; l < 3; ++l)
                        W[a][b] += ((a == k) - n[a] * n[k]) * G[k][l] * ((l == b) - n[l] * n[b]);
        return W;
    }

    void geometry() {
        Scalars sharp(cells_, 0.0);
        within(reach::receiving, [&](std::size_t c) { sharp[c] = s_[c] - laplacian(s_, c) / 6.0; });
        Vectors n(cells_);
        within(reach::colour, [&](std::size_t c) {
            n[c] = gradient(sharp, c);
            const double length = std::sqrt(dot(n[c], n[c]));
            for (int a = 0; a < 3; ++a) {
                n[c][a] /= std::max(length, 1e-300);
                flux_[c][a] = 0.25 * constants_.beta * density_[c] * layer(c) * n[c][a];
                if (length < 0.5)
                    n[c][a] = 0.0;
            }
        });
        Scalars raw(cells_, 0.0);
        Scalars K0(cells_, 0.0);
        Scalars J(cells_, 1.0);
        within(4, [&](std::size_t c) {
            const Matrix G = jacobian(n, c, true);
            const Matrix W = projected(G, n[c]);
            const double trace = W[0][0] + W[1][1] + W[2][2];
            double square = 0.0;
            for (int a = 0; a < 3; ++a)
                square += W[a][0] * W[0][a] + W[a][1] * W[1][a] + W[a][2] * W[2][a];
            const double divergence = G[0][0] + G[1][1] + G[2][2];
            const double plain = 0.5 * (trace * trace - square);
            const double restored = 1.0 + (divergence * divergence - 2.0 * plain) / 6.0;
            const double H = 0.5 * divergence;
            const double K = restored * restored * plain;
            J[c] = std::clamp(1.0 - 2.0 * s_[c] * H + s_[c] * s_[c] * K, 0.1, 10.0);
            raw[c] = (H - s_[c] * K) / J[c];
            K0[c] = K / J[c];
        });
        Scalars H0(cells_, 0.0);
        Scalars sharp_H(cells_, 0.0);
        within(3, [&](std::size_t c) {
            H0[c] = raw[c] - laplacian(raw, c) / 6.0;
            sharp_H[c] = raw[c] - 0.5 * laplacian(raw, c);
        });
        Vectors g(cells_);
        within(2, [&](std::size_t c) {
            // A^2 grad_s H0/J with the adjugate A = (1 - 2 s H) P + s W of 1 - s W.
            const Matrix G = jacobian(n, c);
            const double H = J[c] * (raw[c] + s_[c] * K0[c]); // the cell's own
            const double spherical = 1.0 - 2.0 * s_[c] * H;
            const auto tangential = [&](Vector v) {
                const double normal = dot(v, n[c]);
                for (int a = 0; a < 3; ++a)
                    v[a] -= normal * n[c][a];
                return v;
            };
            Vector v = tangential(gradient(sharp_H, c));
            for (int twice = 0; twice < 2; ++twice) {
                const Vector Wv = tangential({dot(G[0], v), dot(G[1], v), dot(G[2], v)});
                for (int a = 0; a < 3; ++a)
                    v[a] = spherical * v[a] + s_[c] * Wv[a];
            }
            for (int a = 0; a < 3; ++a)
                g[c][a] = v[a] / J[c];
        });
        within(1, [&](std::size_t c) {
            const Matrix d = jacobian(g, c);
            double divergence = d[0][0] + d[1][1] + d[2][2];
            for (int a = 0; a < 3; ++a)
                divergence -= n[c][a] * dot(d[a], n[c]);
            const double H = H0[c];
            const double bending = constants_.kappa * (2.0 * divergence / J[c] + 4.0 * H * (H * H - K0[c]));
            const double normal_force = bending - 2.0 * constants_.sigma * H;
            const Vector slope = gradient(psi_, c);
            for (int a = 0; a < 3; ++a)
                force_[c][a] = -0.5 * normal_force * slope[a];
        });
    }

    Vec3<int> size_;
    List<double, direction_count> w_;
    List<Vector, direction_count> c_;
    List<Matrix, direction_count> cc_; ///< c c - 1/3
    Constants constants_;
    std::size_t cells_;
    std::vector<List<std::size_t, direction_count>> neighbour_;
    std::vector<Populations> f_;
    Scalars red_;  ///< rho_R/rho
    Scalars blue_; ///< rho_B/rho, kept apart: a small fraction keeps its digits
    Scalars density_;
    Scalars s_;
    Scalars psi_;
    Vectors flux_; ///< beta (rho_R rho_B/rho) n
    Vectors force_;
    std::vector<int> level_;
    std::vector<std::size_t> all_; ///< cells of the band
    std::vector<bool> core_;
    double leaked_ = 0.0;
    std::size_t layouts_ = 0;
};

} // namespace vesica::test
