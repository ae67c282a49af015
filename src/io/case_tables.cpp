#include "io/case_keys.hpp"

namespace vesica {

const std::vector<CaseTable>& case_tables() {
    static const std::vector<CaseTable> tables{
        {"", false, "At the top."},
        {"lattice", false, "The box."},
        {"fluid", false, "Both fluids."},
        {"fluid.collision", false, "The collision operator."},
        {"fluid.collision.ghost_rates", true,
         "Relaxation rates, each above 0 and below 2: one complete set."},
        {"boundary", false, "What the box ends with; axes that are not named are periodic."},
        {"boundary.x", true, ""},
        {"boundary.x.lower", true, "The end at 0."},
        {"boundary.x.upper", true, "The end at the box's size."},
        {"boundary.y", true, ""},
        {"boundary.y.lower", true, "The end at 0."},
        {"boundary.y.upper", true, "The end at the box's size."},
        {"boundary.z", true, ""},
        {"boundary.z.lower", true, "The end at 0."},
        {"boundary.z.upper", true, "The end at the box's size."},
        {"obstacles", true, "Solids in the box, to which the fluid sticks."},
        {"flow", true, "What drives the fluid; flows add up."},
        {"flow.shear", true, "u = rate (z - middle) along x, or any other pair of axes."},
        {"flow.poiseuille", true, "Flow along a channel."},
        {"flow.extension", true, "Plane extension."},
        {"flow.body_force", true, "A uniform force."},
        {"vesicle_type.*", true, "What vesicles of this name are made of."},
        {"vesicle_type.*.bending", false, "Resistance to bending."},
        {"vesicle_type.*.area", false, "The membrane's area."},
        {"vesicle_type.*.tension", false, "Tension that does not depend on the area."},
        {"vesicle[]", true, "One vesicle; as many as there are."},
        {"vesicle[].perturbation[]", true,
         "Ripples r (1 + amplitude Y_lm), where Y_l0 is the Legendre polynomial P_l of the angle to the "
         "axis."},
        {"suspension", true,
         "Many vesicles alike, packed into the box; among those of [[vesicle]], if there are any."},
        {"initial", true,
         "A start from an earlier run's state instead of the vesicles' shapes, with this case's parameters."},
        {"numerics", false, "How it is computed."},
        {"run", false, "How long."},
        {"run.stop_when_steady", true, "An earlier end."},
        {"output", false, "What is written."},
        {"output.metrics", false, "metrics.csv."},
        {"output.fields", true, "fields.h5 and fields.xmf."},
        {"output.surfaces", true, "Triangles of the membrane."},
        {"output.profiles", true,
         "Haematocrit and velocity across the flow, bin by bin (profiles.csv), and of the whole box, with "
         "the "
         "cell-free layer (suspension.csv); of several vesicles how their centres lie to each other "
         "(pairs.csv)."},
        {"output.checkpoint", true, "States to resume from."},
        {"tracers", true, "Points that the fluid carries along: tracers.csv."},
        {"tracers.seeds[]", true, "Where they are released: points along a line."},
        {"units", true, "What the lattice's units are worth; needed as soon as a value has a unit."},
    };
    return tables;
}

} // namespace vesica
