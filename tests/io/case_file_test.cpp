#include "case_file_samples.hpp"
#include "io/case_file.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace vesica;

namespace {

const std::filesystem::path source_dir = VESICA_SOURCE_DIR;

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

Case reading(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return read_case_text(text, "case.toml", overrides);
}

/// A folder that is gone at the end of the test.
struct ScratchFolder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "vesica-case-file-test";
    ScratchFolder() {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~ScratchFolder() { std::filesystem::remove_all(path); }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
        return path / name;
    }
};

std::string file_verdict(const std::filesystem::path& file) {
    try {
        read_case(file);
        return "accepted";
    } catch (const InputError& error) {
        std::string message = error.what();
        if (message.starts_with(file.string()))
            message.replace(0, file.string().size(), "FILE");
        return message;
    }
}

} // namespace

TEST_CASE("the discocyte's file gives the parameters it states") {
    const Case sample = read_case(source_dir / "cases" / "discocyte.toml");
    CHECK(sample.title == "A discocyte from a deflated sphere");
    CHECK(sample.warnings.empty());
    CHECK_FALSE(sample.scales);

    Parameters expected;
    expected.size = {64, 64, 64};
    expected.fluid = {0.1666667, 1.0, 0.67, RegularisedGhosts{}};
    VesicleType type;
    type.name = "rbc";
    type.viscosity_ratio = 1.0;
    type.bending = {0.25, HelfrichBending{0.0}};
    type.area = {MultiplierConstraint{}, 1.31, 12000};
    type.sigma = 1e-5;
    expected.types = {type};
    VesicleParameters vesicle;
    vesicle.centre = {32, 32, 32};
    vesicle.radius = 15;
    vesicle.axis = {0, 0, 1};
    vesicle.perturbations = {HarmonicPerturbation{2, 0, -0.01}};
    expected.vesicles = {vesicle};
    expected.numerics = {GeometryRecipe::mapped, 1e-2, Precision::double_precision};
    CHECK(sample.parameters == expected);

    CHECK(sample.run == RunParameters{40000, SteadyCriterion{"bending_energy", 1e-7, 2000}, 7200.0});
    OutputParameters output;
    output.metrics_every = 200;
    output.fields = FieldOutput{
        10000,     {"phase", "velocity", "pressure", "force", "mean_curvature", "gaussian_curvature"},
        {0, 0, 0}, {64, 64, 64},
        1,         false};
    output.surfaces_every = 2000;
    output.checkpoint_every = 10000;
    output.checkpoint_keep = 2;
    CHECK(sample.output == output);

    CHECK(sample.source_text == contents(source_dir / "cases" / "discocyte.toml"));
    CHECK(sample.place("vesicle[0].radius").line == 32);
    CHECK(sample.place("vesicle[0].radius").column == 10);
}

TEST_CASE("every alternative way of stating a thing states the same thing") {
    const Parameters original = reading(discocyte_text()).parameters;
    const auto fluid = [&](const std::string& line) {
        return reading(changed("kinematic_viscosity = 0.1666667 ", line + "\n#"))
            .parameters.fluid.kinematic_viscosity;
    };
    CHECK(fluid("relaxation_time = 1.1") == Approx(0.2).epsilon(1e-15));

    CHECK(reading(changed("modulus = 0.25", "paper_modulus = 1.0")).parameters == original);
    const auto deflation =
        reading(changed("deflation = 1.31", "reduced_volume = 0.5")).parameters.types[0].area.deflation;
    CHECK(deflation.value() == Approx(std::pow(2.0, 2.0 / 3.0)).epsilon(1e-15)); // Upsilon = v^(-2/3)
    CHECK(reading(changed("steps = 40000", "time = 40000")).run.steps == 40000);
    CHECK(reading(changed("steps = 40000", "steps = 4e4")).run.steps == 40000);
    CHECK(reading(changed("device = \"cpu\"", "device = \"auto\"")).parameters == original);
    std::string text = discocyte_text();
    const auto begin = text.find("[[vesicle.perturbation]]");
    const auto end = text.find("[numerics]");
    text.replace(begin, end - begin, "perturbation = { l = 2, amplitude = -0.01 }\n");
    CHECK(reading(text).parameters == original);
}

