#include "measure/layer_moment.hpp"

#include "core/exact_sum.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace vesica {
namespace {

struct CentralMoments {
    double second = 0.0;
    double fourth = 0.0;
};

/// Moments of w on the nodes of the profile through phi = `start` at node 0, about its own centre: by
/// translation invariance sum w x is the position of phi = 0, up to terms of order exp(-pi^2/beta).
CentralMoments node_moments(double start, double beta) {
    std::vector<double> position;
    std::vector<double> weight;
    const auto visit = [&](double x, double height) {
        position.push_back(x);
        weight.push_back(0.5 * beta * height * (2.0 - height)); // phi = height - 1
    };
    const double negligible = 1e-22;
    visit(0.0, 1.0 + start);
    double height = 1.0 + start;
    for (double x = 1.0; (height = next_height(height, beta)) > negligible; x += 1.0)
        visit(x, height);
    height = 1.0 - start; // inwards the same recurrence holds for -phi
    for (double x = -1.0; (height = next_height(height, beta)) > negligible; x -= 1.0)
        visit(x, height);

    ExactSum total, first;
    for (std::size_t i = 0; i < weight.size(); ++i) {
        total.add(weight[i]);
        first.add(weight[i] * position[i]);
    }
    const double centre = first.value() / total.value();
    ExactSum second, fourth;
    for (std::size_t i = 0; i < weight.size(); ++i) {
        const double square = (position[i] - centre) * (position[i] - centre);
        second.add(weight[i] * square);
        fourth.add(weight[i] * square * square);
    }
    return {second.value() / total.value(), fourth.value() / total.value()};
}

} // namespace

double next_height(double height, double beta) {
    const double g =
        height * (2.0 * (1.0 - beta) + beta * height); // root of the recurrence's quadratic, over beta
    return g / (1.0 + beta + std::sqrt((1.0 + beta) * (1.0 + beta) - beta * g));
}

LayerMoments tanh_layer_moments(double beta) {
    assert(beta > 0.0);
    const double scale = std::numbers::pi / beta;
    const double second = scale * scale / 12.0;
    return {second, 0.0, second, 0.0, 7.0 * scale * scale * scale * scale / 240.0};
}

LayerMoments lattice_layer_moments(double beta) {
    assert(beta > 0.0 && beta < 1.0);
    constexpr int offsets = 16;
    // Node 0 from where phi = 0 sits on it to where phi = 0 is half a cell away.
    CentralMoments mean;
    for (int i = 0; i < offsets; ++i) {
        const double start = std::tanh(beta * 0.5 * (i + 0.5) / offsets);
        const CentralMoments moments = node_moments(start, beta);
        mean.second += moments.second / offsets;
        mean.fourth += moments.fourth / offsets;
    }
    const double shift = (1.0 - std::numbers::ln2) / 3.0;
    return {mean.second, 1.0 / 3.0 + 2.0 * shift, mean.second + 1.0 / 6.0, shift,
            mean.fourth + mean.second - 1.0 / 30.0};
}

} // namespace vesica
