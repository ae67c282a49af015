#include "io/case_value_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesica {
namespace {

constexpr double largest_whole_double = 9007199254740992.0; // 2^53

/// Reads the elements of one value; knows its key and path for the messages.
class ValueReader {
public:
    ValueReader(const CaseKey& key, const std::string& path, const TomlNode& node)
        : key_(key), path_(path), node_(node) {}

    CaseValue read() {
        CaseValue result;
        result.key = &key_;
        result.place = node_.place;
        result.shown = shown(node_);
        result.is_array = node_.array() != nullptr;
        switch (key_.kind) {
        case KeyKind::text:
            result.items.push_back(text(node_, path_));
            break;
        case KeyKind::choice:
        case KeyKind::choice_or_table:
            result.items.push_back(choice(node_, path_));
            break;
        case KeyKind::names:
            result.items = names();
            break;
        case KeyKind::boolean:
            result.items.push_back(boolean());
            break;
        case KeyKind::integer:
            result.items.push_back(whole(node_, path_));
            break;
        case KeyKind::steps:
            result.items.push_back(std::holds_alternative<std::string>(node_.value) ? quantity(node_, path_)
                                                                                    : whole(node_, path_));
            break;
        case KeyKind::number:
            result.items.push_back(number(node_, path_));
            break;
        case KeyKind::cells:
            result.items = array(3, &ValueReader::whole);
            break;
        case KeyKind::point:
            result.items = array(3, &ValueReader::number);
            break;
        case KeyKind::direction:
            result.items = direction();
            break;
        case KeyKind::degree:
            result.items = degree();
            break;
        case KeyKind::region:
            result.items = region();
            break;
        }
        return result;
    }

private:
    [[noreturn]] void refuse(const TomlNode& node, const std::string& path,
                             const std::string& expected = {}) const {
        throw InputError(node.place,
                         fmt::format("{} is {}; expected {}; try {}", path, shown(node),
                                     expected.empty() ? expectation(key_) : expected, suggestion(key_)));
    }

    std::string element(std::size_t index) const { return fmt::format("{}[{}]", path_, index); }

    CaseScalar text(const TomlNode& node, const std::string& path) const {
        const auto* word = std::get_if<std::string>(&node.value);
        if (!word)
            refuse(node, path);
        return {*word, node.place, shown(node)};
    }

    CaseScalar choice(const TomlNode& node, const std::string& path) const {
        CaseScalar result = text(node, path);
        const auto& word = std::get<std::string>(result.value);
        if (std::find(key_.choices.begin(), key_.choices.end(), word) == key_.choices.end()) {
            throw InputError(node.place, fmt::format("{} is {}; expected {}; try {}\"{}\"", path, shown(node),
                                                     expectation(key_),
                                                     key_.kind == KeyKind::names ? "" : key_.leaf() + " = ",
                                                     nearest_word(word, key_.choices)));
        }
        return result;
    }

    CaseScalar boolean() const {
        if (const auto* value = std::get_if<bool>(&node_.value))
            return {*value, node_.place, shown(node_)};
        refuse(node_, path_);
    }

    CaseScalar whole(const TomlNode& node, const std::string& path) const {
        CaseScalar result{std::int64_t{0}, node.place, shown(node)};
        if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
            result.value = *integer;
        } else if (const auto* real = std::get_if<double>(&node.value); // 1e6 is how many write a million
                   real && std::abs(*real) < largest_whole_double && std::floor(*real) == *real) {
            result.value = static_cast<std::int64_t>(*real);
        } else {
            refuse(node, path);
        }
        check_range(key_, path, result, static_cast<double>(std::get<std::int64_t>(result.value)));
        return result;
    }

