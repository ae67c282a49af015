#include "simulation/run_recorder.hpp"

#include "core/version.hpp"
#include "io/case_file.hpp"
#include "measure/surface.hpp"
#include "measure/whole_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace vesica {

namespace {

MetricsFile metrics_file_for(const Case& what, const OutputDirectory& directory,
                             std::optional<std::int64_t> resumed) {
    const std::filesystem::path path = directory / "metrics.csv";
    if (!resumed)
        return MetricsFile(path, metrics_columns());
    // A run that ended off its schedule has a last row there that a longer run would not have written.
    const std::int64_t every = what.output.metrics_every;
    const std::int64_t last = every > 0 ? *resumed / every * every : -1;
    return MetricsFile::resume(path, metrics_columns(), last);
}

std::optional<SurfaceSeries> surfaces_for(const Case& what, const OutputDirectory& directory,
                                          std::optional<std::int64_t> resumed) {
    if (what.output.surfaces_every == 0)
        return std::nullopt;
    const Scales scales = what.scales.value_or(Scales{});
    if (resumed)
        return SurfaceSeries::resume(directory.path(), scales, *resumed);
    return SurfaceSeries(directory.path(), scales);
}

/// Carries a quantity of the layer's cells to the points of the surface.
class OntoSurface {
public:
    OntoSurface(const VesicleSnapshot& vesicle, const SurfaceMesh& mesh, const std::optional<Scales>& scales)
        : vesicle_(vesicle), mesh_(mesh), block_(phase_block(vesicle)), scales_(scales) {}

    template <class Quantity>
    SurfaceQuantity scalar(const std::string& name, Quantity quantity) const {
        std::vector<double> values = interpolate(mesh_, nodal_values(vesicle_, block_, quantity));
        for (double& value : values)
            value *= factor(name);
        return {name, 1, std::move(values)};
    }

    template <class Quantity>
    SurfaceQuantity vector(const std::string& name, Quantity quantity) const {
        SurfaceQuantity result{name, 3, std::vector<double>(3 * mesh_.points.size())};
        for (int axis = 0; axis < 3; ++axis) {
            const SurfaceQuantity part =
                scalar(name, [&](const InterfaceCell& cell) { return quantity(cell)[axis]; });
            for (std::size_t point = 0; point < part.values.size(); ++point)
                result.values[3 * point + static_cast<std::size_t>(axis)] = part.values[point];
        }
        return result;
    }

private:
    double factor(const std::string& name) const { return scales_ ? scales_->unit(dimension_of(name)) : 1.0; }

    const VesicleSnapshot& vesicle_;
    const SurfaceMesh& mesh_;
    DenseBlock block_;
    const std::optional<Scales>& scales_;
};

SurfaceArrays surface_of(const VesicleSnapshot& measured, int index, const std::optional<Scales>& scales) {
    const VesicleSnapshot vesicle = on_whole_cells(measured);
    const SurfaceMesh mesh = extract_surface(vesicle);
    SurfaceArrays arrays;
    arrays.vesicle = index;
    arrays.points = mesh.points;
    for (const auto& corners : mesh.triangles)
        arrays.triangles.push_back({static_cast<std::int32_t>(corners[0]),
                                    static_cast<std::int32_t>(corners[1]),
                                    static_cast<std::int32_t>(corners[2])});
    const OntoSurface onto(vesicle, mesh, scales);
    arrays.quantities = {
        onto.scalar("mean_curvature", [](const InterfaceCell& cell) { return cell.H0; }),
        onto.scalar("gaussian_curvature", [](const InterfaceCell& cell) { return cell.K0; }),
        onto.scalar("bending_force", [](const InterfaceCell& cell) { return cell.bending_force; }),
        onto.scalar("tension_force", [](const InterfaceCell& cell) { return cell.tension_force; }),
        onto.vector("velocity", [](const InterfaceCell& cell) { return cell.u; }),
    };
    return arrays;
}

} // namespace

RunRecorder::RunRecorder(const Case& what, const OutputDirectory& directory, RunLog& log, RunMetrics& metrics,
                         Progress& progress, const StopRequest& stop, Colleagues& colleagues,
                         std::optional<std::int64_t> resumed)
    : case_(what),
      log_(log),
      metrics_(metrics),
      progress_(progress),
      stop_(stop),
      colleagues_(colleagues),
      metrics_file_(metrics_file_for(what, directory, resumed)),
      surfaces_(surfaces_for(what, directory, resumed)),
      checkpoints_(directory / "checkpoints", std::max(1, what.output.checkpoint_keep)) {
    if (what.output.fields)
        fields_.emplace(what, directory.path(), resumed);
    if (what.output.profiles)
        profiles_.emplace(what, directory, resumed);
    if (what.output.tracers)
        tracers_.emplace(what, directory, resumed);
}

void RunRecorder::record(Event event, const Engine& engine) {
    const auto begin = std::chrono::steady_clock::now();
    switch (event) {
    case Event::trouble:
        break;
    case Event::sample:
        if (fields_)
            fields_->sample(engine);
        break;
    case Event::metrics:
        write_metrics(engine);
        break;
    case Event::fields:
        if (fields_)
            fields_->write(engine);
        break;
    case Event::surfaces:
        write_surfaces(engine);
        break;
    case Event::profiles:
        profiles_->write(engine);
        break;
    case Event::tracers:
        if (tracers_)
            tracers_->write(engine);
        break;
    case Event::carry:
        if (tracers_)
            tracers_->carry(engine);
        break;
    case Event::checkpoint:
        write_checkpoint(engine);
        break;
    }
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void RunRecorder::write_metrics(const Engine& engine) {
    std::vector<std::vector<double>> rows;
    for (const MetricsRow& row : metrics_.sample(engine.snapshot()))
        rows.push_back(metrics_values(row));
    metrics_file_.append(rows);
}

void RunRecorder::write_surfaces(const Engine& engine) {
    if (!surfaces_)
        return;
    const Snapshot snapshot = engine.snapshot();
    std::vector<SurfaceArrays> surfaces;
    for (std::size_t index = 0; index < snapshot.vesicles.size(); ++index)
        surfaces.push_back(surface_of(snapshot.vesicles[index], static_cast<int>(index), case_.scales));
    surfaces_->write(snapshot.step, std::move(surfaces));
}

void RunRecorder::write_checkpoint(const Engine& engine) {
    metrics_file_.flush();
    CheckpointNotes checkpoint;
    checkpoint.case_text = resolved_toml(case_);
    checkpoint.notes = metrics_.notes();
    if (fields_)
        checkpoint.notes.merge(fields_->notes());
    if (profiles_)
        profiles_->flush();
    if (tracers_) {
        tracers_->flush();
        checkpoint.notes.merge(tracers_->notes());
    }
    checkpoint.program_version = version;
    const std::filesystem::path path = checkpoints_.write(checkpoint, *engine.planes(), colleagues_);
    log_.information(fmt::format("step {}: checkpoint {}", engine.steps_done(), path.filename().string()));
}

} // namespace vesica
