#include "simulation/run_fields.hpp"

#include <array>
#include <cassert>
#include <utility>

namespace vesica {

namespace {

FieldSeries series_for(const Case& what, const std::filesystem::path& directory,
                       std::optional<std::int64_t> resumed) {
    const FieldOutput& output = *what.output.fields;
    FieldSeries::Options options;
    options.sampling = {output.region_begin, output.region_end, output.stride};
    options.scales = what.scales.value_or(Scales{});
    if (resumed)
        return FieldSeries::resume(directory, options, *resumed);
    return FieldSeries(directory, options);
}

constexpr const char* samples_note = "average_samples";

std::string sum_note(const std::string& name) {
    return "average_sum_" + name;
}

} // namespace

Dimension dimension_of(const std::string& quantity) {
    static const std::array<std::pair<const char*, Dimension>, 8> known = {{
        {"density", dimension::density},
        {"velocity", dimension::velocity},
        {"pressure", dimension::pressure},
        {"force", dimension::force_density},
        {"mean_curvature", dimension::curvature},
        {"gaussian_curvature", dimension::curvature * dimension::curvature},
        {"bending_force", dimension::pressure}, // per membrane area
        {"tension_force", dimension::pressure},
    }};
    for (const auto& [name, dimension] : known)
        if (quantity == name)
            return dimension;
    return dimension::none;
}

RunFields::RunFields(const Case& what, const std::filesystem::path& directory,
                     std::optional<std::int64_t> resumed)
    : output_(*what.output.fields),
      scales_(what.scales),
      series_(series_for(what, directory, resumed)),
      size_(what.parameters.size) {}

void RunFields::sample(const Engine& engine) {
    if (samples_ == 0)
        sums_.clear();
    for (std::size_t index = 0; index < output_.names.size(); ++index) {
        DenseField now = engine.field(output_.names[index]);
        if (samples_ == 0) {
            sums_.push_back(std::move(now));
            continue;
        }
        std::vector<double>& sum = sums_[index].values;
        assert(sum.size() == now.values.size());
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += now.values[k];
    }
    ++samples_;
}

RunFields::Notes RunFields::notes() const {
    Notes notes;
    if (!output_.average || samples_ == 0)
        return notes;
    notes[samples_note] = {static_cast<double>(samples_)};
    for (std::size_t index = 0; index < output_.names.size(); ++index)
        notes[sum_note(output_.names[index])] = sums_[index].values;
    return notes;
}

void RunFields::restore(const Notes& notes) {
    const auto samples = notes.find(samples_note);
    if (!output_.average || samples == notes.end())
        return;
    const auto cells = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                       static_cast<std::size_t>(size_.z);
    sums_.clear();
    for (const std::string& name : output_.names) {
        const auto sum = notes.find(sum_note(name));
        if (samples->second.size() != 1 || sum == notes.end() || sum->second.empty() ||
            sum->second.size() % cells != 0)
            throw RunError("the checkpoint's average of " + name + " is not of this case");
        DenseField field;
        field.size = size_;
        field.components = static_cast<int>(sum->second.size() / cells);
        field.values = sum->second;
        sums_.push_back(std::move(field));
    }
    samples_ = static_cast<int>(samples->second.front());
}

void RunFields::write(const Engine& engine) {
    // An instant is the average of one sample.
    if (!output_.average)
        samples_ = 0;
    if (samples_ == 0)
        sample(engine);
    std::vector<NamedField> fields;
    for (std::size_t index = 0; index < output_.names.size(); ++index) {
        const std::string& name = output_.names[index];
        NamedField field{name, &sums_[index], 1.0 / samples_, {}};
        if (scales_) {
            field.factor *= scales_->unit(dimension_of(name));
            field.unit = si_unit(dimension_of(name));
        }
        fields.push_back(std::move(field));
    }
    series_.write(engine.steps_done(), fields);
    samples_ = 0;
    sums_.clear();
}

} // namespace vesica