    CaseScalar number(const TomlNode& node, const std::string& path) const {
        if (std::holds_alternative<std::string>(node.value)) {
            if (key_.dimension == dimension::none)
                refuse(node, path);
            return quantity(node, path);
        }
        CaseScalar result{0.0, node.place, shown(node)};
        if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
            result.value = static_cast<double>(*integer);
        } else if (const auto* real = std::get_if<double>(&node.value); real && std::isfinite(*real)) {
            result.value = *real;
        } else {
            refuse(node, path);
        }
        if (key_.si)
            refuse(node, path);
        check_range(key_, path, result, std::get<double>(result.value));
        return result;
    }

    CaseScalar quantity(const TomlNode& node, const std::string& path) const {
        Quantity value;
        try {
            value = parse_quantity(std::get<std::string>(node.value));
        } catch (const QuantityError& error) {
            std::string advice = error.advice();
            if (advice.starts_with("expected a number and its unit")) {
                advice = fmt::format("expected {}{} as text with a unit; try {}",
                                     with_article(dimension_name(key_.dimension)),
                                     key_.si ? "" : " as a number without quotes or",
                                     suggestion(key_, !key_.si && key_.kind != KeyKind::point));
            }
            throw InputError(node.place, fmt::format("{} is {}; {}", path, shown(node), advice));
        }
        if (value.dimension != key_.dimension) {
            throw InputError(node.place,
                             fmt::format("{} is {}, {}; expected {}; try {}", path, shown(node),
                                         with_article(dimension_name(value.dimension)),
                                         with_article(dimension_name(key_.dimension)),
                                         suggestion(key_, !key_.si && key_.kind != KeyKind::point)));
        }
        const CaseScalar result{value, node.place, shown(node)};
        if (key_.si)
            check_range(key_, path, result, value.value);
        return result;
    }

    std::vector<CaseScalar> array(std::size_t size,
                                  CaseScalar (ValueReader::*element_of)(const TomlNode&, const std::string&)
                                      const) const {
        const TomlArray* items = node_.array();
        if (!items || items->size() != size)
            refuse(node_, path_);
        std::vector<CaseScalar> result;
        for (std::size_t i = 0; i < size; ++i)
            result.push_back((this->*element_of)((*items)[i], element(i)));
        return result;
    }

    std::vector<CaseScalar> direction() const {
        std::vector<CaseScalar> result = array(3, &ValueReader::number);
        double square = 0.0;
        for (const CaseScalar& item : result) {
            const double component = std::get<double>(item.value);
            square += component * component;
        }
        if (!(square > 1e-200 && square < 1e200))
            refuse(node_, path_);
        return result;
    }

    std::vector<CaseScalar> degree() const {
        if (!node_.array())
            return {whole(node_, path_)};
        std::vector<CaseScalar> result = array(2, &ValueReader::whole);
        if (std::get<std::int64_t>(result[0].value) > std::get<std::int64_t>(result[1].value))
            refuse(node_, path_);
        return result;
    }

    std::vector<CaseScalar> region() const {
        const TomlArray* corners = node_.array();
        if (!corners || corners->size() != 2)
            refuse(node_, path_);
        std::vector<CaseScalar> result;
        for (const TomlNode& corner : *corners) {
            if (!corner.array() || corner.array()->size() != 3)
                refuse(node_, path_);
            for (const TomlNode& item : *corner.array())
                result.push_back(whole(item, path_));
        }
        return result;
    }

    std::vector<CaseScalar> names() const {
        const TomlArray* items = node_.array();
        if (!items || items->empty())
            refuse(node_, path_);
        std::vector<CaseScalar> result;
        for (std::size_t i = 0; i < items->size(); ++i) {
            CaseScalar item = choice((*items)[i], element(i));
            for (const CaseScalar& earlier : result) {
                if (earlier.value == item.value)
                    refuse((*items)[i], element(i), "every name once");
            }
            result.push_back(std::move(item));
        }
        return result;
    }

    const CaseKey& key_;
    const std::string& path_;
    const TomlNode& node_;
};

} // namespace

CaseValue read_case_value(const TomlNode& node, const CaseKey& key, const std::string& path) {
    return ValueReader(key, path, node).read();
}

void check_range(const CaseKey& key, const std::string& path, const CaseScalar& scalar, double lattice) {
    if (key.range.contains(lattice))
        return; // never true for NaN
    const bool converted = std::holds_alternative<Quantity>(scalar.value) && !key.si;
    throw InputError(scalar.place,
                     fmt::format("{} is {}{}; expected {}{}; try {}", path, scalar.shown,
                                 converted ? fmt::format(" ({:.6g} in lattice units)", lattice) : "",
                                 expectation(key), converted ? " in lattice units" : "",
                                 converted ? "other [units]" : suggestion(key)));
}

} // namespace vesica
