#include "simulation/engine.hpp"

#include "core/input_error.hpp"
#include "parallel/agreement.hpp"
#include "simulation/block_plan.hpp"
#include "simulation/engine_entries.hpp"
#include "simulation/instruction_set.hpp"

namespace vesica {

namespace {

struct InstructionSet {
    std::string_view name;
    std::unique_ptr<Engine> (*in_double)(const EngineSetup&);
    std::unique_ptr<Engine> (*in_single)(const EngineSetup&);
};

/// Those of this build, best first.
constexpr InstructionSet instruction_sets[] = {
#ifdef VESICA_HAS_ISA_AVX512
    {"avx512", isa_entry_avx512_make_double_engine, isa_entry_avx512_make_single_engine},
#endif
#ifdef VESICA_HAS_ISA_AVX2
    {"avx2", isa_entry_avx2_make_double_engine, isa_entry_avx2_make_single_engine},
#endif
    {"baseline", isa_entry_baseline_make_double_engine, isa_entry_baseline_make_single_engine},
};

} // namespace

namespace {

class SavedPlanes final : public StatePlanes {
public:
    explicit SavedPlanes(EngineState state) : state_(std::move(state)), planes_(state_) {}

    const StateHead& head() const override { return planes_.head(); }
    bool all_floats() const override { return planes_.all_floats(); }
    std::size_t population_count() const override { return planes_.population_count(); }
    void population(std::size_t i, int z, std::span<double> plane) const override {
        planes_.population(i, z, plane);
    }
    std::size_t slots() const override { return planes_.slots(); }
    bool is_labelled() const override { return planes_.is_labelled(); }
    void minority(std::size_t slot, int z, std::span<double> plane) const override {
        planes_.minority(slot, z, plane);
    }
    void band(std::size_t slot, int z, std::span<std::uint8_t> plane) const override {
        planes_.band(slot, z, plane);
    }
    void label(std::size_t slot, int z, std::span<std::int32_t> plane) const override {
        planes_.label(slot, z, plane);
    }

private:
    EngineState state_;
    PlanesOfState planes_;
};

} // namespace

std::unique_ptr<StatePlanes> Engine::planes() const {
    return std::make_unique<SavedPlanes>(save());
}

std::vector<VesicleSnapshot> Engine::vesicles(int first, int count) const {
    std::vector<VesicleSnapshot> all = snapshot().vesicles;
    if (all.empty())
        return all;
    return {std::make_move_iterator(all.begin() + first),
            std::make_move_iterator(all.begin() + first + count)};
}

const std::vector<std::string>& field_names() {
    static const std::vector<std::string> names{
        "phase",         "density",        "velocity",           "pressure",
        "force",         "mean_curvature", "gaussian_curvature", "normal",
        "bending_force", "tension_force",  "area_force"};
    return names;
}

std::unique_ptr<Engine> make_engine(const Parameters& parameters, int threads,
                                    std::string_view instruction_set) {
    const BlockLayout alone(parameters.lattice(), {1, 1, 1}, slide_of(parameters));
    return make_engine(parameters, threads, std::make_shared<const Neighbourhood>(Ranks(), alone),
                       instruction_set);
}

std::unique_ptr<Engine> make_engine(const Parameters& parameters, int threads,
                                    std::shared_ptr<const Neighbourhood> neighbourhood,
                                    std::string_view instruction_set) {
    const Ranks ranks = neighbourhood->ranks();
    EngineSetup setup =
        agreed(ranks, [&] { return make_engine_setup(parameters, threads, std::move(neighbourhood)); });
    for (const InstructionSet& set : instruction_sets) {
        if (!instruction_set.empty() && set.name != instruction_set)
            continue;
        if (!instruction_set_runs_here(set.name)) {
            if (instruction_set.empty())
                continue;
            throw InputError("instruction set " + std::string(instruction_set) +
                             " is not supported by this machine");
        }
        setup.instruction_set = set.name;
        return setup.precision == Precision::single_precision ? set.in_single(setup) : set.in_double(setup);
    }
    throw InputError("instruction set \"" + std::string(instruction_set) + "\" is unknown to this build");
}

} // namespace vesica
