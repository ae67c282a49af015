#pragma once

namespace vesica {

/// How far each quantity reaches beyond the cells that had a force when the band was last laid out (level 0).
/// Level 1 is room to move: the band is laid out anew when the core leaves it. Each derivative asks for one
/// level more of what it differentiates.
namespace reach {
inline constexpr int force = 1;
inline constexpr int slope = 2;
inline constexpr int curvature = 3;
inline constexpr int raw_curvature = 4; ///< sharpening asks for one level more as well
inline constexpr int colour = 6;        ///< cells that may hold both colours, with the normals that part them
inline constexpr int receiving = 7;     ///< cells that colour may leak into within a step; sharpened s
} // namespace reach

} // namespace vesica
