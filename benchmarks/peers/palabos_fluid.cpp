// One fluid in a periodic cube with Palabos: the rate of D3Q19 steps, one line of JSON.
#include "palabos_rate.hpp"

#include <cmath>

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double viscosity = 0.05;

/// A shear wave, u_x = 0.02 sin(2 pi z/N): not at rest, and its decay shows that the steps were real ones.
template <typename T>
struct ShearWave {
    int edge;

    void operator()(plb::plint, plb::plint, plb::plint z, T& rho, plb::Array<T, 3>& u) const {
        rho = T(1);
        u = plb::Array<T, 3>(T(0.02 * std::sin(2.0 * pi * double(z) / edge)), T(0), T(0));
    }
};

template <typename T, template <typename U> class Descriptor>
void run(const peers::Arguments& arguments, plb::Dynamics<T, Descriptor>* dynamics) {
    const plb::plint n = arguments.edge;
    plb::MultiBlockLattice3D<T, Descriptor> lattice(n, n, n, dynamics);
    lattice.periodicity().toggleAll(true);
    lattice.toggleInternalStatistics(false); // sums over all cells in every step, which nobody asked for
    plb::initializeAtEquilibrium(lattice, lattice.getBoundingBox(), ShearWave<T>{arguments.edge});
    lattice.initialize();

    for (int step = 0; step < 10; ++step) // the stress, zero at first, becomes the wave's
        lattice.collideAndStream();
    const double energy_before = plb::computeAverageEnergy(lattice);
    const peers::Rate rate = peers::measure(arguments, [&] { lattice.collideAndStream(); });
    const double energy_after = plb::computeAverageEnergy(lattice);

    // Energy falls as exp(-2 nu k^2 t).
    const double k = 2.0 * pi / arguments.edge;
    const double decay = std::log(energy_before / energy_after) / (2.0 * viscosity * k * k * rate.steps);
    std::ostringstream extra;
    extra << ", \"decay_over_theory\": " << decay;
    peers::print_rate("fluid", arguments, rate, extra.str());
}

template <typename T>
void run_in(const peers::Arguments& arguments) {
    using namespace plb;
    const T omega = T(1.0 / (3.0 * viscosity + 0.5));
    if (arguments.collision == "bgk")
        run<T, descriptors::D3Q19Descriptor>(arguments,
                                             new BGKdynamics<T, descriptors::D3Q19Descriptor>(omega));
    else if (arguments.collision == "regularised")
        run<T, descriptors::D3Q19Descriptor>(
            arguments, new RegularizedBGKdynamics<T, descriptors::D3Q19Descriptor>(omega));
    else if (arguments.collision == "mrt")
        run<T, descriptors::MRTD3Q19Descriptor>(arguments,
                                                new MRTdynamics<T, descriptors::MRTD3Q19Descriptor>(omega));
    else {
        pcerr << "--collision is " << arguments.collision << "; expected bgk, regularised or mrt\n";
        std::exit(2);
    }
}

} // namespace

int main(int argc, char** argv) {
    return peers::run_in_precision_asked_for(
        argc, argv, [](const auto& arguments, auto number) { run_in<decltype(number)>(arguments); });
}