TEST_CASE("every model of the collision can be stated") {
    const auto ghosts = [](const std::string& basis, const std::string& rates) {
        std::string text = changed("basis = \"symmetric\"", "basis = \"" + basis + "\"");
        const std::string old = "ghost_rates = \"regularised\"";
        text.replace(text.find(old), old.size(), "ghost_rates = " + rates);
        return reading(text).parameters.fluid.ghosts;
    };
    CHECK(ghosts("symmetric", "\"regularised\"") == GhostRates{RegularisedGhosts{}});
    CHECK(ghosts("symmetric", "\"trt\"") == GhostRates{TrtGhosts{0.1875}});
    CHECK(ghosts("symmetric", "\"trt\"\nmagic = 0.25") == GhostRates{TrtGhosts{0.25}});
    CHECK(ghosts("paper", "\"trt\"\nmagic = 0.25") == GhostRates{TrtGhosts{0.25}});
    CHECK(ghosts("symmetric", "{ even = 1.1, odd = 1.9 }") ==
          GhostRates{SymmetricGhosts{1.1, 1.1, 1.9, 1.9}});
    CHECK(
        ghosts("symmetric", "{ even_scalar = 1.1, even_tensor = 1.2, odd_vector = 1.3, odd_twist = 1.4 }") ==
        GhostRates{SymmetricGhosts{1.1, 1.2, 1.3, 1.4}});
    CHECK(ghosts("paper", "{ l10 = 1.1, l11 = 1.2, l14 = 1.3, l17 = 1.4 }") ==
          GhostRates{PaperGhosts{1.1, 1.2, 1.3, 1.4}});
    CHECK(reading(changed("model = \"mrt\"", "model = \"bgk\"")).parameters.fluid.ghosts ==
          GhostRates{BgkGhosts{}});
}

TEST_CASE("every shape, constraint, form and perturbation can be stated") {
    const auto shape = [](const std::string& words) {
        return reading(changed("shape = \"sphere\" ", "shape = " + words + "\n#"))
            .parameters.vesicles[0]
            .shape;
    };
    CHECK(shape("\"spheroid\"\naspect = 0.5") == ShapeParameters{SpheroidShape{0.5}});
    CHECK(shape("\"discocyte\"\nreduced_volume = 0.65") ==
          ShapeParameters{HelfrichShape{HelfrichBranch::discocyte, 0.65}});
    CHECK(shape("\"prolate\"\nreduced_volume = 0.8") ==
          ShapeParameters{HelfrichShape{HelfrichBranch::prolate, 0.8}});
    CHECK(shape("\"stomatocyte\"\nreduced_volume = 0.6") ==
          ShapeParameters{HelfrichShape{HelfrichBranch::stomatocyte, 0.6}});
    CHECK(shape("\"evans-fung\"") == ShapeParameters{EvansFungShape{}});

    const auto area = [](const std::string& words) {
        return reading(changed("constraint = \"multiplier\"", words)).parameters.types[0].area;
    };
    CHECK(area("constraint = \"penalty\"\nmodulus = 0.02\n#") ==
          AreaParameters{PenaltyConstraint{0.02}, 1.31, 12000});
    CHECK(area("constraint = \"paper\"\nalpha = 1e-9\n#") ==
          AreaParameters{PaperConstraint{1e-9}, 1.31, 12000});

    const auto bending = [](const std::string& words) {
        return reading(changed("form = \"helfrich\"", words)).parameters.types[0].bending;
    };
    CHECK(bending("form = \"paper\"\n#") == BendingParameters{0.25, PaperBending{1.5}});
    CHECK(bending("form = \"paper\"\nlaplacian_coefficient = 0.5\n#") ==
          BendingParameters{0.25, PaperBending{0.5}});

    const auto perturbations =
        reading(changed("l = 2\nm = 0\namplitude = -0.01", "l = [2, 6]\namplitude = 0.01\nseed = 7"))
            .parameters.vesicles[0]
            .perturbations;
    CHECK(perturbations == std::vector<Perturbation>{RandomPerturbation{2, 6, 0.01, 7}});
}

