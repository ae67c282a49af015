#include "io/output_directory.hpp"

#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/step_name.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace vesica {
namespace {

using Path = std::filesystem::path;

constexpr const char* lock_name = ".vesica.lock";
constexpr std::array single_files = {"metrics.csv",    "tracers.csv", "profiles.csv",
                                     "suspension.csv", "pairs.csv",   "summary.json",
                                     "fields.xmf",     "fields.h5",   "log.txt"};

struct Series {
    const char* directory;
    const char* prefix;
    const char* suffix;
};
constexpr std::array all_series = {Series{"fields", "step_", ".h5"}, Series{"surfaces", "surface_", ".vtp"},
                                   Series{"checkpoints", "step_", ".h5"}};
constexpr const char* surface_index = "surfaces.pvd";

/// The name whose temporary file this is, if it is one.
std::string without_partial(const std::string& name) {
    constexpr std::string_view ending = ".partial";
    if (name.size() > ending.size() + 1 && name.front() == '.' && name.ends_with(ending))
        return name.substr(1, name.size() - ending.size() - 1);
    return name;
}

bool is_single_output(const std::string& name) {
    const std::string target = without_partial(name);
    const bool is_temporary = target != name;
    if (is_temporary && (target == "case.toml" || target == "resolved.toml"))
        return true;
    return std::find(single_files.begin(), single_files.end(), target) != single_files.end();
}

bool is_output_of(const Series& series, const std::string& name) {
    const std::string target = without_partial(name);
    if (std::string_view(series.directory) == "surfaces" && target == surface_index)
        return true;
    return parse_step_name(target, series.prefix, series.suffix).has_value();
}

bool is_empty_but_for_lock(const Path& directory) {
    const auto entries = std::filesystem::directory_iterator(directory);
    return std::all_of(begin(entries), end(entries),
                       [](const auto& entry) { return entry.path().filename() == lock_name; });
}

FileDescriptor take_lock(const Path& directory) {
    const Path path = directory / lock_name;
    const int number = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (number < 0)
        fail_with_errno(directory, "cannot write into this directory");
    FileDescriptor lock(number);
    if (::flock(lock.number(), LOCK_EX | LOCK_NB) == 0)
        return lock;
    if (errno == EWOULDBLOCK)
        throw RunError(
            fmt::format("{}: another run is writing into this directory; wait for it, or choose another "
                        "with -o DIR",
                        directory.string()));
    // Some network file systems know no locks. Then two runs are the user's own care.
    if (errno == ENOLCK || errno == EOPNOTSUPP)
        return lock;
    fail_with_errno(directory, "cannot lock this directory");
}

} // namespace

std::vector<Path> removable_outputs(const Path& directory) {
    std::vector<Path> found;
    const auto collect = [&](const Path& below, const auto& is_ours) {
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(directory / below, none)) {
            const Path name = entry.path().filename();
            if (!entry.is_directory() && is_ours(name.string()))
                found.push_back(below / name);
        }
    };
    collect("", is_single_output);
    for (const Series& series : all_series)
        collect(series.directory, [&](const std::string& name) { return is_output_of(series, name); });
    std::sort(found.begin(), found.end(),
              [](const Path& a, const Path& b) { return a.string() < b.string(); });
    return found;
}

OutputDirectory::OutputDirectory(Path path) : path_(std::move(path)), lock_(take_lock(path_)) {}

OutputDirectory OutputDirectory::create(const Path& path, bool overwrite) {
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    if (exists(status) && !is_directory(status))
        throw RunError(
            fmt::format("{}: is a file; expected a directory; choose another with -o DIR", path.string()));
    const Path parent = path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
    if (!exists(status) && !parent.empty()) { // out/CASE, the default, needs an `out` the first time
        std::error_code failure;
        std::filesystem::create_directories(parent, failure);
        if (failure)
            fail_with_errno(parent, "cannot create the directory", failure.value());
    }
    make_subdirectory(path);
    if (::access(path.c_str(), W_OK | X_OK) != 0)
        fail_with_errno(path, "cannot write into this directory");
    if (!overwrite && !is_empty_but_for_lock(path))
        throw RunError(
            fmt::format("{}: is not empty; choose another directory with -o DIR, or replace the earlier "
                        "run with --overwrite",
                        path.string()));

    OutputDirectory directory(path);
    for (const Path& file : removable_outputs(path)) {
        std::error_code failure;
        std::filesystem::remove(path / file, failure);
        if (failure)
            fail_with_errno(path / file, "cannot remove", failure.value());
    }
    for (const Series& series :
         all_series) // those that are empty now; a file of somebody else keeps its directory
        ::rmdir((path / series.directory).c_str());
    return directory;
}

OutputDirectory OutputDirectory::open(const Path& path) {
    std::error_code none;
    if (!std::filesystem::is_directory(path, none))
        throw InputError(
            fmt::format("{}: is not a directory; expected the directory of an earlier run", path.string()));
    return OutputDirectory(path);
}

bool is_being_written(const Path& directory) {
    const FileDescriptor lock(::open((directory / lock_name).c_str(), O_RDONLY | O_CLOEXEC));
    return lock && ::flock(lock.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

} // namespace vesica
