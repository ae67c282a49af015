#include "core/input_error.hpp"
#include "shape/axisymmetric_shape.hpp"
#include "shape/directions.hpp"
#include "shape/helfrich.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace vesica;
using std::numbers::pi;

namespace {

const std::string data_folder = VESICA_SOURCE_DIR "/data/helfrich/";

struct Tabulated {
    HelfrichShape shape;
    double energy = 0.0;
    double largest_radius = 0.0;
    double pole_distance = 0.0;
    double height = 0.0;
};

HelfrichBranch branch_named(const std::string& name) {
    return name == "oblate"    ? HelfrichBranch::discocyte
           : name == "prolate" ? HelfrichBranch::prolate
                               : HelfrichBranch::stomatocyte;
}

std::vector<Tabulated> tabulated() {
    std::ifstream file(data_folder + "helfrich_c0_0.csv");
    std::string line;
    std::getline(file, line);
    std::vector<Tabulated> rows;
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        std::string name;
        Tabulated row;
        words >> name >> row.shape.reduced_volume >> row.energy >> row.largest_radius >> row.pole_distance >>
            row.height;
        row.shape.branch = branch_named(name);
        if (row.shape.reduced_volume >= helfrich_range(row.shape.branch).lowest)
            rows.push_back(row);
    }
    return rows;
}

double reduced_volume(const Meridian& m) {
    return 6.0 * std::sqrt(pi) * m.volume() / std::pow(m.area(), 1.5);
}

/// (1/2) int (2H)^2 dA over 8 pi.
double bending_energy(const Meridian& m) {
    double sum = 0.0;
    for (const MeridianSample& s : m.samples()) {
        const double twice_mean = s.point.meridional_curvature() + s.point.azimuthal_curvature();
        sum += 0.5 * twice_mean * twice_mean * 2.0 * pi * s.point.r * s.point.speed() * s.weight;
    }
    return sum / (8.0 * pi);
}

} // namespace

TEST_CASE("The tabulated Helfrich shapes have the tabulated energies and sizes") {
    const std::vector<Tabulated> rows = tabulated();
    REQUIRE(rows.size() == 32 + 33 + 14);
    for (const Tabulated& row : rows) {
        CAPTURE(row.shape.branch, row.shape.reduced_volume);
        const Meridian m = helfrich_meridian(row.shape);
        CHECK(m.area() == Approx(4.0 * pi).epsilon(1e-9));
        CHECK(reduced_volume(m) == Approx(row.shape.reduced_volume).epsilon(1e-10));
        CHECK(bending_energy(m) == Approx(row.energy).margin(1e-5));
        double r = 0.0, top = -10.0, bottom = 10.0;
        for (const MeridianSample& s : m.samples()) {
            r = std::max(r, s.point.r);
            top = std::max(top, s.point.z);
            bottom = std::min(bottom, s.point.z);
        }
        CHECK(r == Approx(row.largest_radius).margin(2e-4)); // the csv's maxima are over few points
        CHECK(r > row.largest_radius - 1e-5);
        CHECK(top - bottom == Approx(row.height).margin(5e-4));
        CHECK(std::abs(m.at(0.0).z - m.at(m.length()).z) == Approx(row.pole_distance).margin(1e-5));
    }
}

TEST_CASE("The embedded table is the json's") {
    std::ifstream file(data_folder + "helfrich_c0_0_fourier.json");
    const nlohmann::json series = nlohmann::json::parse(file);
    for (const auto& [name, entry] : series.items()) {
        const double v = std::stod(name.substr(name.find('_') + 1));
        const HelfrichBranch branch = branch_named(name.substr(0, name.find('_')));
        if (v < helfrich_range(branch).lowest)
            continue;
        // Arc length is kept to the centre of volume and the area's normalisation.
        CHECK(helfrich_meridian({branch, v}).length() == Approx(entry.at("L").get<double>()).epsilon(1e-9));
    }
}

TEST_CASE(
    "Between the table's entries a Helfrich shape closes, has its reduced volume and the energy between") {
    const std::vector<Tabulated> rows = tabulated();
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        if (rows[i].shape.branch != rows[i + 1].shape.branch)
            continue;
        HelfrichShape shape = rows[i].shape;
        shape.reduced_volume = 0.5 * (rows[i].shape.reduced_volume + rows[i + 1].shape.reduced_volume);
        CAPTURE(shape.branch, shape.reduced_volume);
        const Meridian m = helfrich_meridian(shape);
        CHECK(reduced_volume(m) == Approx(shape.reduced_volume).epsilon(1e-9));
        const auto [low, high] = std::minmax(rows[i].energy, rows[i + 1].energy);
        const double energy = bending_energy(m);
        CHECK(energy > low);
        CHECK(energy < high);
        // The tangent at the south pole is horizontal: the curve has arrived at the axis.
        const MeridianPoint end = m.at(m.length());
        CHECK(end.r == Approx(0.0).margin(1e-12));
        CHECK(end.dz == Approx(0.0).margin(1e-12));
    }
    // Where the shapes change fastest, against the cubic through the four tabulated energies around it.
    const double v[] = {0.75, 0.73, 0.70, 0.69}, energies[] = {1.50183, 1.55403, 1.64327, 1.67651};
    double expected = 0.0;
    for (int i = 0; i < 4; ++i) {
        double weight = energies[i];
        for (int j = 0; j < 4; ++j)
            if (j != i)
                weight *= (0.715 - v[j]) / (v[i] - v[j]);
        expected += weight;
    }
    CHECK(bending_energy(helfrich_meridian({HelfrichBranch::prolate, 0.715})) ==
          Approx(expected).margin(1e-4));
}

