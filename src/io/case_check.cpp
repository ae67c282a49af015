#include "io/case_check.hpp"

#include "io/case_value_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace vesica {
namespace {

std::string child(const std::string& table, const std::string& leaf) {
    return table.empty() ? leaf : table + "." + leaf;
}

bool is_bare_key(const std::string& name) {
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               std::string::npos;
}

/// Walks the tree beside the declared keys and collects what it finds.
class TreeWalk {
public:
    explicit TreeWalk(CaseValues& values) : values_(values) {}

    void table(const TomlTable& members, const SourcePlace& place, const std::string& path,
               const std::string& generic) {
        values_.tables[generic].push_back(path);
        values_.table_places[path] = place;
        for (const TomlMember& member : members)
            walk(member, child(path, member.key), child(generic, member.key));
    }

private:
    void walk(const TomlMember& member, const std::string& path, const std::string& generic) {
        const TomlNode& node = *member.node;
        if (const CaseKey* key = find_case_key(generic)) {
            if (key->kind == KeyKind::choice_or_table && node.table()) {
                CaseValue value;
                value.key = key;
                value.is_table = true;
                value.place = node.place;
                value.shown = "a table";
                values_.values[path] = value;
                table(*node.table(), node.place, path, generic);
            } else {
                values_.values[path] = read_case_value(node, *key, path);
            }
        } else if (generic == "vesicle_type") {
            vesicle_types(node, path);
        } else if (find_case_table(generic)) {
            if (!node.table())
                refuse_as_table(node, path, "a table", "[" + path + "]");
            table(*node.table(), node.place, path, generic);
        } else if (find_case_table(generic + "[]")) {
            elements(node, path, generic + "[]");
        } else {
            throw InputError(member.key_place,
                             fmt::format("{} is not a known key; expected {}; try {}", path,
                                         known_in(generic), concrete(nearest_case_path(generic), path)));
        }
    }

    void vesicle_types(const TomlNode& node, const std::string& path) {
        if (!node.table())
            refuse_as_table(node, path, "a table of vesicle types", "[vesicle_type.rbc]");
        for (const TomlMember& type : *node.table()) {
            const std::string name = child(path, type.key);
            if (!is_bare_key(type.key)) {
                throw InputError(type.key_place,
                                 fmt::format("vesicle_type has the name \"{}\"; expected letters, "
                                             "digits, _ and -; try [vesicle_type.rbc]",
                                             shown_name(type.key)));
            }
            if (!type.node->table()) {
                refuse_as_table(*type.node, name, "a table named after the type", "[vesicle_type.rbc]");
            }
            table(*type.node->table(), type.node->place, name, "vesicle_type.*");
        }
    }

    void elements(const TomlNode& node, const std::string& path, const std::string& generic) {
        if (node.table() && generic != "vesicle[]") { // perturbation = { ... }
            table(*node.table(), node.place, path + "[0]", generic);
            return;
        }
        std::string header = generic;
        for (auto at = header.find("[]"); at != std::string::npos; at = header.find("[]"))
            header.erase(at, 2);
        header = "[[" + header + "]]";
        if (!node.array())
            refuse_as_table(node, path, "an array of tables", header);
        for (std::size_t i = 0; i < node.array()->size(); ++i) {
            const TomlNode& item = (*node.array())[i];
            const std::string name = fmt::format("{}[{}]", path, i);
            if (!item.table())
                refuse_as_table(item, name, "a table", header);
            table(*item.table(), item.place, name, generic);
        }
    }

    [[noreturn]] static void refuse_as_table(const TomlNode& node, const std::string& path,
                                             const std::string& expected, const std::string& header) {
        throw InputError(node.place,
                         fmt::format("{} is {}; expected {}; try {}", path, shown(node), expected, header));
    }

    static std::string shown_name(const std::string& name) {
        const std::string quoted = shown(TomlNode{name, {}});
        return quoted.substr(1, quoted.size() - 2);
    }

