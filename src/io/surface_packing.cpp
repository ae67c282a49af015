#include "io/surface_packing.hpp"

#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace vesica {
namespace {

using Json = nlohmann::ordered_json;

constexpr double position_steps = 65535.0;
/// Finer than the eye tells colours apart; bits beyond would mostly be noise, which does not compress.
constexpr double value_steps = 1023.0;

const std::array<ColourQuantity, 7> known = {{{"mean_curvature", "mean_curvature"},
                                              {"gaussian_curvature", "gaussian_curvature"},
                                              {"speed", "velocity"},
                                              {"total_force", "bending_force"},
                                              {"bending_force", "bending_force"},
                                              {"tension_force", "tension_force"},
                                              {"area_force", "area_force"}}};

const SurfaceQuantity* find_quantity(const SurfaceArrays& surface, std::string_view name) {
    for (const auto& quantity : surface.quantities)
        if (quantity.name == name)
            return &quantity;
    return nullptr;
}

/// A value per point; zeros for what the file does not have.
std::vector<double> values_of(const SurfaceArrays& surface, const std::string& name) {
    std::vector<double> values(surface.points.size(), 0.0);
    const auto add = [&](const char* part) {
        if (const SurfaceQuantity* quantity = find_quantity(surface, part); quantity != nullptr)
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += quantity->values[i];
    };
    if (name == "total_force" && find_quantity(surface, "total_force") == nullptr) {
        add("bending_force");
        add("tension_force");
    } else if (name == "speed") {
        if (const SurfaceQuantity* velocity = find_quantity(surface, "velocity"); velocity != nullptr)
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = std::hypot(velocity->values[3 * i], velocity->values[3 * i + 1],
                                       velocity->values[3 * i + 2]);
    } else {
        add(name.c_str());
    }
    return values;
}

ValueSpread extremes(const std::vector<double>& values) {
    ValueSpread found{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        found.low = std::min(found.low, value);
        found.high = std::max(found.high, value);
    }
    return found.low <= found.high ? found : ValueSpread{};
}

ValueSpread middle_of(std::vector<double> values) {
    values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
                 values.end());
    if (values.empty())
        return {};
    const auto at = [&](double share) {
        const auto place =
            values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    return {at(0.01), at(0.99)};
}

std::uint16_t steps_of(double value, double low, double step, double most) {
    if (!(step > 0.0) || !std::isfinite(value))
        return 0;
    return static_cast<std::uint16_t>(std::clamp(std::round((value - low) / step), 0.0, most));
}

/// The points of one surface as rows of uint16, as wide as meshoptimizer wants them (a multiple of 4 bytes).
class PointRows {
public:
    PointRows(const SurfaceArrays& surface, Json& header)
        : columns_((3 + known.size() + 1) / 2 * 2), rows_(surface.points.size() * columns_) {
        header["stride"] = 2 * columns_;
        add_positions(surface, header);
        for (std::size_t q = 0; q < known.size(); ++q) {
            const std::vector<double> values = values_of(surface, known[q].name);
            const ValueSpread range = extremes(values);
            header["low"].push_back(range.low);
            header["high"].push_back(range.high);
            for (std::size_t i = 0; i < values.size(); ++i)
                rows_[i * columns_ + 3 + q] =
                    steps_of(values[i], range.low, (range.high - range.low) / value_steps, value_steps);
        }
    }

    std::string encoded() const {
        const std::size_t stride = 2 * columns_;
        const std::size_t count = rows_.size() / columns_;
        std::string bytes(meshopt_encodeVertexBufferBound(count, stride), '\0');
        bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(),
                                                rows_.data(), count, stride));
        return bytes;
    }

private:
    void add_positions(const SurfaceArrays& surface, Json& header) {
        double extent = 0.0;
        Vec3<double> origin{};
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> along;
            for (const auto& point : surface.points)
                along.push_back(point[axis]);
            const ValueSpread range = extremes(along);
            origin[axis] = range.low;
            extent = std::max(extent, range.high - range.low);
        }
        const double unit = extent / position_steps;
        header["origin"] = {origin.x, origin.y, origin.z};
        header["unit"] = unit;
        for (std::size_t i = 0; i < surface.points.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                rows_[i * columns_ + static_cast<std::size_t>(axis)] =
                    steps_of(surface.points[i][axis], origin[axis], unit, position_steps);
    }

    std::size_t columns_;
    std::vector<std::uint16_t> rows_;
};

std::string encoded_triangles(const SurfaceArrays& surface) {
    std::vector<unsigned int> indices;
    for (const auto& triangle : surface.triangles)
        for (const std::int32_t corner : triangle)
            indices.push_back(static_cast<unsigned int>(corner));
    std::string bytes(meshopt_encodeIndexBufferBound(indices.size(), surface.points.size()), '\0');
    bytes.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(),
                                           indices.data(), indices.size()));
    return bytes;
}

std::vector<ValueSpread> spreads_of(const SurfaceStep& step) {
    std::vector<ValueSpread> spreads;
    for (const ColourQuantity& quantity : known) {
        std::vector<double> all;
        for (const SurfaceArrays& surface : step.surfaces) {
            const std::vector<double> values = values_of(surface, quantity.name);
            all.insert(all.end(), values.begin(), values.end());
        }
        spreads.push_back(middle_of(std::move(all)));
    }
    return spreads;
}

} // namespace

std::span<const ColourQuantity> colour_quantities() {
    return known;
}

PackedStep pack_surfaces(const SurfaceStep& step) {
    static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");
    PackedStep packed{step.step, step.time, 0, 0, spreads_of(step), {}};
    Json header{{"step", step.step},
                {"time", step.time},
                {"value_steps", value_steps},
                {"spreads", Json::array()},
                {"surfaces", Json::array()}};
    for (const ValueSpread& spread : packed.spreads)
        header["spreads"].push_back({spread.low, spread.high});
    std::string data;
    for (const SurfaceArrays& surface : step.surfaces) {
        Json one{{"vesicle", surface.vesicle},
                 {"points", surface.points.size()},
                 {"triangles", surface.triangles.size()}};
        const std::string points = PointRows(surface, one).encoded();
        const std::string triangles = encoded_triangles(surface);
        one["point_bytes"] = points.size();
        one["triangle_bytes"] = triangles.size();
        header["surfaces"].push_back(std::move(one));
        packed.triangles += surface.triangles.size();
        packed.largest_surface = std::max(packed.largest_surface, surface.triangles.size());
        data += points + triangles;
    }
    const std::string text = header.dump();
    const auto length = static_cast<std::uint32_t>(text.size());
    packed.bytes.assign(reinterpret_cast<const char*>(&length), sizeof(length));
    packed.bytes += text + data;
    return packed;
}

} // namespace vesica
