#include "collision/regularised.hpp"
#include "colour/recolouring.hpp"
#include "measured.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace vesica;

namespace {

int wrapped(int x, int size) {
    return ((x % size) + size) % size;
}

/// Values at x + c_i, for whoever asks with a Direction.
struct Around {
    std::function<double(int)> value;
    template <int i>
    double operator()(Direction<i>) const {
        return value(i);
    }
};

/// Two colours on a periodic box, cell by cell and without hurry: collide, stream, gather. One fluid in
/// uniform motion or with populations of any kind; what it shows of the colours is the law's own doing.
struct PlainColours {
    using Populations = double[direction_count];
    struct Cell {
        Populations g = {};
    };

    Vec3<int> size;
    double beta;
    std::size_t cells;
    std::vector<double> chi;
    std::vector<double> density;
    std::vector<Vec3<double>> n;
    std::vector<Cell> f;

    PlainColours(const Vec3<int>& box, double segregation)
        : size(box),
          beta(segregation),
          cells(static_cast<std::size_t>(box.x * box.y * box.z)),
          chi(cells, 0.0),
          density(cells, 1.0),
          n(cells),
          f(cells) {}

    std::size_t at(int x, int y, int z) const {
        return static_cast<std::size_t>(wrapped(x, size.x) +
                                        size.x * (wrapped(y, size.y) + size.y * wrapped(z, size.z)));
    }

    template <class Body>
    void for_each(const Body& body) const {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    body(x, y, z);
    }

    Populations& populations(std::size_t cell) { return f[cell].g; }

    void point_normals_along_the_gradient() {
        for_each([&](int x, int y, int z) {
            Vec3<double> gradient;
            for (int i = 1; i < direction_count; ++i) {
                const double phi =
                    weight(i) * phase_of(chi[at(x + velocity(i, 0), y + velocity(i, 1), z + velocity(i, 2))]);
                gradient =
                    gradient - Vec3<double>{phi * velocity(i, 0), phi * velocity(i, 1), phi * velocity(i, 2)};
            }
            const double steepness = norm(gradient);
            n[at(x, y, z)] = steepness > 0.0 ? (1.0 / steepness) * gradient : Vec3<double>{};
        });
    }

    void collide(double rate) {
        for (Cell& cell : f)
            RegularisedCollision{}(cell.g, Vec3<double>{}, rate, 1.0);
    }

    /// Streams the populations and gathers the colours that came with them.
    void stream() {
        std::vector<Vec3<double>> w(cells);
        for (std::size_t c = 0; c < cells; ++c)
            w[c] = segregation_flux(chi[c], density[c], n[c], beta);
        std::vector<Cell> arrived(cells);
        std::vector<double> next(cells);
        for_each([&](int x, int y, int z) {
            const std::size_t here = at(x, y, z);
            const auto there = [&](int i) {
                return at(x + velocity(i, 0), y + velocity(i, 1), z + velocity(i, 2));
            };
            for (int i = 0; i < direction_count; ++i)
                arrived[here].g[i] = f[there(opposite(i))].g[i];
            double total = 1.0;
            for (const double g : arrived[here].g)
                total += g;
            const bool blue_is_minor = sign_bit(chi[here]);
            const auto fraction_around = [&](auto from) {
                const double other = chi[there(decltype(from)::value)];
                return blue_is_minor ? blue_fraction(other) : red_fraction(other);
            };
            const auto flux_around = [&](int axis) {
                return std::function<double(int)>([&, axis](int i) { return w[there(i)][axis]; });
            };
            const ColourDensities<double> colours =
                gather_colours(arrived[here].g, 1.0, total, blue_is_minor, fraction_around,
                               Vec3<Around>{{flux_around(0)}, {flux_around(1)}, {flux_around(2)}});
            density[here] = total;
            next[here] = colours.blue < colours.red ? -colours.blue / total : colours.red / total;
        });
        f = std::move(arrived);
        chi = std::move(next);
    }

