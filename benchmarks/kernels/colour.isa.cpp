// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "colour/recolouring.hpp"
#include "kernels/entries.hpp"
#include "kernels/surroundings.hpp"

namespace vesica {

namespace {

constexpr double beta = 0.67;

template <class Real>
void add_all(const char* isa_name, const Vec3<int>& size) {
    using Here = Surroundings<Real>;

    add_kernel<Real>("colour/gather", isa_name, size, []<class Tiles>(Here& here, const Tiles& t) {
        using V = typename Tiles::V;
        V g[direction_count];
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i] = V::load(here.populations.view().component(i) + t.slot());
        });
        const auto blue_is_minor = sign_bit(t.load(here.fields.chi));
        const ColourDensities<V> arrived =
            gather_colours(g, V(1), t.load(here.fields.density), blue_is_minor,
                           MinorityAround<Real, V::width>{blue_is_minor, around(here.fields.chi, t)},
                           around(here.fields.w, t));
        t.store(arrived.red, here.result);
        t.store(arrived.blue, here.fields.s);
    });
    add_kernel<Real>("colour/segregation_flux", isa_name, size, []<class Tiles>(Here& here, const Tiles& t) {
        t.store(segregation_flux(t.load(here.fields.chi), t.load(here.fields.density), t.load(here.fields.n),
                                 beta),
                here.fields.w);
    });
    add_kernel<Real>("colour/signed_distance", isa_name, size, []<class Tiles>(Here& here, const Tiles& t) {
        using V = typename Tiles::V;
        t.store(signed_distance_of(t.load(here.fields.chi), V(1e-8), beta), here.fields.s);
    });
}

} // namespace

void VESICA_BENCHMARK_ENTRY(colour, VESICA_ISA)(const char* isa_name) {
    for_precisions_and_sizes([=]<class Real>(const Vec3<int>& size) { add_all<Real>(isa_name, size); });
}

} // namespace vesica
