#include "measure/area.hpp"
#include "measure/layer_moment.hpp"
#include "measure/solid_body.hpp"
#include "measure/surface.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace vesica;
using std::numbers::pi;

namespace {

constexpr std::array<Vec3<int>, 19> velocities = {{
    {0, 0, 0},  {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},  {0, -1, 0}, {0, 0, 1},   {0, 0, -1},
    {1, 1, 0},  {-1, -1, 0}, {1, -1, 0},  {-1, 1, 0}, {1, 0, 1},  {-1, 0, -1}, {1, 0, -1},
    {-1, 0, 1}, {0, 1, 1},   {0, -1, -1}, {0, 1, -1}, {0, -1, 1},
}};

double weight_of(std::size_t i) {
    return i == 0 ? 1.0 / 3.0 : i < 7 ? 1.0 / 18.0 : 1.0 / 36.0;
}

/// The colour of a fluid at rest on a periodic cube: phi(t + 1, x) = sum_i t_i [phi - beta (1 - phi^2)/2
/// n.c_i](x - c_i).
class RestingColour {
public:
    RestingColour(int edge, double beta, double radius, const Vec3<double>& centre) : beta_(beta) {
        block_ = {
            {0, 0, 0}, {edge, edge, edge}, std::vector<double>(static_cast<std::size_t>(edge * edge * edge))};
        each_cell([&](int i, int j, int k) {
            const double distance = norm(Vec3<double>{i + 0.5, j + 0.5, k + 0.5} - centre);
            block_.values[block_.index(i, j, k)] = -std::tanh(beta * (distance - radius));
        });
    }

    void step() {
        std::vector<double> next(block_.values.size(), 0.0);
        each_cell([&](int i, int j, int k) {
            const double phi = block_.values[block_.index(i, j, k)];
            Vec3<double> gradient;
            for (std::size_t q = 1; q < 19; ++q) {
                const Vec3<int>& c = velocities[q];
                const double there = weight_of(q) * block_.values[wrapped(i + c.x, j + c.y, k + c.z)];
                gradient = gradient + Vec3<double>{there * c.x, there * c.y, there * c.z};
            }
            const double size = norm(gradient);
            const Vec3<double> flux =
                (size > 1e-14 ? -0.5 * beta_ * (1.0 - phi * phi) / size : 0.0) * gradient;
            for (std::size_t q = 0; q < 19; ++q) {
                const Vec3<int>& c = velocities[q];
                next[wrapped(i + c.x, j + c.y, k + c.z)] +=
                    weight_of(q) * (phi - flux.x * c.x - flux.y * c.y - flux.z * c.z);
            }
        });
        block_.values = std::move(next);
    }

    const DenseBlock& phase() const { return block_; }

    /// Cells only, without geometry.
    VesicleSnapshot snapshot() const {
        VesicleSnapshot vesicle;
        vesicle.beta = beta_;
        each_cell([&](int i, int j, int k) {
            InterfaceCell cell;
            cell.position = {i + 0.5, j + 0.5, k + 0.5};
            cell.phi = block_.values[block_.index(i, j, k)];
            cell.weight = 0.5 * beta_ * (1.0 - cell.phi * cell.phi);
            vesicle.cells.push_back(cell);
        });
        return vesicle;
    }

private:
    std::size_t wrapped(int i, int j, int k) const {
        const int edge = block_.size.x;
        return block_.index((i + edge) % edge, (j + edge) % edge, (k + edge) % edge);
    }

    template <class Visit>
    void each_cell(Visit visit) const {
        for (int k = 0; k < block_.size.z; ++k)
            for (int j = 0; j < block_.size.y; ++j)
                for (int i = 0; i < block_.size.x; ++i)
                    visit(i, j, k);
    }

    double beta_;
    DenseBlock block_;
};

} // namespace

TEST_CASE("a relaxed drop's raw sums are the sharp sphere's and what the layer's moments say", "[measure]") {
    const double beta = GENERATE(0.6, 0.67);
    const double initial = 8.0;
    const Vec3<double> centre{15.3, 14.9, 15.1};
    RestingColour colour(30, beta, initial, centre);
    for (int i = 0; i < 150; ++i)
        colour.step();

    // The distance from the centre, not the position, is interpolated to s = 0: facets cut corners.
    const SurfaceMesh mesh = extract_surface(distance_block(colour.phase(), beta));
    std::vector<double> distance;
    for (int k = 0; k < 30; ++k)
        for (int j = 0; j < 30; ++j)
            for (int i = 0; i < 30; ++i)
                distance.push_back(norm(Vec3<double>{i + 0.5, j + 0.5, k + 0.5} - centre));
    double radius = 0.0;
    for (double r : interpolate(mesh, distance))
        radius += r / static_cast<double>(mesh.points.size());

    const LayerMoments layer = lattice_layer_moments(beta);
    const double excess_area = raw_area(colour.snapshot()) / (4.0 * pi) - radius * radius;
    CHECK(excess_area == Approx(layer.area + layer.bending).margin(0.03)); // of a radius squared of 64
    const double excess_volume = volume(colour.snapshot()) / (4.0 * pi) - radius * radius * radius / 3.0;
    CHECK(excess_volume / radius == Approx(layer.volume + layer.shift).margin(0.01));
    // Neither a tanh's moments nor the flat profile's alone would do.
    CHECK(excess_area - layer.area > 0.4);
    CHECK(excess_area - tanh_layer_moments(beta).area > 0.2);
}
