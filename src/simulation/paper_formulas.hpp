#pragma once

#include <string>

namespace vesica {

/// The reference paper's tables as this program holds and uses them, in JSON, for `vesica reproduce
/// appendix-a appendix-b`: the velocity set and its weights, the matrix M of the moments and its inverse,
/// what the paper's collision makes of a few random cells, and the curvatures that its three local frames and
/// the frame-free form find for random surfaces of known principal curvatures. Nothing is judged here.
std::string paper_formulas_json();

} // namespace vesica