    static std::string known_in(const std::string& generic) {
        const auto dot = generic.find_last_of('.');
        const std::string table = dot == std::string::npos ? "" : generic.substr(0, dot);
        std::vector<std::string> names;
        const auto add = [&](const std::string& path) {
            if (path.empty())
                return;
            const auto end = path.find_last_of('.');
            if ((end == std::string::npos ? "" : path.substr(0, end)) != table)
                return;
            std::string leaf = path.substr(end + 1);
            if (leaf.ends_with("[]"))
                leaf.resize(leaf.size() - 2);
            if (leaf != "*" && std::find(names.begin(), names.end(), leaf) == names.end())
                names.push_back(leaf);
        };
        for (const CaseKey& key : case_keys())
            add(key.path);
        for (const CaseTable& known : case_tables())
            add(known.path);
        if (table.empty())
            names.emplace_back("vesicle_type");
        return joined_choices(names, "or", false);
    }

    /// The generic path with the names and indices of the path beside it.
    static std::string concrete(const std::string& generic, const std::string& beside) {
        const auto parts = [](const std::string& path) {
            std::vector<std::string> result(1);
            for (const char c : path) {
                if (c == '.') {
                    result.emplace_back();
                } else {
                    result.back() += c;
                }
            }
            return result;
        };
        const auto from = parts(beside);
        std::string result;
        bool same = true;
        const auto names = parts(generic);
        for (std::size_t i = 0; i < names.size(); ++i) {
            std::string name = names[i];
            const bool last = i + 1 == names.size();
            const std::string stem = name.substr(0, name.find('['));
            if (name == "*") {
                name = same && i < from.size() && !(i + 1 == from.size()) ? from[i] : "NAME";
            } else if (name.ends_with("[]")) {
                const bool match = same && i < from.size() && from[i].substr(0, from[i].find('[')) == stem;
                same = match;
                name = last ? stem : match ? from[i] : stem + "[0]";
            } else {
                same = same && i < from.size() && from[i] == name;
            }
            result = child(result, name);
        }
        return result;
    }

    CaseValues& values_;
};

/// Holds the tables that exist against what their keys demand of each other, and fills in defaults.
class TableCheck {
public:
    explicit TableCheck(CaseValues& values) : values_(values) {}

    void check() {
        for (const CaseTable& table : case_tables()) {
            if (!table.optional && !table.path.empty())
                complete(table.path);
            for (const std::string& path : values_.tables[table.path]) {
                for (const CaseKey& key : case_keys()) {
                    if (key.table() == table.path)
                        check(key, child(path, key.leaf()), path);
                }
                check_groups(table.path, path);
            }
        }
    }

private:
    /// Makes the table exist wherever the one around it does.
    void complete(const std::string& generic) {
        const auto dot = generic.find_last_of('.');
        const std::string around = dot == std::string::npos ? "" : generic.substr(0, dot);
        std::vector<std::string> paths;
        for (const std::string& path : values_.tables[around])
            paths.push_back(child(path, generic.substr(dot + 1)));
        values_.tables[generic] = paths;
    }

    void check(const CaseKey& key, const std::string& path, const std::string& table) {
        const CaseValue* value = values_.find(path);
        std::string sibling_words;
        const bool meaningful = condition_holds(key, table, sibling_words);
        if (value && !meaningful) {
            if (!key.condition.harmless) {
                values_.refuse(path, fmt::format("expected {} only with {} = {}, but {}; try removing it",
                                                 key.leaf(), key.condition.sibling,
                                                 joined_choices(key.condition.values, "or", quoted(key)),
                                                 sibling_words));
            }
            values_.warn(path, "without effect since " + sibling_words + "; try removing it");
        }
        if (value || !meaningful)
            return;
        if (!key.default_value.empty()) {
            const TomlNode document = parse_toml("value = " + key.default_value, "default");
            CaseValue fresh = read_case_value(*document.table()->front().node, key, path);
            fresh.given = false;
            fresh.place = values_.place(path);
            values_.values[path] = fresh;
        } else if (key.need == Need::required) {
            values_.refuse(path, fmt::format("expected {}; try {}", expectation(key), suggestion(key)));
        }
    }

    static bool quoted(const CaseKey& key) { return key.condition.sibling != "l"; }

