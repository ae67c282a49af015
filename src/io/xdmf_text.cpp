#include "io/xdmf_text.hpp"

#include "io/number_text.hpp"

#include <fmt/format.h>

namespace vesica {
namespace {

std::string number(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string array_text(const FieldStep& step, const FieldStep::Array& array, const std::string& location) {
    const std::string cells = fmt::format("{} {} {}", step.count.z, step.count.y, step.count.x);
    const bool is_scalar = array.components == 1;
    const char* kind = is_scalar ? "Scalar" : array.components == 3 ? "Vector" : "Matrix";
    return fmt::format(R"(        <Attribute Name="{0}" AttributeType="{1}" Center="Cell">
          <DataItem Dimensions="{2}" NumberType="Float" Precision="4" Format="HDF">{3}:/{0}</DataItem>
        </Attribute>
)",
                       array.name, kind, is_scalar ? cells : fmt::format("{} {}", cells, array.components),
                       location);
}

std::string step_text(const FieldStep& step, const std::string& location) {
    std::string text = fmt::format(
        R"(      <Grid Name="step {0}" GridType="Uniform">
        <Time Value="{1}"/>
        <Topology TopologyType="3DCoRectMesh" Dimensions="{2} {3} {4}"/>
        <Geometry GeometryType="ORIGIN_DXDYDZ">
          <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{5} {6} {7}</DataItem>
          <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{8} {8} {8}</DataItem>
        </Geometry>
)",
        step.step, number(step.time), step.count.z + 1, step.count.y + 1, step.count.x + 1,
        number(step.origin.z), number(step.origin.y), number(step.origin.x), number(step.spacing));
    for (const auto& array : step.arrays)
        text += array_text(step, array, location);
    return text + "      </Grid>\n";
}

} // namespace

std::string xdmf_text(std::span<const FieldStep> steps,
                      const std::function<std::string(const FieldStep&)>& location) {
    std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="3.0">
  <Domain>
    <Grid Name="fields" GridType="Collection" CollectionType="Temporal">
)";
    for (const auto& step : steps)
        text += step_text(step, location(step));
    return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

} // namespace vesica