TEST_CASE("Helfrich profiles agree with the stored points") {
    for (const auto& [name, shape] :
         {std::pair{"oblate_v0.65", HelfrichShape{HelfrichBranch::discocyte, 0.65}},
          std::pair{"prolate_v0.8", HelfrichShape{HelfrichBranch::prolate, 0.8}},
          std::pair{"stomatocyte_v0.6", HelfrichShape{HelfrichBranch::stomatocyte, 0.6}}}) {
        const Meridian m = helfrich_meridian(shape);
        std::ifstream file(data_folder + "profile_" + name + ".csv");
        std::string line;
        std::getline(file, line);
        int points = 0;
        double shift = 0.0;
        while (std::getline(file, line)) {
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream words(line);
            double s = 0.0, r = 0.0, z = 0.0;
            words >> s >> r >> z;
            const MeridianPoint p = m.at(std::min(s, m.length()));
            if (points++ == 0)
                shift = p.z - z;
            CHECK(p.r == Approx(r).margin(2e-6));
            CHECK(p.z - shift == Approx(z).margin(2e-6));
        }
        CHECK(points == 81);
    }
}

TEST_CASE("A reduced volume of one is the sphere") {
    for (const HelfrichBranch branch : {HelfrichBranch::discocyte, HelfrichBranch::prolate}) {
        const AxisymmetricShape shape(helfrich_meridian({branch, 1.0}).normalised(15.0));
        for (const Vec3<double>& u : directions(20))
            CHECK(shape.signed_distance(17.0 * u) == Approx(2.0).margin(1e-10));
        const AxisymmetricShape nearly(helfrich_meridian({branch, 0.9999}).normalised(15.0));
        CHECK(nearly.area() == Approx(4.0 * pi * 225.0 * std::pow(0.9999, -2.0 / 3.0)).epsilon(1e-9));
    }
}

TEST_CASE("A Helfrich shape's distance has gradient one and vanishes on its curve") {
    for (const HelfrichShape& form :
         {HelfrichShape{HelfrichBranch::discocyte, 0.642}, HelfrichShape{HelfrichBranch::prolate, 0.68},
          HelfrichShape{HelfrichBranch::stomatocyte, 0.605}}) {
        const AxisymmetricShape shape(helfrich_meridian(form).normalised(15.0));
        const Meridian& m = shape.meridian();
        const double reach = 0.9 * shape.smallest_radius_of_curvature();
        for (int i = 0; i <= 60; ++i) {
            const MeridianPoint p = m.at(m.length() * (i + 0.37) / 61.0);
            const Vec3<double> x{p.r * 0.8, -p.r * 0.6, p.z};
            CHECK(shape.signed_distance(x) == Approx(0.0).margin(1e-12));
            const double v = p.speed();
            const Vec3<double> n{-p.dz / v * 0.8, p.dz / v * 0.6, p.dr / v};
            for (const double s : {-0.5, 0.5}) {
                CHECK(shape.signed_distance(x + s * reach * n) == Approx(s * reach).margin(1e-11));
                CHECK(norm(distance_gradient(shape, x + s * reach * n)) == Approx(1.0).margin(1e-7));
            }
        }
    }
}

TEST_CASE("The stomatocyte's cavity is outside and opens along the axis") {
    const AxisymmetricShape shape(helfrich_meridian({HelfrichBranch::stomatocyte, 0.6}).normalised(15.0));
    const double inner = shape.meridian().at(0.0).z; // the cavity's deepest point
    const double outer = shape.meridian().at(shape.meridian().length()).z;
    CHECK(inner > outer);
    CHECK(shape.signed_distance({0.0, 0.0, inner + 3.0}) > 2.0);
    CHECK(shape.signed_distance({0.0, 0.0, 0.5 * (inner + outer)}) ==
          Approx(-0.5 * (inner - outer)).epsilon(1e-9));
    for (double z = inner + 1e-3; z < 40.0; z += 0.5)
        CHECK(shape.signed_distance({0.0, 0.0, z}) > 0.0);
}

TEST_CASE("A Helfrich shape's volume and centre are those of the region where the distance is negative") {
    for (const HelfrichShape& form :
         {HelfrichShape{HelfrichBranch::discocyte, 0.65}, HelfrichShape{HelfrichBranch::stomatocyte, 0.62}}) {
        const AxisymmetricShape shape(helfrich_meridian(form).normalised(15.0));
        const VoxelMoments moments = voxel_moments(shape, 23.0, 0.5);
        CHECK(moments.volume == Approx(4.0 * pi / 3.0 * 3375.0).epsilon(5e-4));
        CHECK(norm(moments.centre) < 5e-3);
    }
}

TEST_CASE("A reduced volume outside the table is refused with the range") {
    CHECK_THROWS_WITH(
        helfrich_meridian({HelfrichBranch::discocyte, 0.5}),
        "reduced_volume is 0.5; expected 0.52 to 1 for the shape \"discocyte\"; try a value in that range "
        "or another shape");
    CHECK_THROWS_WITH(
        helfrich_meridian({HelfrichBranch::prolate, 1.01}),
        "reduced_volume is 1.01; expected 0.5 to 1 for the shape \"prolate\"; try a value in that range or "
        "another shape");
    CHECK_THROWS_AS(helfrich_meridian({HelfrichBranch::stomatocyte, 0.67}), InputError);
    CHECK_THROWS_AS(helfrich_meridian({HelfrichBranch::stomatocyte, std::nan("")}), InputError);
}
