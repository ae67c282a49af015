#include "simulation/field_work.hpp"

#include "core/input_error.hpp"
#include "io/checkpoint_sums.hpp"
#include "parallel/agreement.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace vesica {

Dimension dimension_of(const std::string& quantity) {
    static const std::array<std::pair<const char*, Dimension>, 10> known = {{
        {"density", dimension::density},
        {"velocity", dimension::velocity},
        {"pressure", dimension::pressure},
        {"force", dimension::force_density},
        {"mean_curvature", dimension::curvature},
        {"gaussian_curvature", dimension::curvature * dimension::curvature},
        {"bending_force", dimension::pressure}, // per membrane area
        {"tension_force", dimension::pressure},
        {"area_force", dimension::pressure},
        {"total_force", dimension::pressure},
    }};
    for (const auto& [name, dimension] : known)
        if (quantity == name)
            return dimension;
    return dimension::none;
}

FieldWork::FieldWork(const Case& what, int threads, const Ranks& ranks)
    : output_(what.output.fields.value_or(FieldOutput{})),
      sampling_{output_.region_begin, output_.region_end, output_.stride},
      scales_(what.scales),
      threads_(threads),
      ranks_(ranks) {}

void FieldWork::sample(const Engine& own) {
    sums_.resize(output_.names.size());
    for (std::size_t index = 0; index < sums_.size(); ++index) {
        const FieldPart now = own.own_field(output_.names[index]);
        part_ = sampling_.samples_in({now.begin, now.cells.size});
        std::vector<double> values = samples_of(now.cells, now.begin, sampling_);
        Sum& sum = sums_[index];
        if (samples_ == 0) {
            sum = {now.cells.components, std::move(values)};
            continue;
        }
        assert(sum.values.size() == values.size());
        for (std::size_t k = 0; k < values.size(); ++k)
            sum.values[k] += values[k];
    }
    ++samples_;
}

SampledField FieldWork::written(std::size_t index, double factor) const {
    const std::string& name = output_.names[index];
    const Sum& sum = sums_[index];
    SampledField field{name, sum.components, {}, std::vector<float>(sum.values.size())};
    if (scales_) {
        factor *= scales_->unit(dimension_of(name));
        field.unit = si_unit(dimension_of(name));
    }
    std::transform(sum.values.begin(), sum.values.end(), field.values.begin(),
                   [&](double value) { return static_cast<float>(factor * value); });
    return field;
}

FieldStep FieldWork::write(const std::filesystem::path& path, const FieldStep& geometry, const Engine& own) {
    // An instant is the average of one sample.
    if (!output_.average)
        samples_ = 0;
    if (samples_ == 0)
        sample(own);
    std::vector<SampledField> fields;
    for (std::size_t index = 0; index < sums_.size(); ++index) {
        fields.push_back(written(index, 1.0 / samples_));
        sums_[index] = {};
    }
    samples_ = 0;
    return write_field_step(path, geometry, {sampling_.count(), part_, output_.compression, threads_}, fields,
                            ranks_);
}

FieldSums FieldWork::sums() const {
    FieldSums kept;
    if (!output_.average || samples_ == 0)
        return kept;
    kept.samples = samples_;
    kept.count = sampling_.count();
    for (std::size_t index = 0; index < sums_.size(); ++index)
        kept.arrays.push_back({output_.names[index], sums_[index].components});
    return kept;
}

void FieldWork::keep(const PlacedArrays& told) const {
    const PlacedArrays places = broadcast(ranks_, told);
    fill_placed(places, ranks_, [&](const FileDescriptor& file, std::size_t array) {
        const Sum& sum = sums_[array];
        write_part(file, places.offsets[array], sampling_.count(), part_,
                   static_cast<std::size_t>(sum.components) * sizeof(double),
                   std::as_bytes(std::span(sum.values)), places.target);
    });
}

void FieldWork::restore(const std::filesystem::path& checkpoint, int samples, const Engine& own) {
    const std::filesystem::path path = ranks_.broadcast(checkpoint.string());
    ranks_.broadcast(std::as_writable_bytes(std::span(&samples, 1)));
    agree(ranks_, [&] {
        sums_.clear();
        for (const std::string& name : output_.names) {
            const FieldPart now = own.own_field(name);
            part_ = sampling_.samples_in({now.begin, now.cells.size});
            sums_.push_back({now.cells.components,
                             read_sums(path, name, sampling_.count(), part_, now.cells.components)});
        }
        samples_ = samples;
    });
}

} // namespace vesica
