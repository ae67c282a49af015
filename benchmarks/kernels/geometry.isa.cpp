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
    using Here = Surroundings<Real>;

    add_kernel<Real>("geometry/sharpened", isa_name, size, []<class Tiles>(Here& here, const Tiles& t) {
        using V = typename Tiles::V;
        t.store(sharpened<V>(around(here.fields.s, t), 1.0), here.result);
    });
    add_kernel<Real>("geometry/normals", isa_name, size, []<class Tiles>(Here& here, const Tiles& t) {
        using V = typename Tiles::V;
        t.store(normal_of_distance(gradient<V>(around(here.fields.sharp, t))), here.fields.w);
    });
    add_kernel<Real>("geometry/curvatures", isa_name, size, []<class Tiles>(Here& here, const Tiles& t) {
        using V = typename Tiles::V;
        const Vec3<V> n = t.load(here.fields.n);
        const Curvatures<V> c = curvatures_of(jacobian_of_normals(around(here.fields.n, t), n), n);
        const Curvatures<V> surface = map_to_mid_surface(c, t.load(here.fields.s));
        t.store(surface.H, here.result);
        t.store(surface.K, here.fields.K0);
    });
    add_kernel<Real>("geometry/paper_curvatures", isa_name, size,
                     []<class Tiles>(Here& here, const Tiles& t) {
                         using V = typename Tiles::V;
                         const Jacobian<V> G = jacobian<V>(around(here.fields.n, t));
                         const Curvatures<V> c = paper_curvatures_of(G, t.load(here.fields.n));
                         t.store(c.H, here.result);
                         t.store(c.K, here.fields.K0);
                     });
    add_kernel<Real>("geometry/surface_gradient", isa_name, size,
                     []<class Tiles>(Here& here, const Tiles& t) {
                         using V = typename Tiles::V;
                         const Vec3<V> n = t.load(here.fields.n);
                         const Vec3<V> g = tangential(gradient<V>(around(here.fields.raw_H0, t)), n);
                         const Jacobian<V> G = jacobian<V>(around(here.fields.n, t));
                         const V s = t.load(here.fields.s);
                         const V J = t.load(here.fields.J);
                         const V H = J * fma(s, t.load(here.fields.K0), t.load(here.fields.raw_H0));
                         t.store(flux_on_mid_surface(g, G, n, s, H, J), here.fields.w);
                     });
    add_kernel<Real>("geometry/laplace_beltrami", isa_name, size,
                     []<class Tiles>(Here& here, const Tiles& t) {
                         using V = typename Tiles::V;
                         const Jacobian<V> d = jacobian<V>(around(here.fields.g, t));
                         const V divergence = surface_divergence(d, t.load(here.fields.n));
                         t.store(divergence / t.load(here.fields.J), here.result);
                     });
    add_kernel<Real>("geometry/paper_laplace_beltrami", isa_name, size,
                     []<class Tiles>(Here& here, const Tiles& t) {
                         using V = typename Tiles::V;
                         const auto H = around(here.fields.raw_H0, t);
                         const Jacobian<V> d = jacobian<V>(around(here.fields.g, t));
                         t.store(paper_laplace_beltrami(laplacian<V>(H), d, t.load(here.fields.g),
                                                        t.load(here.fields.n), H(Direction<0>{})),
                                 here.result);
                     });
}

} // namespace

void VESICA_BENCHMARK_ENTRY(geometry, VESICA_ISA)(const char* isa_name) {
    for_precisions_and_sizes([=]<class Real>(const Vec3<int>& size) { add_all<Real>(isa_name, size); });
}

} // namespace vesica
