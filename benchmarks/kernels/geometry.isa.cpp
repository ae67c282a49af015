// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "geometry/curvature.hpp"
#include "geometry/laplace_beltrami.hpp"
#include "geometry/normal.hpp"
#include "geometry/paper_frames.hpp"
#include "kernels/entries.hpp"
#include "kernels/surroundings.hpp"

namespace vesica {

namespace {

/// What is written is not read again, so that the numbers stay as they are.
template <class Real>
void add_all(const char* isa_name, const Vec3<int>& size) {
    using V = Pack<Real>;
    using Here = Surroundings<Real>;

    add_kernel<Real>("geometry/sharpened", isa_name, size, [](Here& here, const BandTile& t) {
        here.store(sharpened<V>(here.around(here.fields.s, t), 1.0), here.fields.next, t);
    });
    add_kernel<Real>("geometry/normals", isa_name, size, [](Here& here, const BandTile& t) {
        here.store(unit_vector(gradient<V>(here.around(here.fields.sharp, t))), here.fields.w, t);
    });
    add_kernel<Real>("geometry/curvatures", isa_name, size, [](Here& here, const BandTile& t) {
        const Jacobian<V> G = jacobian<V>(here.around(here.fields.n, t));
        const Curvatures<V> c = curvatures_of(G, here.load(here.fields.n, t));
        const Curvatures<V> surface = map_to_mid_surface(c, here.load(here.fields.s, t));
        here.store(surface.H, here.fields.next, t);
        here.store(surface.K, here.fields.K0, t);
    });
    add_kernel<Real>("geometry/paper_curvatures", isa_name, size, [](Here& here, const BandTile& t) {
        const Jacobian<V> G = jacobian<V>(here.around(here.fields.n, t));
        const Curvatures<V> c = paper_curvatures_of(G, here.load(here.fields.n, t));
        here.store(c.H, here.fields.next, t);
        here.store(c.K, here.fields.K0, t);
    });
    add_kernel<Real>("geometry/surface_gradient", isa_name, size, [](Here& here, const BandTile& t) {
        const Vec3<V> n = here.load(here.fields.n, t);
        const Vec3<V> g = tangential(gradient<V>(here.around(here.fields.raw_H0, t)), n);
        const Jacobian<V> G = jacobian<V>(here.around(here.fields.n, t));
        const V s = here.load(here.fields.s, t);
        here.store(flux_on_mid_surface(g, G, n, s, here.load(here.fields.J, t)), here.fields.w, t);
    });
    add_kernel<Real>("geometry/laplace_beltrami", isa_name, size, [](Here& here, const BandTile& t) {
        const Jacobian<V> d = jacobian<V>(here.around(here.fields.g, t));
        const V divergence = surface_divergence(d, here.load(here.fields.n, t));
        here.store(divergence / here.load(here.fields.J, t), here.fields.next, t);
    });
    add_kernel<Real>("geometry/paper_laplace_beltrami", isa_name, size, [](Here& here, const BandTile& t) {
        const TileAround<Real> H = here.around(here.fields.raw_H0, t);
        const Jacobian<V> d = jacobian<V>(here.around(here.fields.g, t));
        here.store(paper_laplace_beltrami(laplacian<V>(H), d, here.load(here.fields.g, t),
                                          here.load(here.fields.n, t), H(Direction<0>{})),
                   here.fields.next, t);
    });
}

} // namespace

void VESICA_BENCHMARK_ENTRY(geometry, VESICA_ISA)(const char* isa_name) {
    for_precisions_and_sizes([=]<class Real>(const Vec3<int>& size) { add_all<Real>(isa_name, size); });
}

} // namespace vesica
