#pragma once

#include "case/parameters.hpp"

namespace vesica {

/// What a run's output will take, as far as it can be foretold.
struct OutputCost {
    double bytes = 0.0; ///< on disk at the end, at most: how far fields can be compressed is not known
    double seconds = 0.0;
};

/// Tables are left out, but for the time that metrics take.
OutputCost output_cost(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                       int threads);

/// Of all membranes, cells^2, once they have the area they are to get.
double membrane_area(const Parameters& parameters);

} // namespace vesica
