#pragma once

#include "kernels/per_cell.hpp"
#include "lattice/band.hpp"
#include "lattice/field.hpp"
#include "simulation/layer_fields.hpp"

#include <memory>
#include <span>
#include <vector>

namespace vesica {

/// The compact arrays of a band that fills a whole periodic box, with numbers of ordinary size in them: what
/// a kernel of the layer reads and writes, addressed as in a simulation, in as small or large a box as one
/// likes.
template <class Real>
class Surroundings {
public:
    explicit Surroundings(const Vec3<int>& size) : grid_(size), band_(grid_) {
        std::vector<Band::Seed> all;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; x += tile_width)
                    all.push_back({grid_.index(x, y, z) / tile_width, 0xff});
        band_.rebuild(all);
        fields.resize(band_.compact_size());
        results_ = Field<Real>(1, band_.compact_size());
        result = {results_.view().component(0), static_cast<std::size_t>(band_.compact_size())};
        populations = Field<Real>(direction_count, band_.compact_size());
        fill();
    }

    const Band& band() const { return band_; }
    const Vec3<int>& size() const { return grid_.size(); }
    std::int64_t cells() const { return grid_.volume(); }

    LayerFields<Real> fields;
    std::span<Real> result;  ///< for what a kernel computes and none reads
    Field<Real> populations; ///< deviations, by compact address

private:
    void fill() {
        const auto fill = [](std::span<Real> a, double lowest, double width) {
            for (std::size_t k = 0; k < a.size(); ++k)
                a[k] = static_cast<Real>(lowest + width * static_cast<double>(k * 37 % 101) / 101.0);
        };
        fill(fields.chi, -0.4, 0.8);
        fill(fields.density, 0.99, 0.02);
        fill(fields.s, -2.0, 4.0);
        fill(fields.sharp, -2.0, 4.0);
        fill(fields.raw_H0, 0.05, 0.1);
        fill(fields.K0, 0.0, 0.01);
        fill(fields.J, 0.8, 0.4);
        for (std::size_t a = 0; a < 3; ++a) {
            fill(fields.n[a], 0.5, 0.1);
            fill(fields.w[a], -0.05, 0.1);
            fill(fields.g[a], -0.001, 0.002);
        }
        for (int i = 0; i < direction_count; ++i)
            std::fill_n(populations.view().component(i), band_.compact_size(), static_cast<Real>(1e-4 * i));
    }

    Grid grid_;
    Band band_;
    Field<Real> results_;
};

/// One at a time: benchmarks of the same size follow each other.
template <class Real>
Surroundings<Real>& surroundings(const Vec3<int>& size) {
    static std::unique_ptr<Surroundings<Real>> kept;
    if (kept == nullptr || kept->size().x != size.x || kept->size().y != size.y) {
        kept.reset(); // before the next one is built
        kept = std::make_unique<Surroundings<Real>>(size);
    }
    return *kept;
}

/// Arrays that lie in a first-level cache (a few kilobytes each), in a second-level one, and in memory.
inline constexpr Vec3<int> surroundings_sizes[] = {{16, 4, 4}, {16, 16, 16}, {128, 128, 128}};

/// Registers `kernel(surroundings, run)`, to be called for every run of tiles of the box.
template <class Real, class Kernel>
void add_kernel(const std::string& name, const char* isa_name, const Vec3<int>& size, const Kernel& kernel) {
    const std::int64_t cells = Grid(size).volume();
    benchmark::RegisterBenchmark(
        benchmark_name<Real>(name, isa_name, cells).c_str(), [=](benchmark::State& state) {
            Surroundings<Real>& here = surroundings<Real>(size);
            for (auto _ : state) {
                for_each_run<Real>(here.band(), here.band().of_level(Band::outermost), 0,
                                   static_cast<std::int64_t>(here.band().tiles().size()),
                                   [&](const auto& t, std::size_t) { kernel(here, t); });
                benchmark::ClobberMemory();
            }
            report_cells(state, here.cells());
        });
}

/// Calls add.template operator()<Real>(size) for both precisions and all sizes.
template <class Add>
void for_precisions_and_sizes(const Add& add) {
    for (const Vec3<int>& size : surroundings_sizes)
        add.template operator()<double>(size);
    for (const Vec3<int>& size : surroundings_sizes)
        add.template operator()<float>(size);
}

} // namespace vesica
