#pragma once

#include "case/case.hpp"
#include "io/field_series.hpp"
#include "simulation/engine.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// The dimension of a field or of a quantity on a surface, by its name; none for those that are pure numbers.
Dimension dimension_of(const std::string& quantity);

/// The fields a case asks for, at instants or averaged in time, in SI units if the case has units.
class RunFields {
public:
    /// `resumed` as for RunRecorder. Throws RunError.
    RunFields(const Case& what, const std::filesystem::path& directory, std::optional<std::int64_t> resumed);

    /// Adds the present fields to the average.
    void sample(const Engine& engine);
    void write(const Engine& engine);

    /// What a checkpoint must keep of an average that is not written yet; nothing between averages.
    using Notes = std::map<std::string, std::vector<double>>;
    Notes notes() const;
    /// Throws RunError if the notes are not of this case.
    void restore(const Notes& notes);

private:
    FieldOutput output_;
    std::optional<Scales> scales_;
    FieldSeries series_;
    Vec3<int> size_;
    std::vector<DenseField> sums_; ///< of the samples since the last output; empty before the first
    int samples_ = 0;
};

} // namespace vesica
