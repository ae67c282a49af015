#include "io/case_build_suspension.hpp"

#include "io/case_build_region.hpp"
#include "io/case_build_vesicle.hpp"

namespace vesica {

std::optional<SuspensionParameters> build_suspension(const CaseValues& values, const Parameters& parameters,
                                                     const std::filesystem::path& folder) {
    if (!values.has_table("suspension"))
        return std::nullopt;
    if (values.has_table("initial"))
        values.refuse(
            "suspension.type",
            "expected no [suspension] beside [initial], whose state has vesicles of its own; try the "
            "[[vesicle]] tables of that run's resolved.toml");
    SuspensionParameters suspension;
    VesicleParameters& vesicle = suspension.vesicle;
    vesicle.type = type_index(values, "suspension", parameters.types);
    vesicle.shape = build_shape(values, "suspension", folder);
    vesicle.radius = values.number("suspension.radius");
    if (values.find("suspension.haematocrit"))
        suspension.haematocrit = values.number("suspension.haematocrit");
    if (values.find("suspension.count"))
        suspension.count = values.integer("suspension.count");
    const std::string& orientation = values.text("suspension.orientation");
    if (orientation == "aligned")
        suspension.orientation = PackedOrientation::aligned;
    if (orientation == "spread") {
        suspension.orientation = PackedOrientation::spread;
        suspension.spread = values.number("suspension.spread");
    }
    if (orientation != "random")
        for (int a = 0; a < 3; ++a)
            suspension.axis[a] = values.number("suspension.axis", static_cast<std::size_t>(a));
    if (values.find("suspension.gap"))
        suspension.gap = values.number("suspension.gap");
    suspension.seed = static_cast<std::uint64_t>(values.integer("suspension.seed"));
    const CaseRegion region = build_region(values, "suspension.region", parameters.size);
    suspension.region_begin = region.begin;
    suspension.region_end = region.end;
    return suspension;
}

} // namespace vesica
