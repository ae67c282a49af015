// The kernels' own headers on a GPU: the one text of them, with plain numbers for packs. Compiled where nvcc
// is found, and run where there is a device as well: the numbers must be the processor's.
#include "collision/regularised.hpp"
#include "collision/symmetric_mrt.hpp"
#include "colour/phase.hpp"
#include "colour/recolouring.hpp"
#include "geometry/curvature.hpp"
#include "geometry/laplace_beltrami.hpp"
#include "geometry/normal.hpp"
#include "membrane/bending.hpp"
#include "membrane/layer_force.hpp"
#include "membrane/tension.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

using namespace vesica;

namespace {

constexpr int results = 32;

/// A made-up neighbourhood: value `k` of cell `i` around.
template <class Real>
struct Around {
    int k;
    Real unit; ///< known only at run time, or the compiler would do it all
    template <int i>
    constexpr Real operator()(Direction<i>) const {
        return unit * static_cast<Real>(0.1 + 0.03 * ((7 * i + 5 * k) % 11));
    }
};

/// Every kernel once; what comes out in `out`.
template <class Real, class Collision>
__host__ __device__ void all_kernels(const Collision& collision, Real unit, Real (&out)[results]) {
    Real g[direction_count] = {};
    Real density = Real(1);
    for (int i = 0; i < direction_count; ++i) {
        g[i] = unit * static_cast<Real>(0.001 * ((5 * i) % 7));
        density += g[i];
    }
    const Vec3<Around<Real>> field{{0, unit}, {1, unit}, {2, unit}};
    const ColourDensities<Real> colours =
        gather_colours(g, Real(1), density, false, Around<Real>{3, unit}, field);
    const Vec3<Real> n = normal_of_distance(gradient<Real>(Around<Real>{4, unit}));
    const Jacobian<Real> G = jacobian_of_normals(field, n);
    const Curvatures<Real> here = curvatures_of(G, n);
    const Real chi = chi_of_phase(Real(0.3) * unit);
    const Real s = signed_distance_of(chi, Real(1e-8), 0.67);
    const Curvatures<Real> surface = map_to_mid_surface(here, s);
    const Real J = area_to_mid_surface(here, s);
    const Vec3<Real> slope = flux_on_mid_surface(tangential(Vec3<Real>{G.x.x, G.x.y, G.x.z}, n),
                                                 jacobian<Real>(field), n, s, here.H, J);
    const Real normal_force = HelfrichLaw{0.1, 0.02}.force(surface.H, surface.K, surface_divergence(G, n)) +
                              PaperBendingLaw{0.1, 0.5}.force(surface.H, surface.K, slope.x) +
                              TensionLaw{0.01}.force(surface.H);
    const LayerForce spread(1e-2);
    const Vec3<Real> F = spread(slope, normal_force * spread.profile(phase_of(chi)));
    collision(g, F, Real(1.2), Real(1));
    for (int i = 0; i < direction_count; ++i)
        out[i] = g[i];
    const Vec3<Real> w = segregation_flux(chi, density, n, 0.67);
    const Real rest[] = {colours.red,
                         colours.blue,
                         surface.H,
                         surface.K,
                         J,
                         F.x,
                         F.y,
                         F.z,
                         w.x,
                         w.y,
                         w.z,
                         sharpened<Real>(Around<Real>{5, unit}, 1.0),
                         s};
    for (int k = 0; k < results - direction_count; ++k)
        out[direction_count + k] = rest[k];
}

template <class Real, class Collision>
__global__ void on_device(Collision collision, Real unit, Real* out) {
    Real found[results] = {};
    all_kernels(collision, unit, found);
    for (int k = 0; k < results; ++k)
        out[k] = found[k];
}

template <class Real, class Collision>
int compare(const char* name, const Collision& collision) {
    Real expected[results] = {};
    all_kernels(collision, Real(1), expected);
    Real* out = nullptr;
    if (cudaMallocManaged(&out, sizeof expected) != cudaSuccess)
        return 2;
    on_device<Real><<<1, 1>>>(collision, Real(1), out);
    if (cudaDeviceSynchronize() != cudaSuccess)
        return 2;
    int wrong = 0;
    for (int k = 0; k < results; ++k)
        if (!(std::abs(out[k] - expected[k]) <=
              32 * std::numeric_limits<Real>::epsilon() * (1 + std::abs(expected[k])))) {
            std::printf("%s, number %d: %.17g on the device, %.17g here\n", name, k,
                        static_cast<double>(out[k]), static_cast<double>(expected[k]));
            ++wrong;
        }
    cudaFree(out);
    return wrong == 0 ? 0 : 1;
}

} // namespace

int main() {
    int devices = 0;
    if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
        std::puts("compiled; no device to run on");
        return 77; // skipped
    }
    const SymmetricMrt<TwoRelaxationTimes> two{{0.25}};
    const int wrong = compare<double>("regularised, double", RegularisedCollision{}) |
                      compare<float>("regularised, single", RegularisedCollision{}) |
                      compare<double>("two relaxation times, double", two);
    if (wrong == 0)
        std::puts("the device's numbers are the processor's");
    return wrong;
}