TEST_CASE("fields can be cut, thinned and averaged") {
    const auto fields =
        reading(changed("fields = { every = 10000,", "fields = { every = 10, stride = 2, average = true, "
                                                     "region = [[1, 2, 3], [4, 5, 6]],"))
            .output.fields;
    REQUIRE(fields);
    CHECK(fields->every == 10);
    CHECK(fields->stride == 2);
    CHECK(fields->average);
    CHECK(fields->region_begin == Vec3<int>{1, 2, 3});
    CHECK(fields->region_end == Vec3<int>{4, 5, 6});
}

TEST_CASE("a shape read from a mesh comes with the mesh, looked for beside the case file") {
    const ScratchFolder folder;
    folder.write("tetrahedron.stl",
                 "solid t\n"
                 "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\n"
                 "endfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\n"
                 "endloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\n"
                 "vertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 1 0 0\n"
                 "vertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid t\n");
    const auto with_mesh = [](const std::string& name) {
        return changed("shape = \"sphere\" ", "shape = \"mesh\"\nfile = \"" + name + "\"\n#");
    };
    const Case sample = read_case(folder.write("case.toml", with_mesh("tetrahedron.stl")));
    const auto& mesh = std::get<MeshShape>(sample.parameters.vesicles[0].shape);
    CHECK(mesh.file == "tetrahedron.stl");
    REQUIRE(mesh.mesh);

    const std::string refused = file_verdict(folder.write("case.toml", with_mesh("absent.stl")));
    CHECK(refused.starts_with(
        "FILE:31:8: vesicle[0].file is \"absent.stl\"; expected a mesh that can be read; "));
}

TEST_CASE("every shipped case and every template is accepted without a warning") {
    std::vector<std::string> shipped;
    for (const auto& entry : std::filesystem::directory_iterator(source_dir / "cases")) {
        if (entry.path().extension() != ".toml")
            continue;
        INFO(entry.path());
        CHECK(read_case(entry.path()).warnings.empty());
        shipped.push_back(entry.path().stem());
    }
    CHECK(shipped.size() >= case_templates().size());
    for (const CaseTemplate& item : case_templates()) {
        INFO(item.name);
        CHECK(contents(source_dir / "cases" / (std::string(item.name) + ".toml")) == item.text);
        CHECK_FALSE(item.description.empty());
    }
    CHECK(case_templates().front().name == "discocyte");
}

TEST_CASE("what has no effect is accepted with a warning") {
    CHECK(reading(changed("constraint = \"multiplier\"", "constraint = \"none\"#")).warnings ==
          std::vector<std::string>{
              "case.toml:23:13: vesicle_type.rbc.area.deflation is 1.31; without effect since "
              "vesicle_type.rbc.area.constraint is \"none\"; try removing it",
              "case.toml:24:8: vesicle_type.rbc.area.ramp is 12000; without effect since "
              "vesicle_type.rbc.area.constraint is \"none\"; try removing it"});
    CHECK(reading(changed("l = 2\n", "l = 2\n"), {"fluid.collision.model=bgk"}).warnings ==
          std::vector<std::string>{
              "case.toml:12:9: fluid.collision.basis is \"symmetric\"; without effect since "
              "fluid.collision.model is \"bgk\"; try removing it",
              "case.toml:13:15: fluid.collision.ghost_rates is \"regularised\"; without effect "
              "since fluid.collision.model is \"bgk\"; try removing it"});
}

