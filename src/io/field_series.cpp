#include "io/field_series.hpp"

#include "io/atomic_file.hpp"
#include "io/hdf5_array.hpp"
#include "io/step_name.hpp"
#include "io/xdmf_text.hpp"

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// As seen from the run's directory.
std::string step_file(std::int64_t step) {
    return "fields/" + step_name("step_", step, ".h5");
}

/// Links instead of copies: the index stays small and is rewritten whole.
void write_links(const Path& path, std::span<const FieldStep> steps) {
    const QuietHdf5 quiet;
    const Hdf5File file = create_hdf5_in_memory(path);
    for (const FieldStep& step : steps)
        hdf5_checked(H5Lcreate_external(step_file(step.step).c_str(), "/", file,
                                        step_name("step_", step.step, "").c_str(), H5P_DEFAULT, H5P_DEFAULT),
                     path, "cannot write");
    write_atomically(path, hdf5_bytes(file, path));
}

} // namespace

FieldSeries::FieldSeries(Path run_directory, Options options)
    : run_directory_(std::move(run_directory)), options_(options) {
    make_subdirectory(run_directory_ / "fields");
}

FieldSeries FieldSeries::resume(Path run_directory, Options options, std::int64_t last_step) {
    FieldSeries series(std::move(run_directory), options);
    for (const std::int64_t step : list_steps(series.run_directory_ / "fields", "step_", ".h5")) {
        const Path file = series.run_directory_ / step_file(step);
        if (step <= last_step)
            series.steps_.push_back(read_field_step(file));
        else
            std::filesystem::remove(file);
    }
    series.write_index();
    return series;
}

Path FieldSeries::write(std::int64_t step, const Write& write) {
    const double cell = options_.scales.cell;
    FieldStep geometry;
    geometry.step = step;
    geometry.time = static_cast<double>(step) * options_.scales.step;
    geometry.origin = cell * options_.sampling.origin();
    geometry.spacing = cell * options_.sampling.stride;
    const Path file = run_directory_ / step_file(step);
    FieldStep written = write(file, geometry);
    std::erase_if(steps_, [&](const FieldStep& known) { return known.step == step; });
    steps_.push_back(std::move(written));
    write_index();
    return file;
}

void FieldSeries::write_index() const {
    write_links(run_directory_ / "fields.h5", steps_);
    write_atomically(run_directory_ / "fields.xmf",
                     xdmf_text(steps_, [](const FieldStep& step) { return step_file(step.step); }));
}

} // namespace vesica
