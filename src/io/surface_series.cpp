#include "io/surface_series.hpp"

#include "io/atomic_file.hpp"
#include "io/number_text.hpp"
#include "io/step_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesica {
namespace {

std::string surface_name(std::int64_t step) {
    return step_name("surface_", step, ".vtp");
}

} // namespace

SurfaceSeries::SurfaceSeries(const std::filesystem::path& run_directory, Scales scales)
    : directory_(run_directory / "surfaces"), scales_(scales) {
    make_subdirectory(directory_);
}

SurfaceSeries SurfaceSeries::resume(const std::filesystem::path& run_directory, Scales scales,
                                    std::int64_t last_step) {
    SurfaceSeries series(run_directory, scales);
    for (const std::int64_t step : list_steps(series.directory_, "surface_", ".vtp")) {
        if (step <= last_step)
            series.steps_.push_back(step);
        else
            std::filesystem::remove(series.directory_ / surface_name(step));
    }
    series.write_index();
    return series;
}

std::filesystem::path SurfaceSeries::write(std::int64_t step, std::vector<SurfaceArrays> surfaces) {
    for (auto& surface : surfaces)
        for (auto& point : surface.points)
            point = scales_.cell * point;
    const std::filesystem::path file = directory_ / surface_name(step);
    write_surface_file(file, surfaces, step, static_cast<double>(step) * scales_.step);
    if (std::find(steps_.begin(), steps_.end(), step) == steps_.end())
        steps_.push_back(step);
    write_index();
    return file;
}

void SurfaceSeries::write_index() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const std::int64_t step : steps_) {
        text += "<DataSet timestep=\"";
        append_number(text, static_cast<double>(step) * scales_.step);
        text += fmt::format("\" part=\"0\" file=\"{}\"/>\n", surface_name(step));
    }
    write_atomically(directory_ / "surfaces.pvd", text + "</Collection>\n</VTKFile>\n");
}

} // namespace vesica
