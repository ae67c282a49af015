#pragma once

#include "io/case_file.hpp"
#include "io/case_templates.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace vesica {

inline std::string discocyte_text() {
    return std::string(case_templates().front().text);
}

/// The discocyte's text with the first occurrence of `from` replaced.
inline std::string changed(const std::string& from, const std::string& to) {
    std::string text = discocyte_text();
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// What the reader says of the text: its message, or "accepted".
inline std::string verdict(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        read_case_text(text, "case.toml", overrides);
        return "accepted";
    } catch (const InputError& error) {
        return error.what();
    }
}

struct MessageRow {
    std::string from;
    std::string to;
    std::string message;
};

inline void check_messages(const std::vector<MessageRow>& rows) {
    for (const MessageRow& row : rows)
        CHECK(verdict(changed(row.from, row.to)) == row.message);
}

} // namespace vesica
