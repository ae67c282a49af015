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
    add_kernel<Real>(name, isa_name, size, [law]<class Tiles>(Surroundings<Real>& here, const Tiles& t) {
        t.store(law.force(t.load(here.fields.raw_H0), t.load(here.fields.K0), t.load(here.fields.sharp)),
                here.result);
    });
}

template <class Real>
void add_all(const char* isa_name, const Vec3<int>& size) {
    using Here = Surroundings<Real>;

    add_law<Real>("membrane/helfrich", isa_name, size, HelfrichLaw{0.1, 0.05});
    add_law<Real>("membrane/paper_bending", isa_name, size, PaperBendingLaw{0.1, 1.5});
    add_kernel<Real>("membrane/tension", isa_name, size,
                     [law = TensionLaw{1e-3}]<class Tiles>(Here& here, const Tiles& t) {
                         t.store(law.force(t.load(here.fields.raw_H0)), here.result);
                     });
    const LayerForce spread(1e-2);
    add_kernel<Real>("membrane/force_profile", isa_name, size,
                     [spread]<class Tiles>(Here& here, const Tiles& t) {
                         t.store(spread.profile(phase_of(t.load(here.fields.chi))), here.result);
                     });
    add_kernel<Real>("membrane/layer_force", isa_name, size,
                     [spread]<class Tiles>(Here& here, const Tiles& t) {
                         using V = typename Tiles::V;
                         const Vec3<V> slope = gradient<V>(around(here.fields.sharp, t));
                         t.store(spread(slope, t.load(here.fields.raw_H0)), here.fields.w);
                     });
}

} // namespace

void VESICA_BENCHMARK_ENTRY(membrane, VESICA_ISA)(const char* isa_name) {
    for_precisions_and_sizes([=]<class Real>(const Vec3<int>& size) { add_all<Real>(isa_name, size); });
}

} // namespace vesica
