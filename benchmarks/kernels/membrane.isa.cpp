// Compiled once per instruction set; see cmake/instruction_sets.cmake.
#include "colour/phase.hpp"
#include "geometry/stencil.hpp"
#include "kernels/entries.hpp"
#include "kernels/surroundings.hpp"
#include "membrane/bending.hpp"
#include "membrane/layer_force.hpp"
#include "membrane/tension.hpp"

namespace vesica {

namespace {

template <class Real, class Law>
void add_law(const std::string& name, const char* isa_name, const Vec3<int>& size, const Law& law) {
    add_kernel<Real>(name, isa_name, size, [law](Surroundings<Real>& here, const BandTile& t) {
        here.store(law.force(here.load(here.fields.H0, t), here.load(here.fields.K0, t),
                             here.load(here.fields.sharp, t)),
                   here.fields.next, t);
    });
}

template <class Real>
void add_all(const char* isa_name, const Vec3<int>& size) {
    using V = Pack<Real>;
    using Here = Surroundings<Real>;

    add_law<Real>("membrane/helfrich", isa_name, size, HelfrichLaw{0.1, 0.05});
    add_law<Real>("membrane/paper_bending", isa_name, size, PaperBendingLaw{0.1, 1.5});
    add_kernel<Real>("membrane/tension", isa_name, size,
                     [law = TensionLaw{1e-3}](Here& here, const BandTile& t) {
                         here.store(law.force(here.load(here.fields.H0, t)), here.fields.next, t);
                     });
    const LayerForce spread(1e-2);
    add_kernel<Real>("membrane/force_profile", isa_name, size, [spread](Here& here, const BandTile& t) {
        here.store(spread.profile(phase_of(here.load(here.fields.chi, t))), here.fields.next, t);
    });
    add_kernel<Real>("membrane/layer_force", isa_name, size, [spread](Here& here, const BandTile& t) {
        const Vec3<V> slope = gradient<V>(here.around(here.fields.sharp, t));
        here.store(spread(slope, here.load(here.fields.H0, t)), here.fields.w, t);
    });
}

} // namespace

void VESICA_BENCHMARK_ENTRY(membrane, VESICA_ISA)(const char* isa_name) {
    for_precisions_and_sizes([=]<class Real>(const Vec3<int>& size) { add_all<Real>(isa_name, size); });
}

} // namespace vesica
