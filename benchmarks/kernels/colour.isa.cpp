// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "colour/recolouring.hpp"
#include "kernels/entries.hpp"
#include "kernels/surroundings.hpp"

namespace vesica {

namespace {

template <class Real>
void add_all(const char* isa_name, const Vec3<int>& size) {
    using V = Pack<Real>;
    using Here = Surroundings<Real>;
    constexpr double beta = 0.67;

    add_kernel<Real>("colour/gather", isa_name, size, [](Here& here, const BandTile& t) {
        V g[direction_count];
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            g[i] = V::load(here.populations.view().component(i) + t.slot());
        });
        const auto blue_is_minor = sign_bit(here.load(here.fields.chi, t));
        const ColourDensities<V> arrived =
            gather_colours(g, V(1), here.load(here.fields.density, t), blue_is_minor,
                           MinorityAround<Real>{blue_is_minor, here.around(here.fields.red, t),
                                                here.around(here.fields.blue, t)},
                           here.around(here.fields.w, t));
        here.store(arrived.red, here.fields.s, t);
        here.store(arrived.blue, here.fields.sharp, t);
    });
    add_kernel<Real>("colour/segregation_flux", isa_name, size, [](Here& here, const BandTile& t) {
        here.store(segregation_flux(here.load(here.fields.chi, t), here.load(here.fields.density, t),
                                    here.load(here.fields.n, t), beta),
                   here.fields.w, t);
    });
    add_kernel<Real>("colour/signed_distance", isa_name, size, [](Here& here, const BandTile& t) {
        here.store(signed_distance_of(here.load(here.fields.chi, t), V(1e-8), beta), here.fields.s, t);
    });
}

} // namespace

void VESICA_BENCHMARK_ENTRY(colour, VESICA_ISA)(const char* isa_name) {
    for_precisions_and_sizes([=]<class Real>(const Vec3<int>& size) { add_all<Real>(isa_name, size); });
}

} // namespace vesica
