#pragma once

#include "case/solid_voxels.hpp"
#include "core/vec3.hpp"
#include "shape/trilinear.hpp"

#include <array>
#include <vector>

namespace vesica {

/// The distance to the nearest solid cell of a box, for every cell of it; below zero within solids. Exact
/// between centres of cells (Felzenszwalb and Huttenlocher 2012), less half a cell; between centres linear.
class SolidDistance {
public:
    SolidDistance(const SolidVoxels& solids, const std::array<bool, 3>& periodic);

    /// Anywhere in space: beyond periodic ends the images, beyond others as at the end.
    DistanceValue at(const Vec3<double>& position) const;

private:
    double cell(Vec3<int> place) const;

    Vec3<int> size_;
    std::array<bool, 3> periodic_;
    std::vector<float> distance_;
};

} // namespace vesica
