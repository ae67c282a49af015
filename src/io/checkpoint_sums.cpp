#include "io/checkpoint_sums.hpp"

#include "core/input_error.hpp"
#include "io/hdf5_array.hpp"

#include <fmt/format.h>

namespace vesica {

std::vector<double> read_sums(const std::filesystem::path& checkpoint, const std::string& name,
                              const Vec3<int>& count, const CellBox& part, int components) {
    const QuietHdf5 quiet;
    const Hdf5File file = open_hdf5(checkpoint);
    const bool kept = has_link(file, "sums", checkpoint);
    const Hdf5Group group = kept ? open_group(file, "sums", checkpoint) : Hdf5Group();
    if (!kept || !has_link(group, name, checkpoint))
        throw RunError(fmt::format("{}: the average of {} that was under way is not of this case",
                                   checkpoint.string(), name));
    const Hdf5Dataset array = open_array(group, name, checkpoint);
    const auto width = static_cast<hsize_t>(components);
    const auto wanted = static_cast<hsize_t>(CellBox{{}, count}.volume()) * width;
    if (shape_of(array, checkpoint) != std::vector<hsize_t>{wanted})
        throw RunError(fmt::format("{}: the average of {} that was under way is not of this case",
                                   checkpoint.string(), name));
    std::vector<double> values(static_cast<std::size_t>(part.volume()) * width);
    double* into = values.data();
    for (int z = 0; z < part.size.z && part.volume() > 0; ++z) {
        Hdf5Runs rows;
        rows.first = CellBox{{}, count}.index_of(part.begin + Vec3<int>{0, 0, z}) * width;
        rows.stride = static_cast<hsize_t>(count.x) * width;
        rows.count = static_cast<hsize_t>(part.size.y);
        rows.length = static_cast<hsize_t>(part.size.x) * width;
        read_runs(array, H5T_NATIVE_DOUBLE, 0, rows, into, checkpoint);
        into += rows.count * rows.length;
    }
    return values;
}

} // namespace vesica
