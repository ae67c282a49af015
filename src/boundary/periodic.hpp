#pragma once

#include "lattice/grid.hpp"
#include "lattice/populations.hpp"

#include <cstring>

namespace vesica {

/// Periodic boundaries by ghost cells, one axis at a time so that edges travel through faces. Only the five
/// slots that cross a face are copied. After a step on `arrived` populations the ghosts need what left the
/// box on the other side (publish, x then y then z); after a step on `turned` ones what was written into
/// ghosts belongs to the other side (collect, z then y then x).
template <class Real>
class PeriodicBoundary {
public:
    PeriodicBoundary() = default;
    PeriodicBoundary(const PopulationView<Real>& populations, const Grid& grid)
        : f_(populations), grid_(grid) {}

    /// Ghosts at both ends of one row along x.
    void publish_row(int y, int z) const {
        const int end = grid_.size().x;
        copy_cells<-1>(grid_.index(end - 1, y, z), grid_.index(-1, y, z));
        copy_cells<1>(grid_.index(0, y, z), grid_.index(end, y, z));
    }
    void collect_row(int y, int z) const {
        const int end = grid_.size().x;
        copy_cells<-1>(grid_.index(-1, y, z), grid_.index(end - 1, y, z));
        copy_cells<1>(grid_.index(end, y, z), grid_.index(0, y, z));
    }

    /// Ghost rows below and above one plane of rows: axis 1 for row z, axis 2 for row y.
    void publish_y(int z) const {
        const int end = grid_.size().y;
        copy_row<1, -1>(row(end - 1, z), row(-1, z));
        copy_row<1, 1>(row(0, z), row(end, z));
    }
    void collect_y(int z) const {
        const int end = grid_.size().y;
        copy_row<1, -1>(row(-1, z), row(end - 1, z));
        copy_row<1, 1>(row(end, z), row(0, z));
    }
    /// y may be a ghost row.
    void publish_z(int y) const {
        const int end = grid_.size().z;
        copy_row<2, -1>(row(y, end - 1), row(y, -1));
        copy_row<2, 1>(row(y, 0), row(y, end));
    }
    void collect_z(int y) const {
        const int end = grid_.size().z;
        copy_row<2, -1>(row(y, -1), row(y, end - 1));
        copy_row<2, 1>(row(y, end), row(y, 0));
    }

private:
    std::int64_t row(int y, int z) const { return grid_.index(-1, y, z); }

    template <int sign>
    void copy_cells(std::int64_t from, std::int64_t to) const {
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            if constexpr (velocity(decltype(i)::value, 0) == sign)
                f_.slot(i)[to] = f_.slot(i)[from];
        });
    }

    template <int axis, int sign>
    void copy_row(std::int64_t from, std::int64_t to) const {
        const std::size_t bytes = static_cast<std::size_t>(grid_.size().x + 2) * sizeof(Real);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            if constexpr (velocity(decltype(i)::value, axis) == sign)
                std::memcpy(f_.slot(i) + to, f_.slot(i) + from, bytes);
        });
    }

    PopulationView<Real> f_;
    Grid grid_;
};

} // namespace vesica
