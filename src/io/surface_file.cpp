#include "io/surface_file.hpp"

#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cassert>

namespace vesica {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");

/// VTK's appended section: each block is its length in bytes as uint64, then the bytes; the arrays' tags give
/// offsets.
class AppendedData {
public:
    template <class Value>
    std::size_t add(const std::vector<Value>& values) {
        const std::size_t offset = bytes_.size();
        const std::uint64_t length = values.size() * sizeof(Value);
        bytes_.append(reinterpret_cast<const char*>(&length), sizeof(length));
        bytes_.append(reinterpret_cast<const char*>(values.data()), static_cast<std::size_t>(length));
        return offset;
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

template <class Value>
constexpr const char* vtk_name() {
    if constexpr (std::is_same_v<Value, float>)
        return "Float32";
    if constexpr (std::is_same_v<Value, double>)
        return "Float64";
    if constexpr (std::is_same_v<Value, std::int32_t>)
        return "Int32";
    if constexpr (std::is_same_v<Value, std::int64_t>)
        return "Int64";
}

template <class Value>
std::string array_tag(AppendedData& data, const std::string& name, int components,
                      const std::vector<Value>& values, const std::string& more = {}) {
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"appended\" "
                       "offset=\"{}\"/>\n",
                       vtk_name<Value>(), name, components, more, data.add(values));
}

std::vector<float> points_of(std::span<const SurfaceArrays> surfaces) {
    std::vector<float> values;
    for (const auto& surface : surfaces)
        for (const auto& point : surface.points)
            for (int axis = 0; axis < 3; ++axis)
                values.push_back(static_cast<float>(point[axis]));
    return values;
}

std::vector<float> quantity_of(std::span<const SurfaceArrays> surfaces, std::size_t index) {
    std::vector<float> values;
    for (const auto& surface : surfaces) {
        const SurfaceQuantity& quantity = surface.quantities.at(index);
        assert(quantity.name == surfaces.front().quantities[index].name);
        assert(quantity.values.size() ==
               surface.points.size() * static_cast<std::size_t>(quantity.components));
        values.insert(values.end(), quantity.values.begin(), quantity.values.end());
    }
    return values;
}

/// Which quantity are the normals, by which VTK shades a surface smoothly.
std::string normals_of(std::span<const SurfaceArrays> surfaces) {
    if (!surfaces.empty())
        for (const SurfaceQuantity& quantity : surfaces.front().quantities)
            if (quantity.name == "normal")
                return " Normals=\"normal\"";
    return {};
}

/// The triangles' corners, counted through all surfaces; the end of each triangle in them; each triangle's
/// vesicle.
struct Triangles {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
    std::vector<std::int32_t> vesicle;
};

Triangles triangles_of(std::span<const SurfaceArrays> surfaces) {
    Triangles all;
    std::int64_t first_point = 0;
    for (const auto& surface : surfaces) {
        for (const auto& triangle : surface.triangles) {
            for (const std::int32_t corner : triangle)
                all.connectivity.push_back(first_point + corner);
            all.offsets.push_back(static_cast<std::int64_t>(all.connectivity.size()));
            all.vesicle.push_back(surface.vesicle);
        }
        first_point += static_cast<std::int64_t>(surface.points.size());
    }
    return all;
}

} // namespace

void write_surface_file(const std::filesystem::path& path, std::span<const SurfaceArrays> surfaces,
                        std::int64_t step, double time) {
    const std::vector<float> points = points_of(surfaces);
    const Triangles triangles = triangles_of(surfaces);
    AppendedData data;
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
    text += array_tag(data, "TimeValue", 1, std::vector<double>{time}, " NumberOfTuples=\"1\"");
    text += array_tag(data, "step", 1, std::vector<std::int64_t>{step}, " NumberOfTuples=\"1\"");
    text += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
                        "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<PointData{}>\n",
                        points.size() / 3, triangles.offsets.size(), normals_of(surfaces));
    if (!surfaces.empty()) {
        for (std::size_t i = 0; i < surfaces.front().quantities.size(); ++i) {
            const SurfaceQuantity& quantity = surfaces.front().quantities[i];
            text += array_tag(data, quantity.name, quantity.components, quantity_of(surfaces, i));
        }
    }
    text += "</PointData>\n<CellData>\n" + array_tag(data, "vesicle", 1, triangles.vesicle);
    text += "</CellData>\n<Points>\n" + array_tag(data, "Points", 3, points);
    text += "</Points>\n<Polys>\n" + array_tag(data, "connectivity", 1, triangles.connectivity);
    text += array_tag(data, "offsets", 1, triangles.offsets);
    text += "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";

    AtomicFile file(path);
    file.write(text);
    file.write(data.bytes());
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
}

} // namespace vesica
