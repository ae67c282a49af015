#include "core/input_error.hpp"
#include "io/field_series.hpp"
#include "io/hdf5_array.hpp"
#include "io/surface_series.hpp"
#include "sample_run.hpp"
#include "small_disk.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>

using namespace vesica;

TEST_CASE("samples are cubes of the stride's width around the centres of their cells") {
    const FieldSampling whole{{0, 0, 0}, {8, 6, 4}, 1};
    REQUIRE(whole.count() == Vec3<int>{8, 6, 4});
    REQUIRE(whole.origin() == Vec3<double>{0.0, 0.0, 0.0});
    const FieldSampling part{{2, 1, 0}, {8, 6, 4}, 3}; // x = 2, 5; y = 1, 4; z = 0, 3
    REQUIRE(part.count() == Vec3<int>{2, 2, 2});
    REQUIRE(part.origin() == Vec3<double>{1.0, 0.0, -1.0});
}

TEST_CASE("a step's file holds the sampled values of the fields") {
    const ScratchDirectory scratch;
    const FieldSampling sampling{{2, 1, 0}, {8, 6, 4}, 3};
    const DenseField phase = ramp_field({8, 6, 4}, 1), velocity = ramp_field({8, 6, 4}, 3);
    for (const int level : {0, 4}) {
        const std::vector<SampledField> fields = {sampled("phase", phase, sampling),
                                                  sampled("velocity", velocity, sampling, 2.0, "m/s")};
        const FieldStep written = write_field_step(scratch / "a.h5", {7, 0.5, {}, {1.0, 2.0, 3.0}, 0.25, {}},
                                                   alone(sampling, level), fields, Ranks());
        const FieldStep read = read_field_step(scratch / "a.h5");
        REQUIRE(read.step == 7);
        REQUIRE(read.time == 0.5);
        REQUIRE(read.origin == Vec3<double>{1.0, 2.0, 3.0});
        REQUIRE(read.spacing == 0.25);
        REQUIRE(read.count == written.count);
        REQUIRE(read.arrays.size() == 2);
        REQUIRE(read.arrays[1].name == "velocity");
        REQUIRE(read.arrays[1].components == 3);

        const Hdf5File file = open_hdf5(scratch / "a.h5");
        const Hdf5Dataset array = open_array(file, "velocity", scratch / "a.h5");
        REQUIRE(shape_of(array, scratch / "a.h5") == std::vector<hsize_t>{2, 2, 2, 3});
        REQUIRE(read_text_attribute(array, "unit", scratch / "a.h5") == "m/s");
        std::vector<float> values(24);
        read_rows(array, H5T_NATIVE_FLOAT, 0, 2, values.data(), scratch / "a.h5");
        std::size_t next = 0;
        for (const int z : {0, 3})
            for (const int y : {1, 4})
                for (const int x : {2, 5})
                    for (int c = 0; c < 3; ++c)
                        REQUIRE(values[next++] == static_cast<float>(2.0 * ramp_value(x, y, z, c)));
    }
}

TEST_CASE("a resumed series of fields has the steps up to the checkpoint and goes on") {
    const ScratchDirectory scratch, other;
    write_sample_fields(scratch.path(), {0, 100, 200});
    FieldSeries series = FieldSeries::resume(scratch.path(), sample_options(), 150);
    REQUIRE_FALSE(exists(scratch / "fields/step_000000200.h5"));
    REQUIRE(content_of(scratch / "fields.xmf").find("step 200") == std::string::npos);
    write_step(series, 200, sample_options().sampling, sample_fields());
    write_sample_fields(other.path(), {0, 100, 200});
    REQUIRE(content_of(scratch / "fields.xmf") == content_of(other / "fields.xmf"));
    REQUIRE(content_of(scratch / "fields.h5") == content_of(other / "fields.h5"));
    REQUIRE(content_of(scratch / "fields/step_000000200.h5") ==
            content_of(other / "fields/step_000000200.h5"));
}

TEST_CASE("a resumed series of surfaces has the steps up to the checkpoint and goes on") {
    const ScratchDirectory scratch, other;
    write_sample_surfaces(scratch.path(), {0, 100, 200});
    SurfaceSeries series = SurfaceSeries::resume(scratch.path(), Scales{}, 150);
    REQUIRE_FALSE(exists(scratch / "surfaces/surface_000000200.vtp"));
    series.write(200, sample_surfaces());
    write_sample_surfaces(other.path(), {0, 100, 200});
    REQUIRE(content_of(scratch / "surfaces/surfaces.pvd") == content_of(other / "surfaces/surfaces.pvd"));
}

TEST_CASE("on a full disk a series keeps its earlier steps and leaves no half file") {
    const SmallDisk disk("1m");
    if (!disk.mounted())
        return; // only root can mount one
    write_sample_fields(disk.path(), {0});
    write_sample_surfaces(disk.path(), {0});
    const std::string picture = content_of(disk / "fields.xmf");
    disk.fill_but(0);
    REQUIRE_THAT(complaint_of<RunError>([&] { FieldSeries::resume(disk.path(), sample_options(), 0); }),
                 Catch::Contains("No space left on device"));
    REQUIRE(content_of(disk / "fields.xmf") == picture);

    SECTION("compressed fields") {
        const DenseField phase = noise_field({32, 32, 32});
        FieldSeries::Options options;
        options.sampling = {{0, 0, 0}, {32, 32, 32}, 1};
        std::filesystem::remove(disk / "filling");
        disk.fill_but(65536);
        FieldSeries series(disk.path(), options);
        REQUIRE_THAT(complaint_of<RunError>([&] {
                         write_step(series, 100, options.sampling,
                                    {sampled("phase", phase, options.sampling)});
                     }),
                     Catch::Contains("fields: ") && Catch::Contains("MB are needed"));
    }
    SECTION("surfaces") {
        SurfaceSeries series(disk.path(), Scales{});
        REQUIRE_THAT(complaint_of<RunError>([&] { series.write(100, sample_surfaces()); }),
                     Catch::EndsWith("surface_000000100.vtp: cannot write: No space left on device"));
    }
    REQUIRE(read_field_step(disk / "fields/step_000000000.h5").arrays.size() == 2);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(disk.path()))
        REQUIRE_THAT(entry.path().string(), !Catch::EndsWith(".partial"));
}

TEST_CASE("the sample that other programs read is written", "[.sample]") {
    const char* directory = std::getenv("VESICA_SAMPLE_DIR");
    REQUIRE(directory != nullptr);
    write_sample_fields(directory, {0, 100});
    write_sample_surfaces(directory, {0, 100});
}
