#pragma once

#include "core/quantity.hpp"
#include "core/scales.hpp"
#include "io/case_keys.hpp"
#include "io/toml_tree.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace vesica {

/// One number or word of a value: a Quantity until the scales are known, then a lattice number.
struct CaseScalar {
    std::variant<bool, std::int64_t, double, std::string, Quantity> value;
    SourcePlace place;
    std::string shown; ///< as the user wrote it
};

/// The value of one key, its type checked.
struct CaseValue {
    const CaseKey* key = nullptr;
    std::vector<CaseScalar> items; ///< one, or the elements of an array in order
    bool is_array = false;
    bool is_table = false; ///< a choice_or_table given as a table
    bool given = true;     ///< by the user, not a default
    SourcePlace place;
    std::string shown;
};

/// What the reader has made of the tree: values by full path, and the tables that exist.
struct CaseValues {
    std::map<std::string, CaseValue> values;
    /// Full paths of the tables that exist, by generic path, in the order of the file.
    std::map<std::string, std::vector<std::string>> tables;
    std::map<std::string, SourcePlace> table_places;
    std::vector<std::string> warnings;
    std::string file;

    const CaseValue* find(const std::string& path) const;
    bool given(const std::string& path) const;
    bool has_table(const std::string& generic_path) const;

    /// Where an error about this path points: the value, or the nearest table around it, or the file.
    SourcePlace place(const std::string& path) const;

    // Values that must exist (required, or with a default), of the kind their key declares.
    const std::string& text(const std::string& path) const;
    double number(const std::string& path, std::size_t item = 0) const;
    std::int64_t integer(const std::string& path, std::size_t item = 0) const;
    bool boolean(const std::string& path) const;

    /// Throws `PATH is VALUE; expected ...` at the value's place.
    [[noreturn]] void refuse(const std::string& path, const std::string& advice) const;

    /// Notes `PLACE: PATH is VALUE; ADVICE` for check.
    void warn(const std::string& path, const std::string& advice);
};

} // namespace vesica