    bool condition_holds(const CaseKey& key, const std::string& table, std::string& sibling_words) const {
        if (key.condition.sibling.empty())
            return true;
        const std::string path = child(table, key.condition.sibling);
        const CaseValue* sibling = values_.find(path);
        std::string word;
        if (sibling && sibling->key->kind == KeyKind::degree) {
            word = sibling->is_array ? "[lowest, highest]" : "a whole number";
        } else if (sibling && !sibling->is_table) {
            word = std::get<std::string>(sibling->items.front().value);
        }
        sibling_words = fmt::format("{} is {}", path, sibling ? sibling->shown : "missing");
        return std::find(key.condition.values.begin(), key.condition.values.end(), word) !=
               key.condition.values.end();
    }

    void check_groups(const std::string& generic, const std::string& table) {
        std::vector<std::string> done;
        for (const CaseKey& key : case_keys()) {
            if (key.group.empty() || key.table() != generic)
                continue;
            if (std::find(done.begin(), done.end(), key.group) != done.end())
                continue;
            done.push_back(key.group);
            check_group(key, table);
        }
    }

    void check_group(const CaseKey& first, const std::string& table) {
        // Where the viscosity is physical, the relaxation time is the lattice's own and says something else.
        const bool relaxation_is_free = values_.find("units.density") || values_.find("units.reynolds");
        std::vector<std::string> names;
        std::vector<std::string> given;
        for (const CaseKey& key : case_keys()) {
            if (key.group != first.group || key.table() != first.table())
                continue;
            if (relaxation_is_free && key.path == "fluid.relaxation_time")
                continue;
            names.push_back(key.leaf());
            if (values_.find(child(table, key.leaf())))
                given.push_back(child(table, key.leaf()));
        }
        if (given.empty() && first.need == Need::one_of) {
            values_.refuse(child(table, first.leaf()),
                           fmt::format("expected exactly one of {}, to state {}; try {}",
                                       joined_choices(names, "or", false), first.group, suggestion(first)));
        }
        if (given.size() < 2)
            return;
        // Name the one that came last: it is the one somebody has just added.
        std::sort(given.begin(), given.end(), [this](const std::string& a, const std::string& b) {
            const auto rank = [this](const std::string& path) {
                const SourcePlace place = values_.place(path);
                return std::tuple(place.file != values_.file, place.line, place.column);
            };
            return rank(a) < rank(b);
        });
        values_.refuse(given.back(),
                       fmt::format("expected {} to be stated once, but {} is {}; try removing one of them",
                                   first.group, given.front(), values_.find(given.front())->shown));
    }

    CaseValues& values_;
};

/// 6.4 um over 0.2 um is 32.000000000000004 in doubles; a vesicle in the middle of its box must be exactly
/// there for the box's symmetries to hold, so the last two digits of a conversion are given up.
double without_rounding(double lattice) {
    return std::strtod(fmt::format("{:.14g}", lattice).c_str(), nullptr);
}

} // namespace

CaseValues check_case(const TomlNode& root, const std::string& file) {
    CaseValues values;
    values.file = file;
    TreeWalk(values).table(*root.table(), {file, 0, 0}, "", "");
    TableCheck(values).check();
    return values;
}

void convert_to_lattice(CaseValues& values, const std::optional<Scales>& scales) {
    for (auto& [path, value] : values.values) {
        if (value.key->si)
            continue;
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            CaseScalar& item = value.items[i];
            const auto* quantity = std::get_if<Quantity>(&item.value);
            if (!quantity)
                continue;
            if (!scales) {
                throw InputError(item.place,
                                 fmt::format("{} is {}; expected a number in lattice units, since there is "
                                             "no [units]; try adding [units] with cell and time_step",
                                             path, item.shown));
            }
            const double lattice = without_rounding(scales->to_lattice(*quantity));
            check_range(*value.key, value.is_array ? fmt::format("{}[{}]", path, i) : path, item, lattice);
            if (value.key->kind != KeyKind::steps) {
                item.value = lattice;
                continue;
            }
            const auto steps = static_cast<std::int64_t>(std::llround(lattice));
            if (steps == 0 && lattice > 0.0) {
                throw InputError(item.place,
                                 fmt::format("{} is {} ({:.3g} steps); expected at least one step of {}; "
                                             "try a longer time or another [units]",
                                             path, item.shown, lattice,
                                             to_text({scales->step, dimension::time})));
            }
            item.value = steps;
        }
    }
}

} // namespace vesica
