#include "io/stl_format.hpp"

#include "core/input_error.hpp"
#include "io/byte_order.hpp"
#include "io/text_scanner.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace vesica {
namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t record_size = 50;
constexpr std::size_t most_triangles = 10'000'000;

void add(TriangleMesh& mesh, const std::array<Vec3<double>, 3>& corners) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

TriangleMesh parse_binary(std::string_view contents, const std::string& source) {
    const SourcePlace place{source, 0, 0};
    if (contents.size() < header_size)
        throw InputError(
            place, fmt::format("the file has {} bytes and is neither PLY nor text STL; expected at least {} "
                               "for binary STL; export the mesh as STL or PLY",
                               contents.size(), header_size));
    const std::size_t count = from_bytes<std::uint32_t>(contents.data() + 80, std::endian::little);
    if (count > most_triangles)
        throw InputError(
            place, fmt::format("the file is neither PLY nor text STL, and as binary STL it would have {} "
                               "triangles; expected at most {}; export the mesh as STL or PLY",
                               count, most_triangles));
    if (contents.size() < header_size + record_size * count)
        throw InputError(
            place, fmt::format("the file has {} bytes; expected {} for the {} triangles that its header "
                               "announces; it may be cut short, or no STL file: export the mesh anew",
                               contents.size(), header_size + record_size * count, count));
    TriangleMesh mesh;
    mesh.source = source;
    for (std::size_t i = 0; i < count; ++i) {
        const char* record = contents.data() + header_size + record_size * i + 12; // after the normal
        const auto number = [&](int k) {
            return static_cast<double>(from_bytes<float>(record + 4 * k, std::endian::little));
        };
        add(mesh,
            {Vec3<double>{number(0), number(1), number(2)}, Vec3<double>{number(3), number(4), number(5)},
             Vec3<double>{number(6), number(7), number(8)}});
    }
    return mesh;
}

TriangleMesh parse_text(std::string_view contents, const std::string& source) {
    TextScanner scanner(contents);
    const auto refuse = [&](std::string_view found, std::string_view expected) {
        const std::string read =
            found.empty() ? "the file ends" : fmt::format("found \"{}\"", found.substr(0, 40));
        throw InputError(SourcePlace{source, scanner.line(), 1},
                         fmt::format("{}; expected {}; export the mesh anew as STL", read, expected));
    };
    const auto expect = [&](std::string_view keyword) {
        if (const std::string_view found = scanner.word(); found != keyword)
            refuse(found, fmt::format("\"{}\"", keyword));
    };
    const auto number = [&] {
        const std::optional<double> value = scanner.number();
        if (!value)
            refuse(scanner.last_word(), "a number");
        return *value;
    };
    TriangleMesh mesh;
    mesh.source = source;
    expect("solid");
    scanner.rest_of_line();
    for (;;) {
        const std::string_view keyword = scanner.word();
        if (keyword == "endsolid")
            break;
        if (keyword != "facet")
            refuse(keyword, "\"facet\" or \"endsolid\"");
        expect("normal");
        // A normal is ignored, and some programs write nan for that of a degenerate triangle.
        for (int k = 0; k < 3; ++k)
            scanner.word();
        expect("outer");
        expect("loop");
        std::array<Vec3<double>, 3> corners;
        for (Vec3<double>& corner : corners) {
            expect("vertex");
            corner.x = number();
            corner.y = number();
            corner.z = number();
        }
        expect("endloop");
        expect("endfacet");
        if (mesh.triangles.size() == most_triangles)
            refuse(keyword, fmt::format("at most {} triangles", most_triangles));
        add(mesh, corners);
    }
    return mesh;
}

} // namespace

TriangleMesh parse_stl(std::string_view contents, const std::string& source) {
    // Some binary files start with "solid" too.
    const bool text =
        contents.starts_with("solid") && contents.substr(0, 4096).find("facet") != std::string_view::npos;
    TriangleMesh mesh = text ? parse_text(contents, source) : parse_binary(contents, source);
    if (mesh.triangles.empty())
        throw InputError(SourcePlace{source, 0, 0}, "the file holds no triangles; expected a closed surface");
    return mesh;
}

} // namespace vesica
