#include "simulation/run_surfaces.hpp"

#include "measure/surface.hpp"
#include "measure/whole_cells.hpp"
#include "parallel/for_each_task.hpp"
#include "simulation/field_work.hpp"

#include <algorithm>

namespace vesica {

namespace {

/// A layer's cells take some twenty times as much memory as the surface that is made of them.
constexpr int vesicles_at_once = 8;

SurfaceSeries series_for(const Case& what, const std::filesystem::path& directory,
                         std::optional<std::int64_t> resumed) {
    const Scales scales = what.scales.value_or(Scales{});
    if (resumed)
        return SurfaceSeries::resume(directory, scales, *resumed);
    return SurfaceSeries(directory, scales);
}

/// Carries a quantity of the layer's cells to the points of the surface.
class OntoSurface {
public:
    OntoSurface(const VesicleSnapshot& vesicle, const SurfaceMesh& mesh, const std::optional<Scales>& scales)
        : vesicle_(vesicle), mesh_(mesh), block_(phase_block(vesicle)), scales_(scales) {}

    template <class Quantity>
    SurfaceQuantity scalar(const std::string& name, Quantity quantity) const {
        const std::vector<double> values = on_points(quantity);
        SurfaceQuantity result{name, 1, std::vector<float>(values.size())};
        std::transform(values.begin(), values.end(), result.values.begin(),
                       [factor = factor(name)](double value) { return static_cast<float>(factor * value); });
        return result;
    }

    template <class Quantity>
    SurfaceQuantity vector(const std::string& name, Quantity quantity, bool as_direction = false) const {
        std::vector<double> parts[3];
        for (int axis = 0; axis < 3; ++axis)
            parts[axis] = on_points([&](const InterfaceCell& cell) { return quantity(cell)[axis]; });
        SurfaceQuantity result{name, 3, {}};
        for (std::size_t point = 0; point < mesh_.points.size(); ++point) {
            const Vec3<double> whole{parts[0][point], parts[1][point], parts[2][point]};
            const double length = as_direction ? norm(whole) : 0.0;
            const double scale = length > 0.0 ? 1.0 / length : factor(name);
            for (int axis = 0; axis < 3; ++axis)
                result.values.push_back(static_cast<float>(scale * whole[axis]));
        }
        return result;
    }

private:
    template <class Quantity>
    std::vector<double> on_points(Quantity quantity) const {
        return interpolate(mesh_, nodal_values(vesicle_, block_, quantity));
    }
    double factor(const std::string& name) const { return scales_ ? scales_->unit(dimension_of(name)) : 1.0; }

    const VesicleSnapshot& vesicle_;
    const SurfaceMesh& mesh_;
    DenseBlock block_;
    const std::optional<Scales>& scales_;
};

} // namespace

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
    using Cell = InterfaceCell;
    const OntoSurface onto(vesicle, mesh, scales);
    const auto sum = [](const Cell& cell) {
        return cell.bending_force + cell.tension_force + cell.area_force;
    };
    arrays.quantities = {
        onto.scalar("mean_curvature", [](const Cell& cell) { return cell.H0; }),
        onto.scalar("gaussian_curvature", [](const Cell& cell) { return cell.K0; }),
        onto.scalar("bending_force", [](const Cell& cell) { return cell.bending_force; }),
        onto.scalar("tension_force", [](const Cell& cell) { return cell.tension_force; }),
        onto.scalar("area_force", [](const Cell& cell) { return cell.area_force; }),
        onto.scalar("total_force", sum),
        onto.vector("velocity", [](const Cell& cell) { return cell.u; }),
        onto.vector(
            "normal", [](const Cell& cell) { return cell.n; }, true),
    };
    return arrays;
}

RunSurfaces::RunSurfaces(const Case& what, const std::filesystem::path& directory,
                         std::optional<std::int64_t> resumed, int threads)
    : series_(series_for(what, directory, resumed)),
      scales_(what.scales),
      vesicles_(static_cast<int>(what.parameters.vesicles.size())),
      threads_(threads) {}

std::filesystem::path RunSurfaces::write(const Engine& engine) {
    std::vector<SurfaceArrays> surfaces(static_cast<std::size_t>(vesicles_));
    for (int first = 0; first < vesicles_; first += vesicles_at_once) {
        const int count = std::min(vesicles_at_once, vesicles_ - first);
        const std::vector<VesicleSnapshot> layers = engine.vesicles(first, count);
        for_each_task(count, threads_, [&](std::int64_t k) {
            const auto label = static_cast<std::size_t>(first + k);
            surfaces[label] =
                surface_of(layers[static_cast<std::size_t>(k)], static_cast<int>(label), scales_);
        });
    }
    return series_.write(engine.steps_done(), std::move(surfaces));
}

} // namespace vesica
