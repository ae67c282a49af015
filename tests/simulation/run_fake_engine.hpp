#pragma once

#include "simulation/engine.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace vesica::test {

/// Counts steps and shows one sphere at rest; breaks at a chosen step. Enough to test what surrounds an
/// engine.
class FakeEngine : public Engine {
public:
    explicit FakeEngine(Parameters parameters) : parameters_(std::move(parameters)) {}

    std::int64_t breaks_at = -1;
    std::function<void(std::int64_t)> after_step;

    void step() override {
        ++steps_;
        if (after_step)
            after_step(steps_);
    }
    std::int64_t steps_done() const override { return steps_; }

    Snapshot snapshot() const override {
        Snapshot snapshot;
        snapshot.step = steps_;
        snapshot.max_speed = 1e-4;
        for (const VesicleParameters& vesicle : parameters_.vesicles)
            snapshot.vesicles.push_back(sphere(vesicle));
        return snapshot;
    }

    DenseField field(std::string_view name) const override {
        DenseField field;
        field.size = parameters_.size;
        field.components = name == "velocity" || name == "force" ? 3 : 1;
        const auto cells = static_cast<std::size_t>(field.size.x) * static_cast<std::size_t>(field.size.y) *
                           static_cast<std::size_t>(field.size.z);
        field.values.assign(cells * static_cast<std::size_t>(field.components), static_cast<double>(steps_));
        if (name == "phase") {
            std::size_t cell = 0;
            for (int z = 0; z < field.size.z; ++z)
                for (int y = 0; y < field.size.y; ++y)
                    for (int x = 0; x < field.size.x; ++x)
                        field.values[cell++] = phase_at({x + 0.5, y + 0.5, z + 0.5});
        }
        return field;
    }

    std::vector<Vec3<double>> velocities(const std::vector<Vec3<double>>& places) const override {
        return std::vector<Vec3<double>>(places.size(), {0.01, 0.0, 0.0});
    }

    std::optional<Trouble> trouble() const override {
        if (breaks_at < 0 || steps_ < breaks_at)
            return std::nullopt;
        return Trouble{steps_, {1, 2, 3}, 0, "speed 0.91, expected less than 0.3"};
    }

    EngineState save() const override {
        EngineState state;
        state.step = steps_;
        state.precision = parameters_.numerics.precision;
        state.size = parameters_.size;
        const auto cells = static_cast<std::size_t>(state.size.x) * static_cast<std::size_t>(state.size.y) *
                           static_cast<std::size_t>(state.size.z);
        state.populations.assign(19, std::vector<double>(cells, 0.25));
        state.minority.assign(cells, 0.0);
        state.band.assign(cells, 0);
        state.controllers.assign(parameters_.vesicles.size(), 0.5);
        return state;
    }
    void load(const EngineState& state) override { steps_ = state.step; }

    std::size_t bytes_allocated() const override { return 1000; }
    double interface_fraction() const override { return 0.1; }
    std::string_view instruction_set() const override { return "baseline"; }
    const StepProfile& profile() const override { return profile_; }

private:
    double phase_at(const Vec3<double>& position) const {
        double phi = -1.0;
        for (const VesicleParameters& vesicle : parameters_.vesicles) {
            const double s = norm(position - vesicle.centre) - vesicle.radius;
            phi = std::max(phi, -std::tanh(parameters_.fluid.segregation * s));
        }
        return phi;
    }

    VesicleSnapshot sphere(const VesicleParameters& vesicle) const {
        VesicleSnapshot snapshot;
        const double beta = parameters_.fluid.segregation;
        snapshot.beta = beta;
        snapshot.layer_moment = std::numbers::pi * std::numbers::pi / (12.0 * beta * beta);
        snapshot.bending_modulus = parameters_.types[vesicle.type].bending.modulus;
        snapshot.target_area = 4.0 * std::numbers::pi * vesicle.radius * vesicle.radius;
        snapshot.colour_mass = 4.0 / 3.0 * std::numbers::pi * std::pow(vesicle.radius, 3);
        const int reach = static_cast<int>(vesicle.radius) + 6;
        for (int z = -reach; z < reach; ++z)
            for (int y = -reach; y < reach; ++y) {
                InsideSpan span{0, 0, y + static_cast<int>(vesicle.centre.y),
                                z + static_cast<int>(vesicle.centre.z)};
                for (int x = -reach; x < reach; ++x) {
                    const Vec3<double> corner{std::floor(vesicle.centre.x), std::floor(vesicle.centre.y),
                                              std::floor(vesicle.centre.z)};
                    const Vec3<double> position = corner + Vec3<double>{x + 0.5, y + 0.5, z + 0.5};
                    const Vec3<double> from = position - vesicle.centre;
                    const double r = norm(from);
                    const double s = r - vesicle.radius;
                    if (s < -5.0) {
                        if (span.count == 0)
                            span.begin = x + static_cast<int>(corner.x);
                        ++span.count;
                    }
                    if (std::abs(s) > 5.0)
                        continue;
                    InterfaceCell cell;
                    cell.position = position;
                    cell.s = s;
                    cell.phi = -std::tanh(beta * s);
                    cell.n = (1.0 / r) * from;
                    cell.H = 1.0 / r;
                    cell.K = 1.0 / (r * r);
                    cell.H0 = 1.0 / vesicle.radius;
                    cell.K0 = cell.H0 * cell.H0;
                    cell.J = 1.0 - 2.0 * s * cell.H + s * s * cell.K;
                    cell.weight = 0.5 * beta * (1.0 - cell.phi * cell.phi);
                    cell.has_geometry = true;
                    snapshot.cells.push_back(cell);
                }
                if (span.count > 0)
                    snapshot.inside.push_back(span);
            }
        return snapshot;
    }

    Parameters parameters_;
    std::int64_t steps_ = 0;
    StepProfile profile_;
};

/// One sphere in a small box.
inline Parameters small_sphere() {
    Parameters parameters;
    parameters.size = {32, 32, 32};
    VesicleType type;
    type.name = "rbc";
    type.bending.modulus = 0.25;
    parameters.types = {type};
    VesicleParameters vesicle;
    vesicle.centre = {16.0, 16.0, 16.0};
    vesicle.radius = 8.0;
    parameters.vesicles = {vesicle};
    return parameters;
}

} // namespace vesica::test
