#include "io/toml_override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace vesica {
namespace {

SourcePlace place_of(const std::string& text) {
    return {"--set " + text, 0, 0};
}

[[noreturn]] void refuse(const std::string& text, const std::string& message) {
    throw InputError(place_of(text), message);
}

bool is_key_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

std::vector<TomlOverride::Segment> parse_path(const std::string& path, const std::string& text) {
    const auto wrong = [&]() {
        refuse(text, fmt::format("the path is {}; expected keys and indices; try vesicle[0].radius=12",
                                 path.empty() ? "empty" : "\"" + path + "\""));
    };
    std::vector<TomlOverride::Segment> segments;
    std::size_t at = 0;
    while (at < path.size()) {
        if (path[at] == '[') {
            std::size_t index = 0;
            const char* begin = path.data() + at + 1;
            const auto [end, code] = std::from_chars(begin, path.data() + path.size(), index);
            if (segments.empty() || code != std::errc{} || end == path.data() + path.size() || *end != ']')
                wrong();
            segments.push_back({"", index});
            at = static_cast<std::size_t>(end - path.data()) + 1;
        } else {
            if (!segments.empty()) {
                if (path[at] != '.')
                    wrong();
                ++at;
            }
            const std::size_t begin = at;
            while (at < path.size() && is_key_character(path[at]))
                ++at;
            if (at == begin)
                wrong();
            segments.push_back({path.substr(begin, at - begin), 0});
        }
    }
    if (segments.empty() || segments.size() > 20)
        wrong();
    return segments;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

void set_places(TomlNode& node, const SourcePlace& place) {
    node.place = place;
    if (auto* array = node.array()) {
        for (TomlNode& item : *array)
            set_places(item, place);
    } else if (auto* table = node.table()) {
        for (TomlMember& member : *table) {
            member.key_place = place;
            set_places(*member.node, place);
        }
    }
}

TomlNode parsed_value(const std::string& value) {
    TomlNode document = parse_toml("value = " + value, "--set");
    return std::move(*document.table()->front().node);
}

/// `[phase, force]` as `["phase", "force"]`: what is left of an array when the shell has taken its quotes.
std::string with_quoted_words(const std::string& value) {
    std::string result;
    for (std::size_t at = 0; at < value.size();) {
        std::size_t end = at;
        while (end < value.size() && is_key_character(value[end]))
            ++end;
        const std::string word = value.substr(at, end - at);
        const bool is_word = !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0;
        if (is_word && value.front() == '[' && word != "true" && word != "false") {
            result += "\"" + word + "\"";
        } else {
            result += end > at ? word : value.substr(at, 1);
        }
        at = std::max(end, at + 1);
    }
    return result;
}

TomlNode parse_value(const std::string& value, const std::string& text) {
    if (value.empty())
        refuse(text, "the value is empty; expected a value after \"=\"; try fluid.density=1.0");
    if (value.find_first_of("\n\r") != std::string::npos)
        refuse(text, "the value has more than one line; expected one value");
    TomlNode result;
    try {
        result = parsed_value(value);
    } catch (const InputError&) {
        try {
            result = parsed_value(with_quoted_words(value));
        } catch (const InputError&) {
            if (std::string_view("\"'[{").find(value.front()) != std::string_view::npos)
                refuse(text,
                       fmt::format("the value {} is no TOML; expected a number, a word, \"text\", [array] or "
                                   "{{table}}; try quoting it for the shell",
                                   value));
            result.value = value;
        }
    }
    set_places(result, place_of(text));
    return result;
}

} // namespace

TomlOverride parse_override(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
        refuse(text, "there is no \"=\"; expected path=value; try fluid.kinematic_viscosity=0.2");
    TomlOverride result;
    result.text = text;
    result.path = parse_path(trimmed(text.substr(0, equals)), text);
    result.value = parse_value(trimmed(text.substr(equals + 1)), text);
    return result;
}

void apply_override(TomlNode& root, TomlOverride&& override_) {
    const SourcePlace place = place_of(override_.text);
    TomlNode* node = &root;
    std::string path;
    for (std::size_t i = 0; i < override_.path.size(); ++i) {
        const auto& segment = override_.path[i];
        if (segment.key.empty()) {
            auto* array = node->array();
            if (!array)
                throw InputError(place, fmt::format("{} is {}; expected an array, to set its element {}",
                                                    path, shown(*node), segment.index));
            if (segment.index > array->size())
                throw InputError(place,
                                 fmt::format("{} has {} element{}; expected an index up to {}", path,
                                             array->size(), array->size() == 1 ? "" : "s", array->size()));
            if (segment.index == array->size())
                array->push_back(TomlNode{TomlTable{}, place});
            node = &(*array)[segment.index];
            path += fmt::format("[{}]", segment.index);
        } else {
            auto* table = node->table();
            if (!table) {
                throw InputError(
                    place,
                    fmt::format("{} is {}; expected {}, to set its key {}", path.empty() ? "the case" : path,
                                node->array() ? "an array" : shown(*node),
                                node->array() ? fmt::format("an index, as in {}[0]", path) : "a table",
                                segment.key));
            }
            TomlNode* member = find_member(*table, segment.key);
            if (!member) {
                const bool indexed = i + 1 < override_.path.size() && override_.path[i + 1].key.empty();
                auto fresh = std::make_unique<TomlNode>();
                fresh->place = place;
                if (indexed) {
                    fresh->value = TomlArray{};
                } else {
                    fresh->value = TomlTable{};
                }
                table->push_back({segment.key, place, std::move(fresh)});
                member = table->back().node.get();
            }
            node = member;
            path += path.empty() ? segment.key : "." + segment.key;
        }
    }
    *node = std::move(override_.value);
}

} // namespace vesica
