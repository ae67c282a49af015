#pragma once

#include "core/real.hpp"
#include "lattice/populations.hpp"
#include "lattice/sliding_faces.hpp"

#include <vector>

namespace vesica {

/// Shear without walls (Lees and Edwards 1972; Wagner and Pagonabarraga 2002): the images above the box move
/// past it, those below the other way. What leaves through a sliding face is seen from the image it enters:
/// `correct` changes its velocity, with the equilibria of both, and `slide` moves it along the face by the
/// images' displacement. The crossing populations' sum does not depend on the velocity along the face, and
/// the cubic's weights add up to one: no mass comes or goes.
template <class Real>
class LeesEdwards {
public:
    LeesEdwards(const PopulationView<Real>& populations, const Grid& grid, const Block& block,
                double reference_density)
        : f_(populations), grid_(grid), faces_(grid, block), rho0_(reference_density) {
        const std::size_t lines = faces_.faces().empty() ? 0 : static_cast<std::size_t>(this->lines());
        scratch_.resize(faces_.faces().size() * lines * stretch());
    }

    const SlidingFaces& faces() const { return faces_; }

    /// Of the step to come: where the images are at its beginning, and how fast they move, cells/step.
    void set(double displacement, double speed) {
        displacement_ = Displacement::of(displacement, grid_.size()[faces_.slide().velocity]);
        speed_ = speed;
    }

    /// One of faces().rows() rows of cells along each face, which have done their step; nothing has been
    /// exchanged yet. V is a pack of a tile's values.
    template <Streaming streaming, class V>
    void correct(std::int64_t row) const {
        faces_.for_each_tile(row, [&](const SlidingFaces::Face& face, std::int64_t cell, unsigned bits) {
            correct_tile<streaming, V>(face.towards, cell, bits);
        });
    }

    /// The ghosts beyond the faces hold what left: after a step on `arrived` populations what left the images
    /// there, once it has been published; after one on `turned` populations what left the block, before it is
    /// collected. One of the lines() of each face, those of ghosts beside it too.
    int lines() const { return grid_.size()[faces_.beside()] + 2; }
    template <Streaming streaming>
    void slide(std::int64_t line) {
        for (std::size_t k = 0; k < faces_.faces().size(); ++k)
            slide_line<streaming>(
                faces_.faces()[k], static_cast<int>(line) - 1,
                scratch_.data() +
                    (k * static_cast<std::size_t>(lines()) + static_cast<std::size_t>(line)) * stretch());
    }

private:
    template <Streaming streaming, class V>
    void correct_tile(int towards, std::int64_t cell, unsigned bits) const {
        const int along = faces_.slide().velocity;
        const int across = faces_.slide().gradient;
        V rho = V(rho0_);
        V j_along = V(0);
        V j_across = V(0);
        V j_beside = V(0);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            const V g = V::load(f_.template departing<streaming, decltype(i)::value>(cell));
            rho += g;
            j_along += V(velocity(i, along)) * g;
            j_across += V(velocity(i, across)) * g;
            j_beside += V(velocity(i, faces_.beside())) * g;
        });
        const V change = V(-towards * speed_);
        const V u = j_along / rho;
        // f_eq(u + change) - f_eq(u), rho times t_i of it.
        const V common = V(-3) * change * (u + V(0.5) * change);
        for_each_direction([&](auto i) VESICA_INLINE_LAMBDA {
            if (velocity(i, across) != towards)
                return;
            const V c_along = V(velocity(i, along));
            const V c_u = (V(velocity(i, across)) * j_across + c_along * j_along +
                           V(velocity(i, faces_.beside())) * j_beside) /
                          rho;
            const V own = c_along * change * (V(3) + V(9) * c_u + V(4.5) * c_along * change);
            Real* const place = f_.template departing<streaming, decltype(i)::value>(cell);
            const V g = V::load(place);
            select<Real>(V::mask(bits), fma(V(weight(i)) * rho, common + own, g), g).store(place);
        });
    }

    /// A line's values, and those that a cubic at its last one reads beyond it.
    std::size_t stretch() const {
        return static_cast<std::size_t>(grid_.size()[faces_.slide().velocity] + Displacement::reads - 1);
    }

    /// `turned` is room for stretch() values.
    template <Streaming streaming>
    void slide_line(const SlidingFaces::Face& face, int beside, Real* turned) const {
        const Slide& slide = faces_.slide();
        const int length = grid_.size()[slide.velocity];
        Vec3<int> first{};
        first[slide.gradient] = face.ghosts;
        first[faces_.beside()] = beside;
        Vec3<int> unit{};
        unit[slide.velocity] = 1;
        const std::int64_t stride = grid_.offset(unit.x, unit.y, unit.z);
        // Value k comes to lie between k + lowest and the reads - 1 after it.
        const bool is_forward = (face.towards > 0) == (streaming == Streaming::turned);
        const int lowest =
            is_forward ? displacement_.whole - 1 : 2 - Displacement::reads - displacement_.whole;
        const int start = ((lowest % length) + length) % length;
        Real weights[Displacement::reads];
        for (int n = 0; n < Displacement::reads; ++n)
            weights[n] = static_cast<Real>(
                displacement_
                    .weights[static_cast<std::size_t>(is_forward ? n : Displacement::reads - 1 - n)]);
        for (int i = 0; i < direction_count; ++i) {
            if (velocity(i, slide.gradient) != face.towards)
                continue;
            // Ghosts at the line's ends stand for its other end where the slot leads there.
            Real* const values = f_.slot(i) + grid_.index(first) + velocity(i, slide.velocity) * stride;
            int from = start;
            for (int k = 0; k < length + Displacement::reads - 1; ++k) {
                turned[k] = values[from * stride];
                from = from + 1 == length ? 0 : from + 1;
            }
            for (int k = 0; k < length; ++k) {
                Real sum = Real(0);
                for (int n = 0; n < Displacement::reads; ++n)
                    sum += weights[n] * turned[k + n];
                values[k * stride] = sum;
            }
        }
    }

    PopulationView<Real> f_;
    Grid grid_;
    SlidingFaces faces_;
    double rho0_ = 1.0;
    Displacement displacement_;
    double speed_ = 0.0;
    std::vector<Real> scratch_; ///< a stretch per line and face
};

} // namespace vesica
