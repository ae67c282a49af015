#include "io/toml_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// toml++ 3.3 asserts, or with NDEBUG lets clang assume, that a table header like `[=]` begins with a key, and
// only then reports that it does not. The user's mistakes must reach the report: no assertions, no
// assumptions.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace vesica {
namespace {

constexpr std::size_t longest_shown = 60;
// Far beyond any case. toml++ counts the depth of brackets but not that of dotted keys, whose tables it nests
// all the same, and a tree of many thousand levels overflows the stack of whoever walks or destroys it.
constexpr int most_key_parts = 64;
constexpr int deepest = 32;

[[noreturn]] void refuse_depth(const SourcePlace& place) {
    throw InputError(
        place, fmt::format("the tables are nested deeper than {}; expected a case, whose deepest key is "
                           "vesicle_type.NAME.bending.modulus; try shorter keys",
                           deepest));
}

/// Refuses `a.a.a.a ...`. A row of dots is no key, and neither is a line of comment.
void check_key_parts(std::string_view text, const std::string& name) {
    int line = 1;
    int column = 0;
    int parts = 0;
    char before = '\n';
    bool comment = false;
    for (const char c : text) {
        ++column;
        comment = c != '\n' && (comment || (c == '#' && before == '\n'));
        if (c == '.' && before != '.' && !comment && ++parts > most_key_parts)
            refuse_depth({name, line, column});
        if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos)
            parts = 0;
        if (c == '\n') {
            ++line;
            column = 0;
        }
        if (c != ' ' && c != '\t')
            before = c;
    }
}

SourcePlace place_of(const toml::source_position& position, const std::string& name) {
    return {name, static_cast<int>(position.line), static_cast<int>(position.column)};
}

TomlNode copied(const toml::node& node, const std::string& name, int depth = 0) {
    TomlNode result;
    result.place = place_of(node.source().begin, name);
    if (depth > deepest)
        refuse_depth(result.place);
    if (const auto* table = node.as_table()) {
        TomlTable members;
        for (const auto& [key, value] : *table) {
            members.push_back({std::string(key.str()), place_of(key.source().begin, name),
                               std::make_unique<TomlNode>(copied(value, name, depth + 1))});
        }
        // The parser sorts by key; messages should name the first mistake of the file first.
        std::stable_sort(members.begin(), members.end(), [](const TomlMember& a, const TomlMember& b) {
            return std::pair(a.key_place.line, a.key_place.column) <
                   std::pair(b.key_place.line, b.key_place.column);
        });
        result.value = std::move(members);
    } else if (const auto* array = node.as_array()) {
        TomlArray items;
        for (const auto& item : *array)
            items.push_back(copied(item, name, depth + 1));
        result.value = std::move(items);
    } else if (const auto* text = node.as_string()) {
        result.value = text->get();
    } else if (const auto* integer = node.as_integer()) {
        result.value = integer->get();
    } else if (const auto* number = node.as_floating_point()) {
        result.value = number->get();
    } else if (const auto* boolean = node.as_boolean()) {
        result.value = boolean->get();
    } else {
        result.value = TomlDate{};
    }
    return result;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string full_text(const TomlNode& node, int depth) {
    if (const auto* boolean = std::get_if<bool>(&node.value))
        return *boolean ? "true" : "false";
    if (const auto* integer = std::get_if<std::int64_t>(&node.value))
        return fmt::format("{}", *integer);
    if (const auto* number = std::get_if<double>(&node.value)) {
        const std::string text = fmt::format("{}", *number);
        return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
    }
    if (const auto* text = std::get_if<std::string>(&node.value))
        return quoted(*text);
    if (std::holds_alternative<TomlDate>(node.value))
        return "a date or time";
    if (node.table())
        return "a table";
    std::string result = "[";
    for (const TomlNode& item : *node.array()) {
        if (result.size() > 1)
            result += ", ";
        result += depth > 3 ? "..." : full_text(item, depth + 1);
        if (result.size() > 2 * longest_shown)
            break;
    }
    return result + "]";
}

} // namespace

TomlNode* find_member(TomlTable& table, const std::string& key) {
    for (TomlMember& member : table) {
        if (member.key == key)
            return member.node.get();
    }
    return nullptr;
}

const TomlNode* find_member(const TomlTable& table, const std::string& key) {
    for (const TomlMember& member : table) {
        if (member.key == key)
            return member.node.get();
    }
    return nullptr;
}

std::string shown(const TomlNode& node) {
    std::string text = full_text(node, 0);
    if (text.size() <= longest_shown)
        return text;
    std::size_t end = longest_shown;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end; // between characters
    return text.substr(0, end) + "...";
}

TomlNode parse_toml(const std::string& text, const std::string& name) {
    check_key_parts(text, name);
    try {
        return copied(toml::parse(text, name), name);
    } catch (const toml::parse_error& error) {
        throw InputError(
            place_of(error.source().begin, name),
            fmt::format("the text is no TOML ({}); expected TOML 1.0; try completing or correcting the "
                        "text at this place",
                        error.description()));
    }
}

} // namespace vesica
