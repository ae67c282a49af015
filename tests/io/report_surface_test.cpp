#include "core/input_error.hpp"
#include "io/base64.hpp"
#include "io/byte_order.hpp"
#include "io/surface_decimation.hpp"
#include "io/surface_packing.hpp"
#include "io/surface_reader.hpp"
#include "scratch_directory.hpp"
#include "sphere_mesh.hpp"

#include <catch2/catch.hpp>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <random>

using namespace vesica;

namespace {

/// What the page makes of the bytes: the header, and the numbers of one surface.
struct Unpacked {
    nlohmann::json header;
    std::vector<std::vector<std::uint16_t>> rows;
    std::vector<std::vector<std::uint32_t>> corners;
};

Unpacked unpack(const std::string& bytes) {
    const auto length = from_bytes<std::uint32_t>(bytes.data(), std::endian::little);
    Unpacked result;
    result.header = nlohmann::json::parse(bytes.substr(4, length));
    const auto* at = reinterpret_cast<const unsigned char*>(bytes.data()) + 4 + length;
    for (const auto& one : result.header["surfaces"]) {
        const std::size_t points = one["points"], stride = one["stride"], triangles = one["triangles"];
        std::vector<std::uint16_t> rows(points * stride / 2);
        REQUIRE(meshopt_decodeVertexBuffer(rows.data(), points, stride, at, one["point_bytes"]) == 0);
        at += one["point_bytes"].get<std::size_t>();
        std::vector<std::uint32_t> corners(3 * triangles);
        REQUIRE(meshopt_decodeIndexBuffer(corners.data(), corners.size(), 4, at, one["triangle_bytes"]) == 0);
        at += one["triangle_bytes"].get<std::size_t>();
        result.rows.push_back(std::move(rows));
        result.corners.push_back(std::move(corners));
    }
    REQUIRE(at == reinterpret_cast<const unsigned char*>(bytes.data()) + bytes.size());
    return result;
}

} // namespace

TEST_CASE("decoding what was encoded in base64 gives the same bytes, of any length") {
    std::mt19937 random(7);
    for (std::size_t length = 0; length < 70; ++length) {
        std::string bytes;
        for (std::size_t i = 0; i < length; ++i)
            bytes += static_cast<char>(random());
        REQUIRE(encode_base64(bytes).size() == (length + 2) / 3 * 4);
        REQUIRE(decode_base64(encode_base64(bytes), length) == bytes);
    }
    REQUIRE(encode_base64("Many hands") == "TWFueSBoYW5kcw==");
}

TEST_CASE("reading a surface file gives the surfaces that were written") {
    const ScratchDirectory scratch;
    std::vector<SurfaceArrays> surfaces = {spheroid_mesh(8, 0.5, 2), spheroid_mesh(5, 2, 1)};
    surfaces[1].vesicle = 3;
    write_surface_file(scratch / "a.vtp", surfaces, 1200, 0.25);
    const SurfaceStep read = read_surface_file(scratch / "a.vtp");
    REQUIRE(read.step == 1200);
    REQUIRE(read.time == 0.25);
    REQUIRE(read.surfaces.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        REQUIRE(read.surfaces[i].vesicle == surfaces[i].vesicle);
        REQUIRE(read.surfaces[i].points.size() == surfaces[i].points.size());
        REQUIRE(read.surfaces[i].triangles.size() == surfaces[i].triangles.size());
        REQUIRE(area_of(read.surfaces[i]) == Approx(area_of(surfaces[i])).epsilon(1e-6));
        REQUIRE(is_closed(read.surfaces[i]));
        REQUIRE(read.surfaces[i].quantities[4].name == "velocity");
        for (std::size_t t = 0; t < surfaces[i].triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) { // points may be numbered anew, corners keep what they have
                const auto was = static_cast<std::size_t>(surfaces[i].triangles[t][k]);
                const auto is = static_cast<std::size_t>(read.surfaces[i].triangles[t][k]);
                REQUIRE(read.surfaces[i].points[is].z == Approx(surfaces[i].points[was].z).epsilon(1e-6));
                REQUIRE(read.surfaces[i].quantities[4].values[3 * is + 1] ==
                        Approx(surfaces[i].quantities[4].values[3 * was + 1]).margin(1e-6));
            }
    }
}

TEST_CASE("a damaged surface file is refused wherever it is cut") {
    const ScratchDirectory scratch;
    write_surface_file(scratch / "whole.vtp", std::vector{spheroid_mesh(8, 1, 0)}, 5, 5.0);
    const std::string whole = content_of(scratch / "whole.vtp");
    for (std::size_t length = 0; length + 40 < whole.size(); length += 37) {
        put_content(scratch / "cut.vtp", whole.substr(0, length));
        REQUIRE_THROWS_AS(read_surface_file(scratch / "cut.vtp"), InputError);
    }
    put_content(scratch / "other.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\"/>\n");
    REQUIRE_THROWS_WITH(read_surface_file(scratch / "other.vtp"), Catch::Contains("no VTK PolyData"));
    REQUIRE_THROWS_AS(read_surface_file(scratch / "none.vtp"), RunError);
}

