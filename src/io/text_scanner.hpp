#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace vesica {

/// Words of a text and the lines they stand in.
class TextScanner {
public:
    explicit TextScanner(std::string_view text, int line = 1) : text_(text), line_(line) {}

    /// The next word, empty at the end.
    std::string_view word() {
        skip_space();
        std::size_t end = at_;
        while (end < text_.size() && !is_space(text_[end]))
            ++end;
        const std::string_view found = text_.substr(at_, end - at_);
        at_ = end;
        return found;
    }

    /// The next word as a number; nothing if it is none.
    std::optional<double> number() {
        last_word_ = word();
        std::string_view digits = last_word_;
        if (digits.starts_with('+'))
            digits.remove_prefix(1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size())
            return std::nullopt;
        return value;
    }

    /// The rest of the line, which is skipped.
    std::string_view rest_of_line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view found = text_.substr(at_, end - at_);
        at_ = end;
        return found;
    }

    std::string_view last_word() const { return last_word_; }
    int line() const { return line_; }
    std::size_t position() const { return at_; }

private:
    static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    void skip_space() {
        for (; at_ < text_.size() && is_space(text_[at_]); ++at_)
            if (text_[at_] == '\n')
                ++line_;
    }

    std::string_view text_;
    std::string_view last_word_;
    std::size_t at_ = 0;
    int line_;
};

} // namespace vesica
