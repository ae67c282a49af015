#include "case_file_samples.hpp"

#include <catch2/catch.hpp>

#include <random>
#include <string>
#include <vector>

using namespace vesica;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
        lines.back() += c;
        if (c == '\n')
            lines.emplace_back();
    }
    return lines;
}

std::string mutated(const std::string& text, std::mt19937_64& random) {
    const auto below = [&](std::size_t bound) {
        return static_cast<std::size_t>(random() % bound);
    };
    std::string result = text;
    switch (below(5)) {
    case 0: // flip some bits
        for (std::size_t i = 0; i <= below(4); ++i)
            result[below(result.size())] ^= static_cast<char>(1U << below(8));
        return result;
    case 1: // cut short
        return result.substr(0, below(result.size()));
    case 2: // another byte, among those that mean something to TOML
        result[below(result.size())] = "[]{}=\"'.,#\n-+0e_"[below(16)];
        return result;
    default: { // delete, double or move a line
        auto lines = lines_of(text);
        const std::size_t at = below(lines.size());
        const std::string line = lines[at];
        const auto iterator = [&](std::size_t i) {
            return lines.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (below(2) == 0)
            lines.erase(iterator(at));
        if (below(2) == 0)
            lines.insert(iterator(below(lines.size() + 1)), line);
        result.clear();
        for (const std::string& each : lines)
            result += each;
        return result;
    }
    }
}

} // namespace

TEST_CASE("a damaged case is either a case or refused at a place, never anything else") {
    std::mt19937_64 random(20240611);
    int accepted = 0, refused = 0;
    for (const std::size_t which : {std::size_t{0}, std::size_t{4}}) { // in lattice units, in SI
        const std::string text(case_templates()[which].text);
        for (int i = 0; i < 2000; ++i) {
            std::string damaged = mutated(text, random);
            if (i % 3 == 0)
                damaged = mutated(damaged.empty() ? text : damaged, random);
            try {
                const Case sample = read_case_text(damaged, "case.toml");
                const Case again = read_case_text(resolved_toml(sample), "resolved.toml");
                INFO(damaged);
                CHECK(again.parameters == sample.parameters);
                ++accepted;
            } catch (const InputError& error) {
                const std::string message = error.what();
                INFO(message);
                CHECK(message.starts_with("case.toml:"));
                ++refused;
            }
        }
    }
    CHECK(accepted > 400);
    CHECK(refused > 400);
}

TEST_CASE("a damaged override is either applied or refused by its name") {
    std::mt19937_64 random(7);
    const std::vector<std::string> samples{"vesicle[0].perturbation[0].amplitude=0.02",
                                           "run.wall_time=\"3 h\"", "output.fields.names=[phase, force]",
                                           "fluid.collision.ghost_rates={ even = 1.0, odd = 1.0 }"};
    for (int i = 0; i < 2000; ++i) {
        const std::string damaged = mutated(samples[random() % samples.size()], random);
        const std::string message = verdict(discocyte_text(), {damaged});
        INFO(damaged << " -> " << message);
        CHECK((message == "accepted" || message.starts_with("--set ") || message.starts_with("case.toml:")));
    }
}
