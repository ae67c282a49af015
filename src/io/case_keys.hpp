#pragma once

#include "core/quantity.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// The keys of a case file, declared once: read by the reader, the checks, the suggestions and the reference
/// page.
///
/// Paths here are generic: `vesicle_type.*` stands for every name, `vesicle[]` for every element.
namespace vesica {

enum class KeyKind {
    text,
    choice,          ///< text, one of `choices`
    choice_or_table, ///< one of `choices`, or a table of its own keys
    names,           ///< array of texts, each one of `choices`, none twice
    boolean,
    integer,
    steps,     ///< a whole number of steps, or a time
    number,    ///< of the key's dimension
    cells,     ///< three whole numbers
    point,     ///< three numbers of the key's dimension
    direction, ///< three numbers, not all zero
    degree,    ///< one whole number, or [lowest, highest]
    region,    ///< [[x, y, z], [x, y, z]]: first cell, and one past the last
};

enum class Need {
    optional,
    required,    ///< whenever its table is there
    one_of,      ///< exactly one key of the group
    at_most_one, ///< of the group
};

struct KeyRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;

    bool contains(double value) const {
        return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
    }
};

/// The key has a meaning only where its sibling has one of these values.
struct KeyCondition {
    std::string sibling;             ///< leaf name in the same table; empty: always
    std::vector<std::string> values; ///< of a degree: "a whole number", "[lowest, highest]"
    bool harmless = false;           ///< given without a meaning: a warning instead of an error
};

struct CaseKey {
    std::string path;
    KeyKind kind = KeyKind::text;
    std::string meaning;
    std::string example{};       ///< TOML; empty: the default
    std::string default_value{}; ///< TOML; empty: none
    Need need = Need::optional;
    std::string group{}; ///< what the keys of a group say ("the viscosity")
    Dimension dimension{};
    bool si = false; ///< only with a unit, and stays in SI
    KeyRange range{};
    std::string reason{}; ///< why the range ends where it does
    std::vector<std::string> choices{};
    KeyCondition condition{};

    std::string table() const; ///< the path without the last name; empty at the top
    std::string leaf() const;
};

struct CaseTable {
    std::string path;
    bool optional = false; ///< absent means absent, not all defaults
    std::string meaning;
};

const std::vector<CaseKey>& case_keys();
const std::vector<CaseTable>& case_tables();

const CaseKey* find_case_key(std::string_view generic_path);
const CaseTable* find_case_table(std::string_view generic_path);

/// The known path nearest to an unknown one: within its table if a name there is close, else anywhere.
std::string nearest_case_path(std::string_view unknown_generic_path);

/// The word nearest to another one, by edits.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "a length above 0", "\"mrt\" or \"bgk\"": the words after `expected`.
std::string expectation(const CaseKey& key);

/// "a length", "an energy".
std::string with_article(const std::string& noun);

/// "above 0 and at most 1"; empty without limits.
std::string range_text(const CaseKey& key);

/// `radius = 15`: the words after `try`; with a unit where that is wanted.
std::string suggestion(const CaseKey& key, bool with_unit = false);

/// `"a", "b" or a table`.
std::string choices_or_table(const CaseKey& key);

/// "a, b or c".
std::string joined_choices(const std::vector<std::string>& words, std::string_view last_word, bool quoted);

} // namespace vesica
