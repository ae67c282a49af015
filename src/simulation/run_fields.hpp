#pragma once

#include "case/case.hpp"
#include "io/checkpoint.hpp"
#include "io/field_series.hpp"
#include "simulation/field_work.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace vesica {

/// The fields a case asks for, at instants or averaged in time, in SI units if the case has units: a series
/// of files that all ranks write.
class RunFields {
public:
    /// `resumed` as for RunRecorder. Throws RunError.
    RunFields(const Case& what, const std::filesystem::path& directory, std::optional<std::int64_t> resumed,
              FieldCrew& crew);

    /// Adds the present fields to the average.
    void sample() { crew_.sample(); }
    /// Returns the file.
    std::filesystem::path write(std::int64_t step);

    /// What a checkpoint must keep of an average that is not written yet; nothing between averages.
    void keep_in(CheckpointNotes& checkpoint) const;
    /// Throws RunError if what the checkpoint has kept is not of this case.
    void restore(const CheckpointNotes& notes, const std::filesystem::path& checkpoint);

private:
    FieldSeries series_;
    FieldCrew& crew_;
};

} // namespace vesica