    double red_mass() const {
        long double sum = 0.0L;
        for (std::size_t c = 0; c < cells; ++c)
            sum += static_cast<long double>(red_fraction(chi[c])) * density[c];
        return static_cast<double>(sum);
    }
    double blue_mass() const {
        long double sum = 0.0L;
        for (std::size_t c = 0; c < cells; ++c)
            sum += static_cast<long double>(blue_fraction(chi[c])) * density[c];
        return static_cast<double>(sum);
    }
};

/// A red slab in the middle of a long periodic box, phi = -tanh(beta s) at either face.
PlainColours slab(int length, double beta) {
    PlainColours colours({length, 1, 1}, beta);
    for (int x = 0; x < length; ++x) {
        const double s = std::abs(x + 0.5 - 0.5 * length + 0.13) - 0.25 * length;
        colours.chi[colours.at(x, 0, 0)] = chi_of_phase(-std::tanh(beta * s));
    }
    return colours;
}

/// Where the red lies along x in a periodic box: the phase of its first harmonic.
double centre_of_red(const PlainColours& colours, int length) {
    double sine = 0.0;
    double cosine = 0.0;
    const double turn = 2.0 * std::acos(-1.0) / length;
    for (int x = 0; x < length; ++x) {
        const double red = red_fraction(colours.chi[colours.at(x, 0, 0)]);
        sine += red * std::sin(turn * (x + 0.5));
        cosine += red * std::cos(turn * (x + 0.5));
    }
    return std::atan2(sine, cosine) / turn;
}

} // namespace

TEST_CASE("streaming and gathering keep each colour's mass, for any populations, fractions and normals",
          "[colour]") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> fraction(0.0, 0.5);
    std::uniform_real_distribution<double> small(-0.01, 0.01);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 20; ++trial) {
        PlainColours colours({5, 3, 4}, 0.67);
        colours.for_each([&](int x, int y, int z) {
            const std::size_t c = colours.at(x, y, z);
            colours.chi[c] = with_sign_bit(random() % 2 == 0, fraction(random));
            double sum = 1.0;
            for (int i = 0; i < direction_count; ++i)
                sum += colours.populations(c)[i] = small(random);
            colours.density[c] = sum;
            const Vec3<double> a{normal(random), normal(random), normal(random)};
            colours.n[c] = (1.0 / norm(a)) * a;
        });
        const double red = colours.red_mass();
        const double blue = colours.blue_mass();
        colours.stream();
        CHECK(std::abs(colours.red_mass() - red) < 1e-14 * red);
        CHECK(std::abs(colours.blue_mass() - blue) < 1e-14 * blue);
    }
}

TEST_CASE("the two colours together are the fluid: recolouring moves no mass of the whole", "[colour]") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> any(-0.01, 0.01);
    double g[direction_count];
    double sum = 1.0;
    for (double& value : g)
        sum += value = any(random);
    const auto fraction = [](auto i) {
        return decltype(i)::value % 2 == 0 ? 0.3 : 0.8;
    };
    const auto other_fraction = [&](auto i) {
        return 1.0 - fraction(i);
    };
    const Around flux{[](int i) {
        return 0.01 * i;
    }};
    const Vec3<Around> w{flux, flux, flux};
    const ColourDensities<double> arrived = gather_colours(g, 1.0, sum, false, fraction, w);
    const ColourDensities<double> seen_by_blue = gather_colours(g, 1.0, sum, true, other_fraction, w);
    CHECK(arrived.red == Approx(seen_by_blue.red).epsilon(1e-14)); // whichever of the two is summed
    CHECK(arrived.blue == Approx(seen_by_blue.blue).epsilon(1e-14));
    double red = 0.0;
    for_each_direction([&](auto i) {
        constexpr int from = opposite(decltype(i)::value);
        const double separated = weight(i) * 0.01 * from * (velocity(i, 0) + velocity(i, 1) + velocity(i, 2));
        red += fraction(Direction<from>{}) * (weight(i) + g[i]) - separated;
    });
    CHECK(arrived.red == Approx(red).epsilon(1e-14));
    CHECK(arrived.red + arrived.blue == Approx(sum).epsilon(1e-15));
}

