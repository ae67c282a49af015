#include "io/chunk_layout.hpp"
#include "io/compressed_chunks.hpp"
#include "io/field_samples.hpp"
#include "io/hdf5_array.hpp"
#include "io/placed_arrays.hpp"
#include "sample_run.hpp"
#include "scratch_directory.hpp"

#include <catch2/catch.hpp>
#include <fcntl.h>

using namespace vesica;

TEST_CASE("however a box is cut into blocks, every sample is in one of them") {
    for (const int stride : {1, 2, 3, 7}) {
        const FieldSampling sampling{{3, 0, 5}, {29, 20, 6}, stride};
        std::int64_t found = 0;
        for (const int cut : {4, 9, 16}) {
            found = 0;
            for (const int x : {0, cut})
                for (const int z : {0, 5, 6}) {
                    const Vec3<int> begin{x, 0, z};
                    const Vec3<int> end{x == 0 ? cut : 32, 32, z == 0 ? 5 : z == 5 ? 6 : 32};
                    const CellBox samples = sampling.samples_in({begin, end - begin});
                    found += samples.volume();
                    if (samples.volume() == 0)
                        continue;
                    for (int a = 0; a < 3; ++a) {
                        CHECK(sampling.cell_of(samples.begin)[a] >= begin[a]);
                        CHECK(sampling.cell_of(samples.begin + samples.size - Vec3<int>{1, 1, 1})[a] <
                              end[a]);
                    }
                }
            CHECK(found == CellBox({}, sampling.count()).volume());
        }
    }
}

TEST_CASE("chunks cover a box once, in whole planes or in rows of large planes") {
    for (const Vec3<int>& box :
         {Vec3<int>{64, 64, 64}, Vec3<int>{7, 5, 3}, Vec3<int>{600, 500, 9}, Vec3<int>{70000, 3, 2}}) {
        const ChunkLayout layout(box, 12);
        std::int64_t covered = 0;
        Vec3<int> next{};
        for (std::int64_t chunk = 0; chunk < layout.count(); ++chunk) {
            const CellBox elements = layout.elements(chunk);
            CHECK(elements.begin == next);
            covered += elements.volume();
            next.y += elements.size.y;
            if (next.y == box.y)
                next = {0, 0, next.z + elements.size.z};
        }
        CHECK(covered == CellBox({}, box).volume());
        CHECK((layout.bytes() <= 262144 || layout.edges().y * layout.edges().z == 1));
    }
}

TEST_CASE("parts written one by one make the whole array") {
    const ScratchDirectory scratch;
    const Vec3<int> whole{5, 4, 3};
    put_content(scratch / "a", std::string(7, '-'));
    const FileDescriptor file = open_file(scratch / "a", O_RDWR, "cannot open");
    const auto value_at = [](const Vec3<int>& place) {
        return static_cast<std::int16_t>(place.x + 10 * place.y + 100 * place.z);
    };
    for (const CellBox& part :
         {CellBox{{0, 0, 0}, {2, 4, 3}}, CellBox{{2, 0, 0}, {3, 1, 3}}, CellBox{{2, 1, 0}, {3, 3, 3}},
          CellBox{{0, 0, 2}, {5, 4, 1}}, CellBox{{0, 0, 0}, {5, 2, 2}}, CellBox{{1, 1, 1}, {0, 2, 2}}}) {
        std::vector<std::int16_t> values;
        for (int z = 0; z < part.size.z; ++z)
            for (int y = 0; y < part.size.y; ++y)
                for (int x = 0; x < part.size.x; ++x)
                    values.push_back(value_at(part.begin + Vec3<int>{x, y, z}));
        write_part(file, 7, whole, part, 2, std::as_bytes(std::span(values)), scratch / "a");
    }
    const std::string bytes = read_whole_file(scratch / "a");
    REQUIRE(bytes.size() == 7 + 2 * 60);
    std::size_t at = 7;
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 5; ++x, at += 2) {
                std::int16_t value = 0;
                std::copy_n(bytes.data() + at, 2, reinterpret_cast<char*>(&value));
                REQUIRE(value == value_at({x, y, z}));
            }
}

TEST_CASE("chunks beyond the ends of an array are read back as HDF5's own") {
    // Chunks of rows (a plane is more than a chunk holds), of several planes, and one that is all.
    for (const Vec3<int>& box : {Vec3<int>{300, 301, 3}, Vec3<int>{40, 41, 79}, Vec3<int>{3, 2, 1}}) {
        const ScratchDirectory scratch;
        const FieldSampling sampling{{0, 0, 0}, box, 1};
        const SampledField noise = sampled("noise", noise_field(box), sampling);
        SampledField three{"three", 3, {}, {}};
        for (std::size_t k = 0; k < 3 * noise.values.size(); ++k)
            three.values.push_back(static_cast<float>(k % 1001));
        write_field_step(scratch / "a.h5", {}, alone(sampling, 3), std::vector{noise, three}, Ranks());
        const Hdf5File file = open_hdf5(scratch / "a.h5");
        for (const SampledField& field : {noise, three}) {
            std::vector<float> found(field.values.size());
            read_rows(open_array(file, field.name, scratch / "a.h5"), H5T_NATIVE_FLOAT, 0,
                      static_cast<hsize_t>(box.z), found.data(), scratch / "a.h5");
            CHECK(found == field.values);
        }
    }
}
