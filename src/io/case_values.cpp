#include "io/case_values.hpp"

#include <fmt/format.h>

#include <cassert>

namespace vesica {

const CaseValue* CaseValues::find(const std::string& path) const {
    const auto found = values.find(path);
    return found == values.end() ? nullptr : &found->second;
}

bool CaseValues::given(const std::string& path) const {
    const CaseValue* value = find(path);
    return value && value->given;
}

bool CaseValues::has_table(const std::string& generic_path) const {
    const auto found = tables.find(generic_path);
    return found != tables.end() && !found->second.empty();
}

SourcePlace CaseValues::place(const std::string& path) const {
    if (const CaseValue* value = find(path); value && value->given)
        return value->place;
    for (std::string around = path; !around.empty();) {
        if (const auto found = table_places.find(around); found != table_places.end())
            return found->second;
        const auto end = around.find_last_of(".[");
        around.resize(end == std::string::npos ? 0 : end);
    }
    return {file, 0, 0};
}

const std::string& CaseValues::text(const std::string& path) const {
    const CaseValue* value = find(path);
    assert(value && !value->items.empty());
    return std::get<std::string>(value->items.front().value);
}

double CaseValues::number(const std::string& path, std::size_t item) const {
    const CaseValue* value = find(path);
    assert(value && item < value->items.size());
    const auto& scalar = value->items[item].value;
    if (const auto* integer = std::get_if<std::int64_t>(&scalar))
        return static_cast<double>(*integer);
    return std::get<double>(scalar);
}

std::int64_t CaseValues::integer(const std::string& path, std::size_t item) const {
    const CaseValue* value = find(path);
    assert(value && item < value->items.size());
    return std::get<std::int64_t>(value->items[item].value);
}

bool CaseValues::boolean(const std::string& path) const {
    const CaseValue* value = find(path);
    assert(value && !value->items.empty());
    return std::get<bool>(value->items.front().value);
}

void CaseValues::refuse(const std::string& path, const std::string& advice) const {
    const CaseValue* value = find(path);
    const std::string found = value ? value->shown : table_places.contains(path) ? "there" : "missing";
    throw InputError(place(path), fmt::format("{} is {}; {}", path, found, advice));
}

void CaseValues::warn(const std::string& path, const std::string& advice) {
    const CaseValue* value = find(path);
    warnings.emplace_back(
        InputError(place(path), fmt::format("{} is {}; {}", path, value ? value->shown : "missing", advice))
            .what());
}

} // namespace vesica
