#pragma once

#include "io/live_report.hpp"

#include <memory>
#include <string>

namespace vesica {

/// Serves the report of a run to browsers while the run goes on, from threads of its own that yield to others
/// (nice 10) and spend 1.5 % of the time at most; what costs more waits. Reading is all it offers: GET of /,
/// /manifest and /frame/STEP.
class ReportServer {
public:
    /// Listens from now on; port 0 takes a free one. Throws RunError when the address or port cannot be had.
    ReportServer(std::shared_ptr<LiveReport> report, const std::string& address, int port);
    /// Waits 2.5 seconds at most for browsers that follow the run to fetch its end, and five for them to take
    /// it.
    ~ReportServer();
    ReportServer(const ReportServer&) = delete;
    ReportServer& operator=(const ReportServer&) = delete;

    /// Where a browser finds it: http://127.0.0.1:8080/
    std::string url() const;

private:
    struct Listening;
    std::shared_ptr<Listening> listening_;
};

} // namespace vesica