TEST_CASE("a tree too deep for any stack is refused, however it is written") {
    const std::string refusal = "the tables are nested deeper than 32; expected a case, whose deepest key is "
                                "vesicle_type.NAME.bending.modulus; try shorter keys";
    const auto repeated = [](const std::string& part, int times) {
        std::string text;
        for (int i = 0; i < times; ++i)
            text += part;
        return text;
    };
    const std::string dotted = repeated("a.", 100000) + "a";
    CHECK(verdict(dotted + " = 1\n") == "case.toml:1:130: " + refusal);
    CHECK(verdict("[" + dotted + "]\n") == "case.toml:1:131: " + refusal);
    CHECK(verdict("\n\"#\" . " + dotted + " = 1\n") == "case.toml:2:134: " + refusal);
    CHECK(verdict(repeated(repeated("a.", 60) + "a = {", 200))
              .starts_with("case.toml:1:")); // as it does not end
    CHECK(verdict(repeated(repeated("a.", 60) + "a = {", 200) + repeated("}", 200)).ends_with(refusal));
    // Dots that are no key.
    CHECK(verdict("# " + repeated("v1.", 300) + "\ntitle = \"" + repeated(".", 300) + "\"\n" +
                  changed("title = \"A discocyte from a deflated sphere\"", "")) == "accepted");
}

TEST_CASE("a file that is no case is refused for what it is") {
    const ScratchFolder folder;
    CHECK(file_verdict(folder.path / "absent.toml") ==
          "FILE: the file does not exist; expected a case file; try vesica new -o case.toml");
    CHECK(file_verdict(folder.path) ==
          "FILE: this is a directory; expected a case file; try the case.toml in it");
    CHECK(file_verdict(folder.write("empty.toml", "")) ==
          "FILE: the file is empty; expected a case; try vesica new");
    CHECK(file_verdict(folder.write("blank.toml", " \n\t\r\n")) ==
          "FILE: the file is empty; expected a case; try vesica new");
    CHECK(file_verdict(folder.write("comment.toml", "# nothing\n"))
              .starts_with("FILE: lattice.size is missing; "));
    const std::string binary =
        ": the text is binary or not UTF-8; expected a case file in UTF-8; try saving it as UTF-8";
    CHECK(file_verdict(folder.write("zero.toml", std::string("title = \"\"\nx\0y", 14))) ==
          "FILE:2:2" + binary);
    for (const std::string& bytes :
         {std::string("\xff"), std::string("\xc0\xaf"), std::string("\xe0\x80\x80"),
          std::string("\xf0\x80\x80\x80"), std::string("\xed\xa0\x80"), std::string("\xf4\x90\x80\x80"),
          std::string("\xe2\x82"), std::string("\x80")}) {
        CHECK(file_verdict(folder.write("latin.toml", "title = \"" + bytes)) == "FILE:1:10" + binary);
    }
    const std::string filler(100, '#');
    std::string large = discocyte_text();
    while (large.size() <= (4U << 20U))
        large += filler + "\n";
    CHECK(file_verdict(folder.write("large.toml", large)) ==
          "FILE: the file has more than 4 MiB; expected a case file; try a smaller one");
    large.resize(4U << 20U);
    CHECK(file_verdict(folder.write("large.toml", large)) == "accepted");
}

TEST_CASE("of several mistakes the first in the file is named") {
    CHECK(verdict(changed("[lattice]", "[lattice]\nzebra = 1\nape = 2"))
              .starts_with("case.toml:4:1: lattice.zebra "));
    CHECK(verdict(changed("[lattice]", "[zebra]\n[ape]\n[lattice]")).starts_with("case.toml:3:2: zebra "));
}

TEST_CASE("line ends of other systems and a byte order mark do not matter") {
    const Parameters original = reading(discocyte_text()).parameters;
    std::string text = "\xEF\xBB\xBF";
    for (const char c : discocyte_text())
        text += c == '\n' ? "\r\n" : std::string(1, c);
    CHECK(reading(text).parameters == original);
}

TEST_CASE("a case ends anywhere before its end with an error or a whole case") {
    const std::string text = discocyte_text();
    for (std::size_t size = 0; size < text.size(); size += 7) {
        const std::string message = verdict(text.substr(0, size));
        INFO(message);
        CHECK((message == "accepted" || message.starts_with("case.toml:")));
    }
}
