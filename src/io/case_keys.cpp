#include "io/case_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesica {
namespace {

std::string_view leaf_of(std::string_view path) {
    return path.substr(path.find_last_of('.') + 1); // npos + 1 == 0
}

std::string_view table_of(std::string_view path) {
    const auto dot = path.find_last_of('.');
    return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

/// Edits (insert, delete, replace, swap of neighbours) that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    a = a.substr(0, 64);
    b = b.substr(0, 64);
    std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = last;
        last = now;
    }
    return last[b.size()];
}

std::string words_with_range(const CaseKey& key, std::string_view element) {
    const std::string range = range_text(key);
    return fmt::format("{}{}{}", element, range.empty() ? "" : " ", range);
}

} // namespace

std::string CaseKey::table() const {
    return std::string(table_of(path));
}

std::string CaseKey::leaf() const {
    return std::string(leaf_of(path));
}

const CaseKey* find_case_key(std::string_view generic_path) {
    for (const CaseKey& key : case_keys()) {
        if (key.path == generic_path)
            return &key;
    }
    return nullptr;
}

const CaseTable* find_case_table(std::string_view generic_path) {
    for (const CaseTable& table : case_tables()) {
        if (table.path == generic_path)
            return &table;
    }
    return nullptr;
}

std::string nearest_case_path(std::string_view unknown) {
    std::vector<std::string> known;
    for (const CaseKey& key : case_keys())
        known.push_back(key.path);
    for (const CaseTable& table : case_tables()) {
        if (!table.path.empty())
            known.push_back(table.path);
    }
    const std::string_view name = leaf_of(unknown);
    const auto distance_to = [&](std::string_view leaf) {
        if (leaf.ends_with("[]"))
            leaf.remove_suffix(2);
        // "rad" is an abbreviation of "radius" rather than a misspelt "run".
        const bool abbreviation = name.size() >= 3 && leaf != name && leaf.starts_with(name);
        return abbreviation ? 1 : edit_distance(leaf, name);
    };
    const auto common_tables = [&](std::string_view path) {
        std::size_t dots = 0;
        for (std::size_t i = 0; i < std::min(path.size(), unknown.size()) && path[i] == unknown[i]; ++i)
            dots += path[i] == '.' ? 1U : 0U;
        return dots;
    };
    struct Match {
        std::size_t distance = std::string::npos;
        std::size_t common = 0;
        std::string path{};
    };
    Match sibling, anywhere;
    const auto improve = [](Match& best, const Match& match) {
        if (match.distance < best.distance || (match.distance == best.distance && match.common > best.common))
            best = match;
    };
    for (const std::string& path : known) {
        if (leaf_of(path) == "*")
            continue;
        const Match match{distance_to(leaf_of(path)), common_tables(path), path};
        improve(anywhere, match);
        if (table_of(path) == table_of(unknown))
            improve(sibling, match);
    }
    if (sibling.path.empty())
        return anywhere.path;
    // A name that exists elsewhere was more likely misplaced than misspelt beyond recognition.
    const bool recognised = sibling.distance <= std::max<std::size_t>(2, name.size() / 3);
    return recognised || anywhere.distance > 1 ? sibling.path : anywhere.path;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
    std::pair<std::size_t, std::string> best{std::string::npos, ""};
    for (const std::string& candidate : candidates)
        best = std::min(best, {edit_distance(word, candidate), candidate});
    return best.second;
}

std::string joined_choices(const std::vector<std::string>& words, std::string_view last_word, bool quoted) {
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0)
            result += i + 1 == words.size() ? fmt::format(" {} ", last_word) : ", ";
        result += quoted ? fmt::format("\"{}\"", words[i]) : words[i];
    }
    return result;
}

std::string with_article(const std::string& noun) {
    const bool vowel =
        !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
    return (vowel ? "an " : "a ") + noun;
}

std::string range_text(const CaseKey& key) {
    const KeyRange& range = key.range;
    std::string result;
    if (std::isfinite(range.low))
        result = fmt::format("{} {:g}", range.low_open ? "above" : "at least", range.low);
    if (std::isfinite(range.high)) {
        if (!result.empty())
            result += " and ";
        result += fmt::format("{} {:g}", range.high_open ? "below" : "at most", range.high);
    }
    return result;
}

std::string choices_or_table(const CaseKey& key) {
    std::string text;
    for (const std::string& choice : key.choices)
        text += (text.empty() ? "\"" : ", \"") + choice + "\"";
    return text + " or a table";
}

std::string expectation(const CaseKey& key) {
    const std::string unit = key.dimension == dimension::none ? "" : " of " + dimension_name(key.dimension);
    std::string text;
    switch (key.kind) {
    case KeyKind::text:
        text = "text";
        break;
    case KeyKind::choice:
        text = joined_choices(key.choices, "or", true);
        break;
    case KeyKind::choice_or_table:
        text = choices_or_table(key);
        break;
    case KeyKind::names:
        text = "an array of " + joined_choices(key.choices, "and", true);
        break;
    case KeyKind::boolean:
        text = "true or false";
        break;
    case KeyKind::integer:
        text = words_with_range(key, "a whole number");
        break;
    case KeyKind::steps:
        text = words_with_range(key, "a whole number of steps, or a time,");
        break;
    case KeyKind::number:
        text = words_with_range(
            key, key.dimension == dimension::none ? "a number" : with_article(dimension_name(key.dimension)));
        if (key.si)
            text += " with its unit";
        break;
    case KeyKind::cells:
        text = words_with_range(key, "three whole numbers");
        break;
    case KeyKind::point:
        text = words_with_range(key, "three numbers" + unit);
        break;
    case KeyKind::direction:
        text = "three numbers, not all zero";
        break;
    case KeyKind::degree:
        text = words_with_range(key, "a whole number or [lowest, highest],");
        break;
    case KeyKind::region:
        text = "two corners [[x, y, z], [x, y, z]] in whole cells";
        break;
    }
    return key.reason.empty() ? text : text + ", " + key.reason;
}

std::string suggestion(const CaseKey& key, bool with_unit) {
    if (with_unit)
        return fmt::format("{} = \"{}\"", key.leaf(), example_quantity(key.dimension));
    return fmt::format("{} = {}", key.leaf(), key.example.empty() ? key.default_value : key.example);
}

} // namespace vesica
