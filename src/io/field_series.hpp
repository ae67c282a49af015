#pragma once

#include "core/scales.hpp"
#include "io/field_step_file.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
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
        Scales scales;       ///< {1, 1, 1}: lattice units
        int compression = 1; ///< deflate level after a byte shuffle; 0: none
    };

    /// Starts a series in the run's directory. Throws RunError.
    FieldSeries(std::filesystem::path run_directory, Options options);

    /// Takes over the steps up to `last_step` and removes later ones.
    static FieldSeries resume(std::filesystem::path run_directory, Options options, std::int64_t last_step);

    /// Adds one step. Throws RunError; the series is then what it was.
    void write(std::int64_t step, std::span<const NamedField> fields);

private:
    void write_index() const;

    std::filesystem::path run_directory_;
    Options options_;
    std::vector<FieldStep> steps_;
};

} // namespace vesica
