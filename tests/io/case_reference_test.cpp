#include "case_file_samples.hpp"
#include "io/case_keys.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace vesica;

namespace {

const std::filesystem::path page_file = std::filesystem::path(VESICA_SOURCE_DIR) / "docs" / "case-file.md";

} // namespace

TEST_CASE("the committed reference page is what the declared keys say") {
    std::ifstream stream(page_file);
    std::ostringstream page;
    page << stream.rdbuf();
    INFO("docs/case-file.md is out of date: run the test program test_io with the argument [.regenerate]");
    CHECK((page.str() == case_file_reference()));
}

TEST_CASE("write docs/case-file.md and cases/*.toml anew", "[.regenerate]") {
    std::ofstream(page_file) << case_file_reference();
    for (const CaseTemplate& item : case_templates()) {
        std::ofstream(std::filesystem::path(VESICA_SOURCE_DIR) / "cases" / (std::string(item.name) + ".toml"))
            << item.text;
    }
}

TEST_CASE("every key is declared once, in a declared table, and has a row on the page") {
    const std::string page = case_file_reference();
    std::set<std::string> paths;
    for (const CaseKey& key : case_keys()) {
        INFO(key.path);
        CHECK(paths.insert(key.path).second);
        CHECK(find_case_table(key.table()) != nullptr);
        CHECK(page.find("| `" + key.leaf() + "` |") != std::string::npos);
        CHECK_FALSE(key.meaning.empty());
        CHECK((key.example.empty() != key.default_value.empty() || key.kind == KeyKind::text));
        if (!key.condition.sibling.empty()) {
            const std::string table = key.table().empty() ? "" : key.table() + ".";
            CHECK(find_case_key(table + key.condition.sibling) != nullptr);
        }
    }
}

TEST_CASE("the nearest known path is the one that was meant") {
    CHECK(nearest_case_path("fluid.kinematic_viscocity") == "fluid.kinematic_viscosity");
    CHECK(nearest_case_path("fluid.visocsity") == "fluid.density");
    CHECK(nearest_case_path("viscosity_ratio") == "vesicle_type.*.viscosity_ratio");
    CHECK(nearest_case_path("vesicle[].raduis") == "vesicle[].radius");
    CHECK(nearest_case_path("vesicle[].reduced_volum") == "vesicle[].reduced_volume");
    CHECK(nearest_case_path("vesicle[].pert") == "vesicle[].perturbation[]");
    CHECK(nearest_case_path("vesicles") == "vesicle[]");
    CHECK(nearest_case_path("output.checkpoints") == "output.checkpoint");
    CHECK(nearest_case_path("run.walltime") == "run.wall_time");
    CHECK_FALSE(nearest_case_path("").empty());
    CHECK_FALSE(nearest_case_path(std::string(10000, 'x')).empty());
}
