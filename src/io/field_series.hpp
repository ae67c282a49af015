#pragma once

#include "core/scales.hpp"
#include "io/field_step_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace vesica {

/// DIR/fields.xmf, DIR/fields.h5 and DIR/fields/step_<n>.h5: fields over time, for ParaView and scripts.
///
/// Each step has its own HDF5 file, so that no crash can hurt an earlier one; fields.h5 holds only links to
/// them (fields.h5:/step_000001200/phase), fields.xmf describes the series. All are replaced in one instant.
class FieldSeries {
public:
    struct Options {
        FieldSampling sampling;
        Scales scales; ///< {1, 1, 1}: lattice units
    };
    /// write_field_step with a part of the fields for each rank.
    using Write = std::function<FieldStep(const std::filesystem::path&, const FieldStep&)>;

    /// Starts a series in the run's directory. Throws RunError.
    FieldSeries(std::filesystem::path run_directory, Options options);

    /// Takes over the steps up to `last_step` and removes later ones.
    static FieldSeries resume(std::filesystem::path run_directory, Options options, std::int64_t last_step);

    /// Adds one step, by handing its file's name, time and geometry to `write`; returns the file. Throws
    /// RunError; the series is then what it was.
    std::filesystem::path write(std::int64_t step, const Write& write);

private:
    void write_index() const;

    std::filesystem::path run_directory_;
    Options options_;
    std::vector<FieldStep> steps_;
};

} // namespace vesica
