#include "io/mesh_file.hpp"

#include "core/input_error.hpp"
#include "io/ply_format.hpp"
#include "io/stl_format.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <system_error>

namespace vesica {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30;

std::string contents(const std::filesystem::path& file) {
    const SourcePlace place{file.string(), 0, 0};
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        throw InputError(
            place, "the mesh file does not exist; expected an STL or PLY file; try a path relative to the "
                   "case file's folder or an absolute one");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(place, "this is not a file; expected an STL or PLY file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        throw InputError(place, fmt::format("cannot be read: {}", error.message()));
    if (size > largest_file)
        throw InputError(place,
                         fmt::format("the file has {} bytes; expected at most {}; try a coarser mesh, with "
                                     "triangles the size of a cell",
                                     size, largest_file));
    std::string text(static_cast<std::size_t>(size), '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
        throw InputError(place, "cannot be read; check its permissions");
    return text;
}

void check_finite(const TriangleMesh& mesh) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3<double>& v = mesh.vertices[i];
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            throw InputError(
                SourcePlace{mesh.source, 0, 0},
                fmt::format("vertex {} is ({}, {}, {}); expected finite numbers; export the mesh anew", i,
                            v.x, v.y, v.z));
    }
}

/// One vertex per place, in the order in which the triangles first use them.
TriangleMesh merged(const TriangleMesh& mesh) {
    TriangleMesh result;
    result.source = mesh.source;
    result.triangles.reserve(mesh.triangles.size());
    std::map<std::array<double, 3>, int> known;
    for (const auto& triangle : mesh.triangles) {
        std::array<int, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3<double>& v = mesh.vertices[static_cast<std::size_t>(triangle[k])];
            const auto [place, added] =
                known.try_emplace({v.x, v.y, v.z}, static_cast<int>(result.vertices.size()));
            if (added)
                result.vertices.push_back(v);
            corners[k] = place->second;
        }
        result.triangles.push_back(corners);
    }
    return result;
}

} // namespace

TriangleMesh read_triangle_mesh(const std::filesystem::path& file) {
    const std::string text = contents(file);
    const std::string name = file.string();
    TriangleMesh mesh = is_ply(text) ? parse_ply(text, name) : parse_stl(text, name);
    check_finite(mesh);
    return merged(mesh);
}

} // namespace vesica
