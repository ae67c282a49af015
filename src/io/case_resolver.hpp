#pragma once

#include "case/case.hpp"
#include "io/case_keys.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstdint>
#include <string>
#include <utility>

/// Parts of resolved.toml's writer.
namespace vesica::detail {

inline std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (code < 0x20 || code == 0x7f) {
            result += fmt::format("\\u{:04x}", code);
        } else {
            result += c;
        }
    }
    return result + '"';
}

/// The shortest text that reads back as the same double, and as a float of TOML.
inline std::string number_text(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// Writes keys line by line, each with its SI value and whether it is a default.
class Resolver {
public:
    explicit Resolver(const Case& resolved) : case_(resolved) {}

    void header(const std::string& text, const std::string& path) {
        if (!text_.empty())
            text_ += "\n";
        text_ += text + "\n";
        path_ = path;
        generic_ = path;
        if (path.starts_with("vesicle_type."))
            generic_ = "vesicle_type.*";
        for (auto open = generic_.find('['); open != std::string::npos; open = generic_.find('[', open + 1))
            generic_.erase(open + 1, generic_.find(']', open) - open - 1);
    }

    void text(const std::string& key, const std::string& value) { line(key, quoted(value), ""); }

    void number(const std::string& key, double value) {
        const Dimension dimension = dimension_of(key);
        line(key, number_text(value), in_si(value, dimension));
    }

    void steps(const std::string& key, std::int64_t value) {
        line(key, fmt::format("{}", value), in_si(static_cast<double>(value), dimension::time));
    }

    void whole(const std::string& key, std::int64_t value) { line(key, fmt::format("{}", value), ""); }

    void raw(const std::string& key, const std::string& value, const std::string& comment = {}) {
        line(key, value, comment);
    }

    void point(const std::string& key, const Vec3<double>& value) {
        const Dimension dimension = dimension_of(key);
        std::string comment;
        if (case_.scales && dimension != dimension::none)
            comment = fmt::format("[{}, {}, {}]", in_si(value.x, dimension), in_si(value.y, dimension),
                                  in_si(value.z, dimension));
        line(key,
             fmt::format("[{}, {}, {}]", number_text(value.x), number_text(value.y), number_text(value.z)),
             comment);
    }

    std::string finish() { return std::move(text_); }

private:
    Dimension dimension_of(const std::string& key) const {
        const CaseKey* known = find_case_key(generic_.empty() ? key : generic_ + "." + key);
        assert(known);
        return known ? known->dimension : dimension::none;
    }

    std::string in_si(double lattice, const Dimension& dimension) const {
        if (!case_.scales || dimension == dimension::none)
            return {};
        return to_text(case_.scales->to_si(lattice, dimension));
    }

    void line(const std::string& key, const std::string& value, std::string comment) {
        const std::string path = path_.empty() ? key : path_ + "." + key;
        const CaseKey* known = find_case_key(generic_.empty() ? key : generic_ + "." + key);
        if (known && !known->default_value.empty() && !case_.places.contains(path))
            comment += comment.empty() ? "default" : ", default";
        const std::string statement = fmt::format("{} = {}", key, value);
        text_ += comment.empty() ? statement + "\n" : fmt::format("{:<40} # {}\n", statement, comment);
    }

    const Case& case_;
    std::string text_;
    std::string path_;
    std::string generic_;
};

/// The tables [boundary] and [flow].
void write_boundary(Resolver& out, const Parameters& parameters);
void write_flow(Resolver& out, const FlowParameters& flow);
void write_obstacles(Resolver& out, const ObstacleParameters& obstacles);

} // namespace vesica::detail
