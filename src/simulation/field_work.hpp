#pragma once

#include "case/case.hpp"
#include "io/field_step_file.hpp"
#include "io/placed_arrays.hpp"
#include "simulation/engine.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// The dimension of a field or of a quantity on a surface, by its name; none for those that are pure numbers.
Dimension dimension_of(const std::string& quantity);

/// The sums of an average that is under way, as a checkpoint keeps them.
struct FieldSums {
    int samples = 0;   ///< in time; 0: nothing to keep
    Vec3<int> count{}; ///< samples in space, of all ranks
    struct Array {
        std::string name;
        int components = 1;
    };
    std::vector<Array> arrays;
};

/// What one rank does for the fields that a case asks for: it samples its part of them, at instants or summed
/// up over time, and puts it into files. All ranks together, each with the engine of its block.
class FieldWork {
public:
    FieldWork(const Case& what, int threads, const Ranks& ranks);

    /// Adds the present fields to the average.
    void sample(const Engine& own);
    /// Writes the average, or where none is wanted the present fields, and begins anew. What the rank that
    /// leads says counts. Throws RunError, on all ranks.
    FieldStep write(const std::filesystem::path& path, const FieldStep& geometry, const Engine& own);

    FieldSums sums() const;
    /// Puts this rank's sums where a checkpoint has room for them.
    void keep(const PlacedArrays& places) const;
    /// Takes them up from a verified checkpoint.
    void restore(const std::filesystem::path& checkpoint, int samples, const Engine& own);

private:
    struct Sum {
        int components = 1;
        std::vector<double> values;
    };
    SampledField written(std::size_t index, double factor) const;

    FieldOutput output_;
    FieldSampling sampling_;
    std::optional<Scales> scales_;
    int threads_;
    Ranks ranks_;
    CellBox part_;          ///< of the samples, this rank's
    std::vector<Sum> sums_; ///< of the samples in time since the last output, by name
    int samples_ = 0;
};

/// The same as the run sees it, wherever the ranks are.
class FieldCrew {
public:
    FieldCrew() = default;
    FieldCrew(const FieldCrew&) = delete;
    FieldCrew& operator=(const FieldCrew&) = delete;
    virtual ~FieldCrew() = default;

    virtual void sample() = 0;
    virtual FieldStep write(const std::filesystem::path& path, const FieldStep& geometry) = 0;
    virtual FieldSums sums() const = 0;
    virtual void keep(const PlacedArrays& places) = 0;
    virtual void restore(const std::filesystem::path& checkpoint, int samples) = 0;
};

/// One process alone.
class LoneFieldCrew final : public FieldCrew {
public:
    LoneFieldCrew(const Case& what, int threads, const Engine& engine)
        : engine_(engine), work_(what, threads, Ranks()) {}

    void sample() override { work_.sample(engine_); }
    FieldStep write(const std::filesystem::path& path, const FieldStep& geometry) override {
        return work_.write(path, geometry, engine_);
    }
    FieldSums sums() const override { return work_.sums(); }
    void keep(const PlacedArrays& places) override { work_.keep(places); }
    void restore(const std::filesystem::path& checkpoint, int samples) override {
        work_.restore(checkpoint, samples, engine_);
    }

private:
    const Engine& engine_;
    FieldWork work_;
};

} // namespace vesica
