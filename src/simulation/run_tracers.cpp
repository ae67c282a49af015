#include "simulation/run_tracers.hpp"

#include "core/input_error.hpp"
#include "measure/dense_block.hpp"
#include "measure/solid_body.hpp"
#include "measure/whole_cells.hpp"
#include "simulation/run_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesica {

namespace {

const std::vector<std::string> columns{"step", "time", "tracer", "seed", "released", "x",
                                       "y",    "z",    "vx",     "vy",   "vz"};

MetricsFile file_for(const OutputDirectory& directory, std::optional<std::int64_t> resumed) {
    const std::filesystem::path path = directory / "tracers.csv";
    return resumed ? MetricsFile::resume(path, columns, *resumed) : MetricsFile(path, columns);
}

Vec3<double> unit(int axis) {
    Vec3<double> vector{};
    vector[axis] = 1.0;
    return vector;
}

/// Between the block's cells; far outside the vesicle beyond them.
double distance_at(const DenseBlock& distance, const Vec3<double>& place) {
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) {
        double weight = 1.0;
        Vec3<int> cell{};
        for (int a = 0; a < 3; ++a) {
            const double x = place[a] - 0.5 - distance.origin[a];
            const int upper = k >> a & 1;
            const double t = x - std::floor(x);
            weight *= upper == 1 ? t : 1.0 - t;
            cell[a] = std::clamp(static_cast<int>(std::floor(x)) + upper, 0, distance.size[a] - 1);
        }
        sum += weight * distance.values[distance.index(cell.x, cell.y, cell.z)];
    }
    return sum;
}

} // namespace

std::vector<Vec3<double>> contour_points(const VesicleSnapshot& vesicle, const Vec3<double>& first,
                                         const Vec3<double>& second, int count) {
    std::vector<Vec3<double>> points;
    const DenseBlock distance = distance_block(phase_block(on_whole_cells(vesicle)), vesicle.beta);
    const Vec3<double> middle = solid_body(vesicle).centre;
    const double farthest =
        norm(Vec3<double>{1.0 * distance.size.x, 1.0 * distance.size.y, 1.0 * distance.size.z});
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / count;
        const Vec3<double> ray = std::cos(angle) * first + std::sin(angle) * second;
        const auto is_inside = [&](double length) {
            return distance_at(distance, middle + length * ray) < 0.0;
        };
        double inner = farthest;
        while (inner > 0.0 && !is_inside(inner))
            inner -= 0.25;
        if (inner <= 0.0)
            continue; // a hollow vesicle's middle may lie outside it
        double outer = inner + 0.25;
        for (int halving = 0; halving < 40; ++halving)
            (is_inside(0.5 * (inner + outer)) ? inner : outer) = 0.5 * (inner + outer);
        points.push_back(middle + 0.5 * (inner + outer) * ray);
    }
    return points;
}

RunTracers::RunTracers(const Case& what, const OutputDirectory& directory,
                       std::optional<std::int64_t> resumed)
    : parameters_(what.parameters), output_(*what.output.tracers), file_(file_for(directory, resumed)) {}

void RunTracers::release(const Vec3<double>& place, double seed, std::int64_t step) {
    tracers_.push_back({count_, seed, static_cast<double>(step), place, {}});
    count_ += 1.0;
}

void RunTracers::release_due(const Engine& engine) {
    const std::int64_t step = engine.steps_done();
    if (!output_.released_at(step) || step == released_at_)
        return;
    released_at_ = step;
    double seed = 0.0;
    for (const TracerSeeds& seeds : output_.seeds)
        for (int k = 0; k < seeds.count; ++k) {
            const double t = seeds.count > 1 ? static_cast<double>(k) / (seeds.count - 1) : 0.0;
            release((1.0 - t) * seeds.from + t * seeds.to, seed, step);
            seed += 1.0;
        }
    if (output_.membrane == 0 || step != output_.start)
        return;
    ShearPlane plane{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    if (const auto& extension = parameters_.flow.extension)
        plane = {unit(extension->stretch), unit(extension->squeeze)};
    if (const auto sheared = shear_plane(parameters_))
        plane = *sheared;
    for (const VesicleSnapshot& vesicle : engine.snapshot().vesicles)
        for (const Vec3<double>& point :
             contour_points(vesicle, plane.flow, plane.gradient, output_.membrane)) {
            release(point, seed, step);
            seed += 1.0;
        }
}

/// Where there is no fluid nobody is carried any more.
void RunTracers::drop_lost(const std::vector<Vec3<double>>& velocities) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < tracers_.size(); ++k)
        if (!std::isnan(velocities[k].x))
            tracers_[kept++] = tracers_[k];
    tracers_.resize(kept);
}