TEST_CASE("the flux w = beta (rho_R rho_B/rho) n, largest where the colours are equal, none in pure fluid",
          "[colour]") {
    const Vec3<double> n{0.6, 0.0, -0.8};
    for (const double chi : {0.1, -0.1, 0.5}) {
        const double red = red_fraction(chi) * 1.2;
        const double blue = blue_fraction(chi) * 1.2;
        const Vec3<double> w = segregation_flux(chi, 1.2, n, 0.67);
        CHECK(norm(w - (0.67 * red * blue / 1.2) * n) < 1e-16);
    }
    CHECK(norm(segregation_flux(0.0, 1.0, n, 0.67)) == 0.0);
    CHECK(norm(segregation_flux(-0.0, 1.0, n, 0.67)) == 0.0);
}

TEST_CASE("the flat profile at rest obeys its recurrence, and sum (1 - phi^2) = 2/beta", "[colour]") {
    const int length = 80;
    for (const double beta : {0.5, 0.67}) {
        PlainColours colours = slab(length, beta);
        for (int step = 0; step < 3000; ++step) {
            colours.point_normals_along_the_gradient();
            colours.collide(1.0);
            colours.stream();
        }
        // phi' - phi = -(beta/2)(2 - phi'^2 - phi^2) where the outside lies at larger x, in the right half.
        double sum = 0.0;
        double largest = 0.0;
        for (int x = length / 2; x < length; ++x) {
            const double phi = phase_of(colours.chi[colours.at(x, 0, 0)]);
            const double next = phase_of(colours.chi[colours.at(x + 1, 0, 0)]);
            if (x + 1 < length) {
                const double residual = std::abs(next - phi + 0.5 * beta * (2.0 - next * next - phi * phi));
                CHECK(residual < 1e-6);
                largest = std::max(largest, residual);
            }
            sum += layer_density(colours.chi[colours.at(x, 0, 0)]);
        }
        CHECK(sum == Approx(2.0 / beta).epsilon(1e-6));
        const std::string conditions = "beta = " + std::to_string(beta).substr(0, 4);
        test::measured("flat profile: residual of its recurrence", conditions, largest);
        test::measured("flat profile: beta/2 sum (1 - phi^2) - 1", conditions, 0.5 * beta * sum - 1.0);
        // Not the tanh of the continuum: that one fails the same law visibly.
        const double here = std::tanh(beta * 0.5);
        CHECK(std::abs(-2.0 * here + 0.5 * beta * (2.0 - 2.0 * here * here)) > 0.01);
    }
}

TEST_CASE("a slab in uniform flow returns to where it was, its profile no wider", "[colour]") {
    const int length = 40;
    const double u = 0.05;
    PlainColours colours = slab(length, 0.67);
    colours.for_each([&](int x, int y, int z) {
        populations_of(equilibrium_moments(1.0, 1.0, Vec3<double>{u, 0.0, 0.0}),
                       colours.populations(colours.at(x, y, z)));
    });
    const auto layer = [&] {
        double sum = 0.0;
        for (const double chi : colours.chi)
            sum += layer_density(chi);
        return sum;
    };
    const double red = colours.red_mass();
    const double start = centre_of_red(colours, length);
    for (int step = 0; step < static_cast<int>(length / u); ++step) {
        colours.point_normals_along_the_gradient();
        colours.collide(1.0);
        colours.stream();
    }
    CHECK(centre_of_red(colours, length) == Approx(start).margin(0.02));
    CHECK(layer() == Approx(2.0 * 2.0 / 0.67).epsilon(0.02));
    CHECK(colours.red_mass() == Approx(red).epsilon(1e-13));
}
