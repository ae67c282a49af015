#pragma once

#include <filesystem>
#include <string>

namespace vesica {

/// What a file of Vesica holds, in a few lines for a reader: case, checkpoint, metrics, summary, fields,
/// surfaces. Says also whether it is intact. Throws InputError for anything else, and when there is no such
/// file.
std::string describe_file(const std::filesystem::path& path);

} // namespace vesica