/// The second half of Heun's method: with the velocity where the first half has led, and as it is by now.
void RunTracers::arrive(const Engine& engine) {
    const std::int64_t step = engine.steps_done();
    if (departed_at_ < 0 || step == departed_at_)
        return;
    const auto steps = static_cast<double>(step - departed_at_);
    departed_at_ = -1;
    if (tracers_.empty())
        return;
    std::vector<Vec3<double>> predicted;
    for (const Tracer& tracer : tracers_)
        predicted.push_back(tracer.place + steps * tracer.velocity);
    const std::vector<Vec3<double>> velocities = engine.velocities(predicted);
    for (std::size_t k = 0; k < tracers_.size(); ++k) {
        const Vec3<double>& first = tracers_[k].velocity;
        const Vec3<double> second = std::isnan(velocities[k].x) ? first : velocities[k]; // a step too far
        tracers_[k].place = tracers_[k].place + 0.5 * steps * (first + second);
    }
}

/// Their velocities where they are.
void RunTracers::look_around(const Engine& engine) {
    if (tracers_.empty())
        return;
    std::vector<Vec3<double>> places;
    for (const Tracer& tracer : tracers_)
        places.push_back(tracer.place);
    const std::vector<Vec3<double>> velocities = engine.velocities(places);
    for (std::size_t k = 0; k < tracers_.size(); ++k)
        tracers_[k].velocity = velocities[k];
    drop_lost(velocities);
}

void RunTracers::write(const Engine& engine) {
    arrive(engine);
    release_due(engine);
    look_around(engine);
    const auto step = static_cast<double>(engine.steps_done());
    std::vector<std::vector<double>> rows;
    for (const Tracer& tracer : tracers_) {
        const Vec3<double>& u = tracer.velocity;
        rows.push_back({step, step, tracer.number, tracer.seed, tracer.released, tracer.place.x,
                        tracer.place.y, tracer.place.z, u.x, u.y, u.z});
    }
    file_.append(rows);
    written_at_ = engine.steps_done();
}

void RunTracers::carry(const Engine& engine) {
    if (written_at_ != engine.steps_done()) {
        arrive(engine);
        release_due(engine);
        look_around(engine);
    }
    departed_at_ = engine.steps_done();
}

RunTracers::Notes RunTracers::notes() const {
    Notes notes;
    std::vector<double>& list = notes["tracers"];
    list = {count_, static_cast<double>(released_at_), static_cast<double>(departed_at_)};
    for (const Tracer& tracer : tracers_)
        list.insert(list.end(), {tracer.number, tracer.seed, tracer.released, tracer.place.x, tracer.place.y,
                                 tracer.place.z, tracer.velocity.x, tracer.velocity.y, tracer.velocity.z});
    return notes;
}

void RunTracers::restore(const Notes& notes) {
    constexpr std::size_t head = 3;
    constexpr std::size_t each = 9;
    const auto found = notes.find("tracers");
    if (found == notes.end() || found->second.size() < head || (found->second.size() - head) % each != 0)
        throw RunError("the checkpoint does not remember its tracers");
    const std::vector<double>& list = found->second;
    count_ = list[0];
    released_at_ = static_cast<std::int64_t>(list[1]);
    departed_at_ = static_cast<std::int64_t>(list[2]);
    tracers_.clear();
    for (const double* t = list.data() + head; t != list.data() + list.size(); t += each)
        tracers_.push_back({t[0], t[1], t[2], {t[3], t[4], t[5]}, {t[6], t[7], t[8]}});
}

} // namespace vesica
