#pragma once

#include "case/solid_voxels.hpp"
#include "core/input_error.hpp"
#include "io/voxel_file.hpp"
#include "scratch_directory.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

/// A box of cells, some of them solid, and files that shall hold it.
namespace voxel_samples {

using namespace vesica;

inline constexpr Vec3<int> size{5, 4, 3};

/// No symmetry of the box maps it onto itself.
inline bool is_solid(int x, int y, int z) {
    return (x + 2 * y * y + 3 * z * x) % 7 < 2;
}

inline SolidVoxels expected() {
    SolidVoxels solid(size);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (is_solid(x, y, z))
                    solid.set({x, y, z});
    return solid;
}

/// `value` in solid cells, zero elsewhere, x fastest.
template <class Value>
std::vector<Value> values_of(Value value) {
    std::vector<Value> values;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                values.push_back(is_solid(x, y, z) ? value : Value{0});
    return values;
}

template <class Value>
std::string bytes_of(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

inline SolidVoxels read(const std::string& name, const std::string& content,
                        const std::string& dataset = {}) {
    const ScratchDirectory scratch;
    put_content(scratch / name, content);
    return read_voxels(scratch / name, size, dataset);
}

/// What `read` complains of, without the file's name.
inline std::string refusal(const std::string& name, const std::string& content,
                           const std::string& dataset = {}) {
    const ScratchDirectory scratch;
    put_content(scratch / name, content);
    const auto text = complaint_of<InputError>([&] { read_voxels(scratch / name, size, dataset); });
    const std::string start = (scratch / name).string() + ":";
    REQUIRE(text.starts_with(start));
    return text.substr(start.size());
}

} // namespace voxel_samples
