#pragma once

#include "core/input_error.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vesica {

struct TomlNode;

/// A key of a table, where it stands, and its value.
struct TomlMember {
    std::string key;
    SourcePlace key_place;
    std::unique_ptr<TomlNode> node;
};

using TomlTable = std::vector<TomlMember>; ///< in the order of the file
using TomlArray = std::vector<TomlNode>;
struct TomlDate {}; ///< dates and times, which no key takes

/// One value of a TOML document with its place in the text.
struct TomlNode {
    std::variant<bool, std::int64_t, double, std::string, TomlDate, TomlArray, TomlTable> value;
    SourcePlace place;

    const TomlTable* table() const { return std::get_if<TomlTable>(&value); }
    const TomlArray* array() const { return std::get_if<TomlArray>(&value); }
    TomlTable* table() { return std::get_if<TomlTable>(&value); }
    TomlArray* array() { return std::get_if<TomlArray>(&value); }
};

/// The member of that key, or nothing.
TomlNode* find_member(TomlTable& table, const std::string& key);
const TomlNode* find_member(const TomlTable& table, const std::string& key);

/// The value as a user would recognise it in a message: `"mrt"`, `[1, 2]`, `a table`; long ones are cut
/// short.
std::string shown(const TomlNode& node);

/// Parses TOML 1.0. `name` stands for the file in messages and places. Throws InputError.
TomlNode parse_toml(const std::string& text, const std::string& name);

} // namespace vesica
