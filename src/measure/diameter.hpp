#pragma once

#include "measure/snapshot.hpp"

#include <vector>

namespace vesica {

/// Points of phi = 0: the feet x - s n of the cells with geometry within `reach` of it, about 2 reach per
/// cell^2. Only close to phi = 0 is s = -atanh(phi)/beta a distance to better than some hundredths of a cell.
std::vector<Vec3<double>> surface_points(const VesicleSnapshot& vesicle, double reach = 0.6);

/// The largest distance between two of the points; 0 for fewer than two.
/// From the extreme points along 256 directions it walks to the farthest point and back until the distance
/// grows no more. A walk ends in a pair of which each is the farthest from the other, and nothing but another
/// such pair could be longer; the directions are 6 degrees apart, so the result is at worst 0.15 % short, if
/// at all.
double largest_diameter(const std::vector<Vec3<double>>& points);

/// The largest diameter of phi = 0, cells. Sampling the surface at finite density shortens it by about
/// 0.1/R_c at each end (R_c the radius of curvature there), noise of the feet lengthens it by about 0.02.
/// NaN when no cell has geometry.
double largest_diameter(const VesicleSnapshot& vesicle);

/// ((D/D_0)^2 - 1)/((D/D_0)^2 + 1): the elongation against the rest state's largest diameter D_0.
double deformation_index(double diameter, double diameter_at_rest);

} // namespace vesica
