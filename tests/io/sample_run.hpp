#pragma once

#include "io/field_series.hpp"
#include "io/surface_series.hpp"

#include <filesystem>
#include <random>
#include <vector>

/// What a small run would leave, with values that tell where they belong.

inline double ramp_value(int x, int y, int z, int component) {
    return x + 10.0 * y + 100.0 * z + 1000.0 * component;
}

inline vesica::DenseField ramp_field(vesica::Vec3<int> size, int components) {
    vesica::DenseField field{size, components, {}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int c = 0; c < components; ++c)
                    field.values.push_back(ramp_value(x, y, z, c));
    return field;
}

/// Values that no compression makes smaller.
inline vesica::DenseField noise_field(vesica::Vec3<int> size) {
    std::mt19937 random(5);
    vesica::DenseField field{size, 1, {}};
    field.values.resize(static_cast<std::size_t>(size.x * size.y * size.z));
    for (double& value : field.values)
        value = 1.0 + static_cast<double>(random());
    return field;
}

inline vesica::FieldSeries::Options sample_options() {
    vesica::FieldSeries::Options options;
    options.sampling = {{2, 1, 0}, {8, 6, 4}, 1};
    options.scales = {0.5, 0.25, 1.0};
    return options;
}

/// What a single rank has of a field, each value times `factor`.
inline vesica::SampledField sampled(const std::string& name, const vesica::DenseField& field,
                                    const vesica::FieldSampling& sampling, double factor = 1.0,
                                    const std::string& unit = {}) {
    vesica::SampledField result{name, field.components, unit, {}};
    for (const double value : vesica::samples_of(field, {}, sampling))
        result.values.push_back(static_cast<float>(factor * value));
    return result;
}

inline vesica::FieldWriting alone(const vesica::FieldSampling& sampling, int compression = 1) {
    return {sampling.count(), {{}, sampling.count()}, compression, 1};
}

/// One step of a series by a single rank.
inline void write_step(vesica::FieldSeries& series, std::int64_t step, const vesica::FieldSampling& sampling,
                       const std::vector<vesica::SampledField>& fields) {
    series.write(step, [&](const std::filesystem::path& path, const vesica::FieldStep& geometry) {
        return vesica::write_field_step(path, geometry, alone(sampling), fields, vesica::Ranks());
    });
}

inline std::vector<vesica::SampledField> sample_fields() {
    const vesica::FieldSampling sampling = sample_options().sampling;
    return {sampled("phase", ramp_field({8, 6, 4}, 1), sampling),
            sampled("velocity", ramp_field({8, 6, 4}, 3), sampling)};
}

inline void write_sample_fields(const std::filesystem::path& directory,
                                const std::vector<std::int64_t>& steps) {
    vesica::FieldSeries series(directory, sample_options());
    for (const std::int64_t step : steps)
        write_step(series, step, sample_options().sampling, sample_fields());
}

/// Two tetrahedra, the second ten cells away along x; point data that repeat the points.
inline std::vector<vesica::SurfaceArrays> sample_surfaces() {
    std::vector<vesica::SurfaceArrays> surfaces;
    for (int vesicle = 0; vesicle < 2; ++vesicle) {
        const double shift = 10.0 * vesicle;
        vesica::SurfaceArrays surface;
        surface.vesicle = vesicle;
        surface.points = {{shift, 0, 0}, {shift + 1, 0, 0}, {shift, 1, 0}, {shift, 0, 1}};
        surface.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        vesica::SurfaceQuantity curvature{"mean_curvature", 1, {}}, velocity{"velocity", 3, {}};
        for (const auto& point : surface.points) {
            curvature.values.push_back(static_cast<float>(point.x + 2 * point.y + 3 * point.z));
            for (int axis = 0; axis < 3; ++axis)
                velocity.values.push_back(static_cast<float>(point[axis]));
        }
        surface.quantities = {curvature, velocity};
        surfaces.push_back(surface);
    }
    return surfaces;
}

inline void write_sample_surfaces(const std::filesystem::path& directory,
                                  const std::vector<std::int64_t>& steps) {
    vesica::SurfaceSeries series(directory, vesica::Scales{});
    for (const std::int64_t step : steps)
        series.write(step, sample_surfaces());
}
