#include "io/case_build_vesicle.hpp"

#include "io/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesica {
namespace {

BendingParameters read_bending(const CaseValues& values, const std::string& table) {
    BendingParameters bending;
    bending.modulus = values.find(table + ".modulus") ? values.number(table + ".modulus")
                                                      : values.number(table + ".paper_modulus") / 4.0;
    const std::string curvature = table + ".spontaneous_curvature";
    if (values.text(table + ".form") == "helfrich") {
        bending.form = HelfrichBending{values.number(curvature)};
        return bending;
    }
    if (values.number(curvature) != 0.0)
        values.refuse(curvature,
                      "expected 0 with form = \"paper\", which has no spontaneous curvature; try form = "
                      "\"helfrich\"");
    const std::string coefficient = table + ".laplacian_coefficient";
    const double c = values.number(coefficient);
    if (c != 1.5 && c != 0.5)
        values.refuse(coefficient, "expected 1.5 or 0.5; try laplacian_coefficient = 1.5");
    bending.form = PaperBending{c};
    return bending;
}

AreaParameters read_area(const CaseValues& values, const std::string& table) {
    AreaParameters area;
    const std::string& constraint = values.text(table + ".constraint");
    if (constraint == "none") {
        area.constraint = NoConstraint{};
        return area;
    }
    if (constraint == "penalty")
        area.constraint = PenaltyConstraint{values.number(table + ".modulus")};
    if (constraint == "paper")
        area.constraint = PaperConstraint{values.number(table + ".alpha")};
    if (values.find(table + ".deflation"))
        area.deflation = values.number(table + ".deflation");
    if (values.find(table + ".reduced_volume")) // v = Upsilon^(-3/2)
        area.deflation = std::pow(values.number(table + ".reduced_volume"), -2.0 / 3.0);
    area.ramp = values.integer(table + ".ramp");
    return area;
}

Perturbation read_perturbation(const CaseValues& values, const std::string& path) {
    const double amplitude = values.number(path + ".amplitude");
    if (values.find(path + ".l")->is_array) {
        if (amplitude < 0.0)
            values.refuse(path + ".amplitude",
                          "expected at least 0, being an r.m.s. of random harmonics; try "
                          "amplitude = 0.01");
        return RandomPerturbation{static_cast<int>(values.integer(path + ".l", 0)),
                                  static_cast<int>(values.integer(path + ".l", 1)), amplitude,
                                  static_cast<std::uint64_t>(values.integer(path + ".seed"))};
    }
    const auto l = values.integer(path + ".l");
    const auto m = values.integer(path + ".m");
    if (std::abs(m) > l)
        values.refuse(path + ".m", fmt::format("expected from {} to {}, as l is {}; try m = 0", -l, l, l));
    return HarmonicPerturbation{static_cast<int>(l), static_cast<int>(m), amplitude};
}

} // namespace

ShapeParameters build_shape(const CaseValues& values, const std::string& path,
                            const std::filesystem::path& folder) {
    const std::string& shape = values.text(path + ".shape");
    if (shape == "spheroid")
        return SpheroidShape{values.number(path + ".aspect")};
    if (shape == "evans-fung")
        return EvansFungShape{};
    if (shape == "mesh") {
        MeshShape mesh;
        mesh.file = values.text(path + ".file");
        try {
            mesh.mesh = std::make_shared<const TriangleMesh>(read_triangle_mesh(folder / mesh.file));
        } catch (const InputError& error) {
            values.refuse(path + ".file", std::string("expected a mesh that can be read; ") + error.what());
        }
        return mesh;
    }
    if (shape == "sphere")
        return SphereShape{};
    const HelfrichBranch branch = shape == "discocyte" ? HelfrichBranch::discocyte
                                  : shape == "prolate" ? HelfrichBranch::prolate
                                                       : HelfrichBranch::stomatocyte;
    return HelfrichShape{branch, values.number(path + ".reduced_volume")};
}

std::size_t type_index(const CaseValues& values, const std::string& path,
                       const std::vector<VesicleType>& types) {
    const std::string& name = values.text(path + ".type");
    const auto type =
        std::find_if(types.begin(), types.end(), [&](const VesicleType& t) { return t.name == name; });
    return static_cast<std::size_t>(type - types.begin());
}

VesicleType build_vesicle_type(const CaseValues& values, const std::string& path) {
    VesicleType type;
    type.name = path.substr(path.find('.') + 1);
    type.viscosity_ratio = values.number(path + ".viscosity_ratio");
    type.bending = read_bending(values, path + ".bending");
    type.area = read_area(values, path + ".area");
    type.sigma = values.number(path + ".tension.sigma");
    for (int a = 0; a < 3; ++a)
        type.buoyancy[a] = values.number(path + ".buoyancy", static_cast<std::size_t>(a));
    return type;
}

VesicleParameters build_vesicle(const CaseValues& values, const std::string& path,
                                const std::vector<VesicleType>& types, const std::filesystem::path& folder) {
    VesicleParameters vesicle;
    vesicle.type = type_index(values, path, types);
    vesicle.shape = build_shape(values, path, folder);
    for (int a = 0; a < 3; ++a) {
        vesicle.centre[a] = values.number(path + ".centre", static_cast<std::size_t>(a));
        vesicle.axis[a] = values.number(path + ".axis", static_cast<std::size_t>(a));
    }
    if (values.find(path + ".buoyancy")) {
        vesicle.buoyancy.emplace();
        for (int a = 0; a < 3; ++a)
            (*vesicle.buoyancy)[a] = values.number(path + ".buoyancy", static_cast<std::size_t>(a));
    }
    const bool mesh = std::holds_alternative<MeshShape>(vesicle.shape);
    if (values.find(path + ".radius")) {
        vesicle.radius = values.number(path + ".radius");
    } else if (!mesh) {
        values.refuse(path + ".radius",
                      "expected a length above 0, as the shape is no mesh; try radius = 15");
    }
    if (const auto found = values.tables.find("vesicle[].perturbation[]"); found != values.tables.end()) {
        for (const std::string& mode : found->second) {
            if (mode.starts_with(path + "."))
                vesicle.perturbations.push_back(read_perturbation(values, mode));
        }
    }
    return vesicle;
}

} // namespace vesica
