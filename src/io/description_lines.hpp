#pragma once

#include "io/describe_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// A heading and lines of `name   value`, aligned.
class DescriptionLines {
public:
    DescriptionLines(const std::filesystem::path& path, std::string_view heading);
    /// The heading says whether it is intact.
    DescriptionLines(const std::filesystem::path& path, std::string_view heading, bool intact);

    void add(std::string_view name, std::string_view value);
    /// One line per value, the name only before the first; nothing for an empty list.
    void add(std::string_view name, std::span<const std::string> values);
    FileDescription description() const { return {text_, intact_}; }

private:
    std::string text_;
    bool intact_ = true;
};

/// "812 bytes", "1.2 kB", "40.1 MB".
std::string readable_bytes(double bytes);

/// "none", "100" or "3, from 0 to 200".
std::string readable_steps(std::span<const double> steps);

FileDescription describe_fields_index(const std::filesystem::path& path);  ///< fields.xmf
FileDescription describe_fields(const std::filesystem::path& path);        ///< fields.h5 or one step's file
FileDescription describe_surface(const std::filesystem::path& path);       ///< .vtp
FileDescription describe_surface_index(const std::filesystem::path& path); ///< .pvd

} // namespace vesica
