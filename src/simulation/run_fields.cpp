#include "simulation/run_fields.hpp"

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

} // namespace

RunFields::RunFields(const Case& what, const std::filesystem::path& directory,
                     std::optional<std::int64_t> resumed, FieldCrew& crew)
    : series_(series_for(what, directory, resumed)), crew_(crew) {}

std::filesystem::path RunFields::write(std::int64_t step) {
    return series_.write(step, [&](const std::filesystem::path& path, const FieldStep& geometry) {
        return crew_.write(path, geometry);
    });
}

void RunFields::keep_in(CheckpointNotes& checkpoint) const {
    const FieldSums sums = crew_.sums();
    if (sums.samples == 0)
        return;
    checkpoint.notes[samples_note] = {static_cast<double>(sums.samples)};
    for (const FieldSums::Array& array : sums.arrays)
        checkpoint.sums.arrays.push_back({array.name, sums.count, array.components});
    checkpoint.sums.write = [this](const PlacedArrays& places) {
        crew_.keep(places);
    };
}

void RunFields::restore(const CheckpointNotes& notes, const std::filesystem::path& checkpoint) {
    const auto samples = notes.notes.find(samples_note);
    if (samples != notes.notes.end() && samples->second.size() == 1)
        crew_.restore(checkpoint, static_cast<int>(samples->second.front()));
}

} // namespace vesica
