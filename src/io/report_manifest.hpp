#pragma once

#include "io/report_run.hpp"
#include "io/surface_packing.hpp"

#include <string>
#include <vector>

namespace vesica {

/// What the page knows of a step before it decodes it.
struct ReportFrame {
    std::int64_t step = 0;
    double time = 0.0; ///< seconds, or steps where the case has no scales
    std::size_t triangles = 0;
    std::vector<ValueSpread> spreads; ///< empty: the frame itself tells
};

/// How the page was made.
struct ReportMaking {
    bool live = false;             ///< the page may ask for more
    std::string plan_text;         ///< as `vesica check` prints it; may be empty
    std::size_t metrics_every = 1; ///< of the samples in metrics.csv
    std::vector<std::string> notes;
};

/// Everything of the page but the surfaces themselves, as JSON (report/src/source.js lists the members). Free
/// of `<`, so that it may stand in a script element.
std::string report_manifest(const ReportRun& run, const std::vector<ReportFrame>& frames,
                            const ReportMaking& making);

/// The manifest as an element of the page.
std::string report_manifest_element(const std::string& manifest);

} // namespace vesica
