#pragma once

#include "io/posix_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace vesica {

/// The directory of one run, held by a lock for as long as this lives: no second run can write into it.
class OutputDirectory {
public:
    /// For a new run: creates `path` and what is missing above it. A directory that holds anything is refused
    /// unless `overwrite`; then what an earlier run left is removed, and files of others stay. Throws
    /// RunError, whose text says what to do.
    static OutputDirectory create(const std::filesystem::path& path, bool overwrite);

    /// For a run to be resumed: what is there stays. Throws InputError when there is no such directory.
    static OutputDirectory open(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    explicit OutputDirectory(std::filesystem::path path);

    std::filesystem::path path_;
    FileDescriptor lock_;
};

/// The files in a run's directory that a run writes, and so may remove; relative to it, sorted. The case
/// itself is not among them: it may be the very file the run was started from, and is replaced in one instant
/// anyway.
std::vector<std::filesystem::path> removable_outputs(const std::filesystem::path& directory);

/// Whether a run holds the directory now.
bool is_being_written(const std::filesystem::path& directory);

} // namespace vesica
