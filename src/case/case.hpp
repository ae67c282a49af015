#pragma once

#include "case/parameters.hpp"
#include "case/suspension_parameters.hpp"
#include "core/input_error.hpp"
#include "core/scales.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// Where the inertia was scaled ([units] reynolds): the lattice keeps the viscosity, the moduli and the times
/// of the real system, but its fluid is denser by reynolds/true_reynolds.
struct InertiaScaling {
    double reynolds = 0.0;      ///< of the lattice, as asked for
    double true_reynolds = 0.0; ///< of the real system
    double true_density = 0.0;  ///< kg/m^3, of the real fluid

    friend bool operator==(const InertiaScaling&, const InertiaScaling&) = default;
};

/// An earlier run's state to start from, with this case's parameters and step 0.
struct InitialCheckpoint {
    std::string path;                 ///< a run's directory or one checkpoint
    std::optional<std::int64_t> step; ///< of a directory's checkpoints; absent: the newest that is intact

    friend bool operator==(const InitialCheckpoint&, const InitialCheckpoint&) = default;
};

/// What a case file says, checked, in lattice units, with everything needed to speak of it to its author.
struct Case {
    std::string title;
    Parameters parameters;
    RunParameters run;
    OutputParameters output;
    /// What is still to be packed (simulation/suspension.hpp), or has been: `packed` of the last vesicles.
    std::optional<SuspensionParameters> suspension;
    std::size_t packed = 0;
    std::optional<InitialCheckpoint> initial; ///< absent: the vesicles' shapes in a fluid at rest

    std::optional<Scales> scales;          ///< absent: the case is stated in lattice units only
    std::optional<InertiaScaling> inertia; ///< only with [units] reynolds

    std::string source_file;
    std::string source_text;            ///< verbatim, without the overrides
    std::vector<std::string> overrides; ///< `path=value`, in the order in which they were applied
    /// Place of every key that was given, by its full path ("vesicle[0].radius"). Keys that are absent have
    /// defaults.
    std::map<std::string, SourcePlace> places;
    std::vector<std::string> warnings; ///< each with its place, for `check`

    /// The place of a key, or of the nearest table around it that was given, or the file alone.
    SourcePlace place(const std::string& path) const;
};

} // namespace vesica
