#pragma once

#include <filesystem>
#include <string>

namespace vesica {

struct FileDescription {
    std::string text; ///< a few lines for a reader
    bool intact = true;
};

/// What a file of Vesica holds, and whether it is intact: case, checkpoint, metrics, summary, fields,
/// surfaces. Throws InputError for anything else, and when there is no such file.
FileDescription describe_file(const std::filesystem::path& path);

} // namespace vesica
