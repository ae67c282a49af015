#include "simulation/case_bodies.hpp"

#include "case/triangle_mesh.hpp"
#include "core/input_error.hpp"
#include "simulation/flow_drive.hpp"

#include <fmt/format.h>

namespace vesica {

std::unique_ptr<const Shape> shape_of(const Case& what, std::size_t vesicle) {
    return shape_of(what, what.parameters.vesicles[vesicle], fmt::format("vesicle[{}]", vesicle));
}

std::unique_ptr<const Shape> shape_of(const Case& what, const VesicleParameters& vesicle,
                                      const std::string& path) {
    try {
        return make_shape(vesicle);
    } catch (const InputError& refusal) {
        const std::string message = refusal.what();
        const std::string name = path + ".";
        const auto* mesh = std::get_if<MeshShape>(&vesicle.shape);
        if (mesh != nullptr && mesh->mesh && message.starts_with(mesh->mesh->source))
            throw InputError(what.place(name + "file"),
                             fmt::format("{}file is \"{}\"; {}", name, mesh->file, message));
        const std::string key = message.substr(0, message.find_first_of(" ."));
        throw InputError(what.place(name + key), name + message);
    }
}

std::shared_ptr<const SolidVoxels> obstacles_of(const Case& what) {
    try {
        auto solids = solid_voxels(what.parameters);
        const std::size_t count = solids != nullptr ? solids->count() : 1;
        const Vec3<int>& size = what.parameters.size;
        if (count == 0)
            throw InputError("no cell of the box is solid; expected some; try another obstacles.scale or "
                             "obstacles.position, which are in cells");
        if (solids != nullptr && count == static_cast<std::size_t>(size.x) *
                                              static_cast<std::size_t>(size.y) *
                                              static_cast<std::size_t>(size.z))
            throw InputError(
                "every cell of the box is solid; expected some fluid; try obstacles.solid = \"inside\" or "
                "\"outside\", or another obstacles.scale");
        return solids;
    } catch (const InputError& refusal) {
        throw InputError(
            what.place("obstacles.file"),
            fmt::format("obstacles.file is \"{}\"; {}", what.parameters.obstacles->file, refusal.what()));
    }
}

} // namespace vesica
