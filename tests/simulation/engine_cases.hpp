#pragma once

#include "case/parameters.hpp"
#include "measure/metrics.hpp"
#include "simulation/engine.hpp"

namespace vesica::test {

/// A small spheroid that is far from equilibrium: it deforms from the first step on.
inline Parameters deforming_spheroid(int edge = 32, double radius = 7.0) {
    Parameters parameters;
    parameters.size = {edge, edge, edge};
    VesicleType type;
    type.bending.modulus = 0.2;
    type.sigma = 1e-3;
    parameters.types = {type};
    VesicleParameters vesicle;
    vesicle.shape = SpheroidShape{1.8};
    vesicle.radius = radius;
    vesicle.centre = {edge / 2.0, edge / 2.0, edge / 2.0};
    vesicle.axis = {1.0, 0.6, 0.3};
    parameters.vesicles = {vesicle};
    return parameters;
}

inline MetricsRow metrics_of(const Engine& engine) {
    const Snapshot snapshot = engine.snapshot();
    return measure(snapshot.vesicles.front(), snapshot, baseline_of(snapshot.vesicles.front(), 0));
}

inline void run(Engine& engine, int steps) {
    for (int k = 0; k < steps; ++k)
        engine.step();
}

inline bool same_state(const EngineState& a, const EngineState& b) {
    return a.step == b.step && a.populations == b.populations && a.minority == b.minority &&
           a.band == b.band && a.label == b.label && a.controllers == b.controllers;
}

} // namespace vesica::test
