// A drop in another fluid with Palabos, two components of Shan and Chen (1993) in a periodic cube: the rate
// of D3Q19 steps, one line of JSON.
#include "palabos_rate.hpp"

#include <cmath>
#include <vector>

namespace {

constexpr double coupling = 1.2; ///< G: well apart at a density of one
constexpr double trace = 0.06;   ///< of the one fluid inside the other

/// Density of one component about a drop of a diameter of .3 edges, as large as the vesicle of `vesica
/// bench`; inside it is `inner`.
template <typename T>
struct Drop {
    int edge;
    T inner;
    T outer;

    void operator()(plb::plint x, plb::plint y, plb::plint z, T& rho, plb::Array<T, 3>& u) const {
        const double centre = 0.5 * edge;
        const double distance = std::sqrt(std::pow(double(x) - centre, 2) + std::pow(double(y) - centre, 2) +
                                          std::pow(double(z) - centre, 2));
        rho = distance < 0.15 * edge ? inner : outer;
        u = plb::Array<T, 3>(T(0), T(0), T(0));
    }
};

template <typename T, template <typename U> class Descriptor>
void run(const peers::Arguments& arguments, const plb::Dynamics<T, Descriptor>& dynamics) {
    using namespace plb;
    const plint n = arguments.edge;
    MultiBlockLattice3D<T, Descriptor> red(n, n, n, dynamics.clone());
    MultiBlockLattice3D<T, Descriptor> blue(n, n, n, dynamics.clone());
    for (auto* lattice : {&red, &blue}) {
        lattice->periodicity().toggleAll(true);
        lattice->toggleInternalStatistics(false); // sums over all cells in every step, which nobody asked for
    }
    // The coupling runs at the end of the first lattice's step, so that one goes last.
    std::vector<MultiBlockLattice3D<T, Descriptor>*> both{&red, &blue};
    integrateProcessingFunctional(
        new ShanChenMultiComponentProcessor3D<T, Descriptor>(T(coupling), std::vector<T>(2, T(1))),
        red.getBoundingBox(), both, 1);
    initializeAtEquilibrium(red, red.getBoundingBox(), Drop<T>{arguments.edge, T(1), T(trace)});
    initializeAtEquilibrium(blue, blue.getBoundingBox(), Drop<T>{arguments.edge, T(trace), T(1)});
    blue.initialize();
    red.initialize();

    const double mass_before = computeAverageDensity(red);
    const peers::Rate rate = peers::measure(arguments, [&] {
        blue.collideAndStream();
        red.collideAndStream();
    });
    // The drop is still one: its middle is red and nothing was lost.
    const plint middle = n / 2;
    const Box3D centre(middle, middle, middle, middle, middle, middle);
    std::ostringstream extra;
    extra << ", \"red_in_the_middle\": " << computeAverageDensity(red, centre)
          << ", \"blue_in_the_middle\": " << computeAverageDensity(blue, centre)
          << ", \"mass_over_initial\": " << computeAverageDensity(red) / mass_before;
    peers::print_rate("shan_chen", arguments, rate, extra.str());
}

template <typename T>
void run_in(const peers::Arguments& arguments) {
    using namespace plb;
    if (arguments.collision == "bgk")
        run(arguments, ExternalMomentBGKdynamics<T, descriptors::ShanChenD3Q19Descriptor>(T(1)));
    else if (arguments.collision == "regularised")
        run(arguments, ExternalMomentRegularizedBGKdynamics<T, descriptors::ShanChenD3Q19Descriptor>(T(1)));
    else {
        pcerr << "--collision is " << arguments.collision << "; expected bgk or regularised\n";
        std::exit(2);
    }
}

} // namespace

int main(int argc, char** argv) {
    return peers::run_in_precision_asked_for(
        argc, argv, [](const auto& arguments, auto number) { run_in<decltype(number)>(arguments); });
}
