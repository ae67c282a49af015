#include "lattice/field.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

using namespace vesica;

static_assert(std::is_same_v<decltype(std::declval<Field<double>&>().view()), FieldView<double>>);
static_assert(std::is_same_v<decltype(std::declval<const Field<double>&>().view()), FieldView<const double>>);
static_assert(std::is_convertible_v<FieldView<double>, FieldView<const double>>);
static_assert(!std::is_convertible_v<FieldView<const double>, FieldView<double>>);
static_assert(std::is_same_v<decltype(std::declval<FieldView<const float>>().component(0)), const float*>);
static_assert(!std::is_copy_constructible_v<Field<double>> &&
              std::is_nothrow_move_constructible_v<Field<double>>);

TEST_CASE("components start on cache lines and do not overlap", "[lattice]") {
    for (const std::int64_t cells :
         {std::int64_t{1}, std::int64_t{512}, std::int64_t{513}, std::int64_t{5000}}) {
        Field<double> field(19, cells);
        const FieldView<double> view = field.view();
        CHECK(view.stride >= cells);
        for (int k = 0; k < 19; ++k) {
            CHECK(reinterpret_cast<std::uintptr_t>(view.component(k)) % Field<double>::alignment == 0);
            view.component(k)[0] = k;
            view.component(k)[cells - 1] = k;
        }
        for (int k = 0; k < 19; ++k)
            CHECK((view.component(k)[0] == k && view.component(k)[cells - 1] == k));
        CHECK(field.bytes() == 19 * static_cast<std::size_t>(view.stride) * sizeof(double));
    }
}

TEST_CASE("the same cell of all nineteen directions never falls into one set of a cache of 64 sets",
          "[lattice]") {
    // A stride that is a multiple of 4096 bytes would map every direction onto the same set.
    for (const std::int64_t cells : {std::int64_t{4096}, std::int64_t{32768}, std::int64_t{100000}}) {
        const Field<float> field(19, cells);
        int most = 0;
        int in_set[64] = {};
        for (int k = 0; k < 19; ++k) {
            const auto line = static_cast<std::size_t>(k * field.stride()) * sizeof(float) / 64;
            most = std::max(most, ++in_set[line % 64]);
        }
        CHECK(most == 1);
    }
}

TEST_CASE("a view of a constant field sees what was written through the other", "[lattice]") {
    Field<double> field(2, 10);
    field.view().component(1)[7] = 42.0;
    const Field<double>& constant = field;
    CHECK(constant.view().component(1)[7] == 42.0);
    const FieldView<const double> looked = field.view();
    CHECK(looked.component(1)[7] == 42.0);
}