TEST_CASE("a decimated surface stays closed, keeps its area within 1 %, and points keep their values") {
    for (const double stretch : {0.3, 1.0, 2.5}) {
        const SurfaceArrays fine = spheroid_mesh(15, stretch, 5); // 20480 triangles
        const SurfaceArrays coarse = decimate(fine, 2000);
        REQUIRE(coarse.triangles.size() <= 2000);
        REQUIRE(coarse.triangles.size() > 1500);
        REQUIRE(is_closed(coarse));
        REQUIRE(area_of(coarse) == Approx(area_of(fine)).epsilon(0.01));
        REQUIRE(coarse.points.size() == coarse.triangles.size() / 2 + 2); // Euler: still a sphere
        for (std::size_t i = 0; i < coarse.points.size(); ++i) {
            const double z = (coarse.points[i].z - 40) / (15 * stretch);
            REQUIRE(coarse.quantities[1].values[i] == Approx(1 + z).margin(1e-9));
            REQUIRE(coarse.quantities[4].values[3 * i + 2] == Approx(z).margin(1e-9));
        }
    }
}

TEST_CASE("a surface with few triangles is only put in another order") {
    const SurfaceArrays surface = spheroid_mesh(9, 1, 2);
    const SurfaceArrays same = decimate(surface, 1000);
    REQUIRE(same.triangles.size() == surface.triangles.size());
    REQUIRE(area_of(same) == Approx(area_of(surface)).epsilon(1e-12));
    REQUIRE(is_closed(same));
    REQUIRE(decimate(SurfaceArrays{}, 10).triangles.empty());
}

TEST_CASE("packed surfaces are right to half a step of their numbers") {
    SurfaceArrays surface = spheroid_mesh(12, 0.6, 3);
    surface.vesicle = 4;
    const PackedStep packed = pack_surfaces({700, 0.7, {surface}});
    const Unpacked page = unpack(packed.bytes);
    REQUIRE(packed.triangles == surface.triangles.size());
    REQUIRE(page.header["step"] == 700);
    const auto& one = page.header["surfaces"][0];
    REQUIRE(one["vesicle"] == 4);
    const std::size_t columns = one["stride"].get<std::size_t>() / 2;
    const double unit = one["unit"];
    REQUIRE(unit < 24.0 / 60000);
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const std::uint16_t* row = page.rows[0].data() + i * columns;
        for (std::size_t axis = 0; axis < 3; ++axis)
            REQUIRE(one["origin"][axis].get<double>() + unit * row[axis] ==
                    Approx(surface.points[i][static_cast<int>(axis)]).margin(0.5001 * unit));
        const double expected[] = {surface.quantities[0].values[i],
                                   surface.quantities[1].values[i],
                                   1.0,
                                   surface.quantities[2].values[i] + surface.quantities[3].values[i],
                                   surface.quantities[2].values[i],
                                   surface.quantities[3].values[i],
                                   0.0};
        for (std::size_t q = 0; q < 7; ++q) {
            const double low = one["low"][q], step = (one["high"][q].get<double>() - low) /
                                                     page.header["value_steps"].get<double>();
            REQUIRE(low + step * row[3 + q] == Approx(expected[q]).margin(0.5001 * step + 1e-12));
        }
    }
    REQUIRE(page.corners[0].size() == 3 * surface.triangles.size());
    // The encoder may turn a triangle's corners round, which leaves its side what it was.
    SurfaceArrays decoded = surface;
    for (std::size_t t = 0; t < decoded.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            decoded.triangles[t][k] = static_cast<std::int32_t>(page.corners[0][3 * t + k]);
    REQUIRE(is_closed(decoded));
}

TEST_CASE("the spread of a step leaves out the utmost hundredths, and what is no number") {
    SurfaceArrays surface = spheroid_mesh(10, 1, 4);
    surface.quantities[0].values[0] = 1e9;
    surface.quantities[0].values[1] = std::numeric_limits<double>::quiet_NaN();
    const PackedStep packed = pack_surfaces({0, 0.0, {surface}});
    REQUIRE(packed.spreads.size() == colour_quantities().size());
    REQUIRE(packed.spreads[0].high < 1.0);
    REQUIRE(packed.spreads[0].low > -1.0);
    REQUIRE(packed.spreads[0].high > 0.9);
    REQUIRE(unpack(packed.bytes).header["surfaces"][0]["high"][0] == 1e9);
}

TEST_CASE("a triangle with its points and colours costs ten bytes of base64") {
    SurfaceArrays surface = decimate(spheroid_mesh(15, 0.5, 5), 20480);
    std::mt19937 random(3); // a real surface is not as smooth as this
    std::uniform_real_distribution<double> noise(-0.001, 0.001);
    for (auto& point : surface.points)
        point = point + Vec3<double>{noise(random), noise(random), noise(random)};
    for (auto& quantity : surface.quantities)
        for (float& value : quantity.values)
            value += static_cast<float>(noise(random));
    REQUIRE(encode_base64(pack_surfaces({0, 0.0, {surface}}).bytes).size() < 10 * surface.triangles.size());
}

TEST_CASE("no surface at all is a frame without surfaces") {
    const Unpacked page = unpack(pack_surfaces({3, 3.0, {SurfaceArrays{}}}).bytes);
    REQUIRE(page.header["surfaces"][0]["points"] == 0);
    REQUIRE(unpack(pack_surfaces({3, 3.0, {}}).bytes).header["surfaces"].empty());
}
