#pragma once

#include "io/toml_tree.hpp"

#include <string>
#include <vector>

namespace vesica {

/// One `path=value` as given to --set.
struct TomlOverride {
    struct Segment {
        std::string key; ///< empty: an index
        std::size_t index = 0;
    };
    std::vector<Segment> path;
    TomlNode value;
    std::string text; ///< as it was given
};

/// Parses `path=value`, where the path reads like `vesicle[0].radius` and the value is TOML; a bare word, or
/// a quantity whose quotes the shell has taken, becomes a string. Throws InputError that names `--set
/// path=value`.
TomlOverride parse_override(const std::string& text);

/// Writes the value into the tree: replaces what stands there, creates tables on the way, appends to an array
/// at the index one past its end. Throws InputError when the path leads through something that is neither.
void apply_override(TomlNode& root, TomlOverride&& override_);

} // namespace vesica
