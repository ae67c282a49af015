#include "core/input_error.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/checkpoint_store.hpp"
#include "io/state_file.hpp"
#include "small_disk.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <thread>

using namespace vesica;

namespace {

/// A state of awkward numbers: every exponent, both zeros, infinities, quiet NaNs with a payload, denormals.
Checkpoint awkward_checkpoint(Precision precision, Vec3<int> size = {7, 5, 3}) {
    std::mt19937_64 random(20210901);
    Checkpoint checkpoint;
    EngineState& state = checkpoint.engine;
    state.step = 123456;
    state.precision = precision;
    state.size = size;
    state.part = {{}, size};
    const auto cells = static_cast<std::size_t>(size.x * size.y * size.z);
    const auto number = [&]() -> double {
        if (precision == Precision::double_precision)
            return std::bit_cast<double>(random() | (1ULL << 51));
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(random()) | (1U << 22)));
    };
    state.populations.assign(19, std::vector<double>(cells));
    for (auto& row : state.populations)
        for (double& value : row)
            value = number();
    state.populations[3][0] = -0.0;
    state.populations[3][1] = std::numeric_limits<float>::denorm_min();
    for (std::size_t i = 0; i < cells; ++i) {
        state.minority.push_back(number());
        state.band.push_back(static_cast<std::uint8_t>(random()));
    }
    state.controllers = {1.0 / 3.0, -2e-300, 0.1};
    using namespace std::string_literals;
    checkpoint.case_text = "title = \"caf\xc3\xa9\"\n\0with a zero byte"s;
    checkpoint.notes = {
        {"initial_mass", {1.0 / 7.0}}, {"nothing", {}}, {"unwrapped centre", {1.5, -2.5, 1e-9}}};
    checkpoint.program_version = "0.1.0";
    return checkpoint;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void require_same(const Checkpoint& a, const Checkpoint& b) {
    REQUIRE(a.engine.step == b.engine.step);
    REQUIRE(a.engine.precision == b.engine.precision);
    REQUIRE(a.engine.size == b.engine.size);
    REQUIRE(a.engine.populations.size() == b.engine.populations.size());
    for (std::size_t i = 0; i < a.engine.populations.size(); ++i)
        REQUIRE(same_bits(a.engine.populations[i], b.engine.populations[i]));
    REQUIRE(same_bits(a.engine.minority, b.engine.minority));
    REQUIRE(same_bits(a.engine.controllers, b.engine.controllers));
    REQUIRE(a.engine.band == b.engine.band);
    REQUIRE(a.engine.label == b.engine.label);
    REQUIRE(a.case_text == b.case_text);
    REQUIRE(a.program_version == b.program_version);
    REQUIRE(a.notes.size() == b.notes.size());
    for (const auto& [name, values] : a.notes)
        REQUIRE(same_bits(values, b.notes.at(name)));
}

std::string refusal(const std::filesystem::path& path) {
    return complaint_of<RunError>([&] { read_checkpoint(path); });
}

} // namespace

TEST_CASE("a checkpoint read is the checkpoint written, bit for bit") {
    const ScratchDirectory scratch;
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
        const Checkpoint written = awkward_checkpoint(precision);
        write_checkpoint(scratch / "a.h5", written);
        require_same(written, read_checkpoint(scratch / "a.h5"));
    }
}

TEST_CASE("the colours of several vesicles survive slot by slot, as a whole and part by part") {
    const ScratchDirectory scratch;
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
        Checkpoint written = awkward_checkpoint(precision);
        EngineState& state = written.engine;
        const std::size_t cells = state.minority.size();
        for (std::size_t at = 0; at < 2 * cells; ++at) {
            state.minority.push_back(state.minority[at]);
            state.band.push_back(static_cast<std::uint8_t>(at % 4));
        }
        for (std::size_t at = 0; at < 3 * cells; ++at)
            state.label.push_back(static_cast<std::int32_t>(at) - 1);
        REQUIRE(state.slots() == 3);
        write_checkpoint(scratch / "a.h5", written);
        require_same(written, read_checkpoint(scratch / "a.h5"));

        const CellBox part{{2, 1, 1}, {4, 3, 2}};
        const EngineState read = read_state(scratch / "a.h5", part);
        REQUIRE(read.slots() == 3);
        std::size_t to = 0;
        for (std::size_t slot = 0; slot < 3; ++slot)
            for (int z = 1; z < 3; ++z)
                for (int y = 1; y < 4; ++y)
                    for (int x = 2; x < 6; ++x, ++to) {
                        const std::size_t from = slot * cells + static_cast<std::size_t>((z * 5 + y) * 7 + x);
                        REQUIRE(read.label[to] == state.label[from]);
                        REQUIRE(read.band[to] == state.band[from]);
                    }
    }
}

TEST_CASE("a single precision checkpoint takes half the space, unless a value is not a float") {
    const ScratchDirectory scratch;
    const Vec3<int> size{32, 32, 32};
    Checkpoint checkpoint = awkward_checkpoint(Precision::double_precision, size);
    write_checkpoint(scratch / "double.h5", checkpoint);
    checkpoint = awkward_checkpoint(Precision::single_precision, size);
    write_checkpoint(scratch / "single.h5", checkpoint);
    const auto reals = 20.0 * 32 * 32 * 32;
    REQUIRE(static_cast<double>(file_size(scratch / "double.h5")) == Approx(reals * 8).epsilon(0.02));
    REQUIRE(static_cast<double>(file_size(scratch / "single.h5")) == Approx(reals * 4).epsilon(0.02));

    checkpoint.engine.populations[18].back() = 0.1;
    write_checkpoint(scratch / "mixed.h5", checkpoint);
    require_same(checkpoint, read_checkpoint(scratch / "mixed.h5"));
}

TEST_CASE("a checkpoint without vesicles and cells survives too") {
    const ScratchDirectory scratch;
    Checkpoint empty;
    write_checkpoint(scratch / "a.h5", empty);
    require_same(empty, read_checkpoint(scratch / "a.h5"));
}

TEST_CASE("the same checkpoint gives the same bytes, later too") {
    const ScratchDirectory scratch;
    write_checkpoint(scratch / "a.h5", awkward_checkpoint(Precision::double_precision));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // HDF5 counts time in seconds, if it does
    write_checkpoint(scratch / "b.h5", awkward_checkpoint(Precision::double_precision));
    REQUIRE(content_of(scratch / "a.h5") == content_of(scratch / "b.h5"));
}

TEST_CASE("no flipped bit is ever accepted") {
    const ScratchDirectory scratch;
    const auto path = scratch / "a.h5";
    write_checkpoint(path, awkward_checkpoint(Precision::double_precision));
    const std::string good = content_of(path);
    std::mt19937_64 random(7);
    const auto refuses_flip = [&](std::size_t bit) {
        std::string bad = good;
        bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << (bit % 8)));
        put_content(path, bad);
        return refusal(path).find(path.string()) == 0;
    };
    for (int i = 0; i < 200; ++i)
        REQUIRE(refuses_flip(random() % (good.size() * 8)));
    for (std::size_t bit = 0; bit < 128 * 8; ++bit)
        REQUIRE(refuses_flip(bit));
    for (int i = 0; i < 100; ++i)
        REQUIRE(refuses_flip(random() % (seal_bytes * 8)));
    put_content(path, good);
    REQUIRE(refusal(path).empty());
}

TEST_CASE("no cut and no lengthening is ever accepted") {
    const ScratchDirectory scratch;
    const auto path = scratch / "a.h5";
    write_checkpoint(path, awkward_checkpoint(Precision::double_precision));
    const std::string good = content_of(path);
    for (std::size_t length = 0; length < good.size(); length += 4096) {
        for (const std::size_t cut : {length, length + 1, length + 4095}) {
            if (cut >= good.size())
                continue;
            put_content(path, good.substr(0, cut));
            REQUIRE(refusal(path).find(path.string()) == 0);
        }
    }
    // What a crash of the machine can leave of a file whose length was already written: zeros.
    put_content(path, good.substr(0, good.size() - 4096) + std::string(4096, '\0'));
    REQUIRE_THAT(refusal(path), Catch::Contains("its content does not agree with its digest"));
    put_content(path, good + '\0');
    REQUIRE_THAT(refusal(path), Catch::Contains("1 bytes follow its end"));
}

TEST_CASE("the refusal of a checkpoint says what is wrong with it") {
    const ScratchDirectory scratch;
    const auto path = scratch / "a.h5";
    REQUIRE_THAT(refusal(path), Catch::EndsWith("a.h5: cannot open: No such file or directory"));
    REQUIRE_THAT(refusal(scratch.path()), Catch::EndsWith("is not a regular file"));
    put_content(path, "");
    REQUIRE_THAT(refusal(path), Catch::EndsWith("a.h5: is empty"));
    put_content(path, std::string(10000, 'x'));
    REQUIRE_THAT(refusal(path), Catch::EndsWith("a.h5: is not a checkpoint of Vesica"));

    write_checkpoint(path, awkward_checkpoint(Precision::double_precision));
    const std::string good = content_of(path);
    put_content(path, good.substr(0, 1000));
    REQUIRE_THAT(refusal(path),
                 Catch::EndsWith("is truncated: 1000 bytes are left, its seal alone has 4096"));
    put_content(path, good.substr(0, 5000));
    REQUIRE_THAT(refusal(path),
                 Catch::EndsWith("is truncated: 5000 of " + std::to_string(good.size()) + " bytes are left"));
    std::string bad = good;
    bad[2000] = 'x';
    put_content(path, bad);
    REQUIRE_THAT(refusal(path), Catch::EndsWith("the first 4096 bytes do not agree with their digest"));

    std::string later = good; // a file of another version, with the right digest of its seal
    later[8] = 2;
    later.replace(48, 16, 16, '\0');
    const Digest digest = digest_of(std::string_view(later).substr(0, seal_bytes));
    later.replace(48, 16, reinterpret_cast<const char*>(digest.data()), 16);
    put_content(path, later);
    REQUIRE_THAT(refusal(path),
                 Catch::EndsWith("has version 2 of the checkpoint format; this program reads version 1"));
}

TEST_CASE("a sealed file with foreign content is refused, not believed") {
    const ScratchDirectory scratch;
    AtomicFile file(scratch / "a.h5");
    std::string foreign(seal_bytes, '\0');
    foreign += "not HDF5 at all";
    file.write(foreign);
    Colleagues nobody;
    seal(file, "foreign", nobody);
    file.commit();
    REQUIRE_THAT(refusal(scratch / "a.h5"),
                 Catch::EndsWith("a.h5: cannot open as HDF5: file signature not found"));
}

TEST_CASE("the summary of a checkpoint tells what it holds") {
    const ScratchDirectory scratch;
    write_checkpoint(scratch / "a.h5", awkward_checkpoint(Precision::single_precision));
    const CheckpointSummary summary = summarise_checkpoint(scratch / "a.h5");
    REQUIRE(summary.step == 123456);
    REQUIRE(summary.precision == Precision::single_precision);
    REQUIRE(summary.size == Vec3<int>{7, 5, 3});
    REQUIRE(summary.program_version == "0.1.0");
    REQUIRE(summary.bytes == file_size(scratch / "a.h5"));
    REQUIRE(summary.arrays.at(0) == "populations [19, 105]");
    REQUIRE(summary.arrays.at(4) == "notes/initial_mass [1]");
}

TEST_CASE("the digest of a file is the digest of its blocks' digests") {
    const ScratchDirectory scratch;
    std::string content(2 * digest_block_bytes + 12345, '\0');
    std::mt19937_64 random(1);
    for (char& byte : content)
        byte = static_cast<char>(random());
    put_content(scratch / "a", content);
    const std::string_view all = content;
    const std::vector<Digest> blocks = {digest_of(all.substr(3, digest_block_bytes)),
                                        digest_of(all.substr(3 + digest_block_bytes, digest_block_bytes)),
                                        digest_of(all.substr(3 + 2 * digest_block_bytes))};
    const FileDescriptor file = open_file(scratch / "a", 0, "cannot open");
    REQUIRE(digest_of_file(file, 3, content.size() - 3, scratch / "a") == combine_digests(blocks));
}

TEST_CASE("the store keeps the newest checkpoints and falls back behind damaged ones") {
    const ScratchDirectory scratch;
    const auto directory = scratch / "checkpoints";
    const CheckpointStore store(directory, 2);
    Checkpoint checkpoint = awkward_checkpoint(Precision::double_precision);
    for (const std::int64_t step : {100, 200, 300}) {
        checkpoint.engine.step = step;
        REQUIRE(store.write(checkpoint) == checkpoint_path(directory, step));
    }
    REQUIRE_FALSE(exists(checkpoint_path(directory, 100)));
    REQUIRE(newest_intact_checkpoint(directory).checkpoint.engine.step == 300);

    const auto newest = checkpoint_path(directory, 300);
    const std::string good = content_of(newest);
    put_content(newest, good.substr(0, good.size() / 2));
    const IntactCheckpoint found = newest_intact_checkpoint(directory);
    REQUIRE(found.checkpoint.engine.step == 200);
    REQUIRE(found.path == checkpoint_path(directory, 200));
    REQUIRE(found.refused.size() == 1);
    REQUIRE_THAT(found.refused[0], Catch::Contains("step_000000300.h5: is truncated"));

    SECTION("a damaged later checkpoint does not push out intact ones") {
        const CheckpointStore narrow(directory, 1);
        checkpoint.engine.step = 250;
        narrow.write(checkpoint);
        REQUIRE(exists(newest));
        REQUIRE(newest_intact_checkpoint(directory).checkpoint.engine.step == 250);
        REQUIRE_FALSE(exists(checkpoint_path(directory, 200)));
    }
    SECTION("with none intact every reason is given") {
        put_content(checkpoint_path(directory, 200), "");
        const std::string text = complaint_of<RunError>([&] { newest_intact_checkpoint(directory); });
        REQUIRE_THAT(text, Catch::Contains("checkpoints: holds no intact checkpoint:\n"));
        REQUIRE_THAT(text, Catch::Contains("step_000000300.h5: is truncated"));
        REQUIRE_THAT(text, Catch::Contains("step_000000200.h5: is empty"));
    }
    SECTION("an empty or missing directory holds no checkpoint") {
        REQUIRE_THAT(complaint_of<InputError>([&] { newest_intact_checkpoint(scratch / "none"); }),
                     Catch::EndsWith("none: holds no checkpoint"));
    }
}

TEST_CASE("a checkpoint that does not fit costs neither the earlier one nor a half file") {
    const SmallDisk disk("2m");
    if (!disk.mounted())
        return; // only root can mount one
    const CheckpointStore store(disk.path(), 1);
    Checkpoint checkpoint = awkward_checkpoint(Precision::double_precision);
    checkpoint.engine.step = 100;
    const auto first = store.write(checkpoint);
    Checkpoint large = awkward_checkpoint(Precision::double_precision, {24, 24, 24});
    large.engine.step = 200;
    REQUIRE_THAT(complaint_of<RunError>([&] { store.write(large); }),
                 Catch::Contains("MB are needed, ") && Catch::Contains("MB are free; free some space"));
    AtomicFile file(disk / "a.h5");
    REQUIRE_THAT(complaint_of<RunError>([&] { file.try_space(std::uint64_t{4} << 20); }),
                 Catch::EndsWith("a.h5: cannot write: No space left on device"));
    require_same(checkpoint, read_checkpoint(newest_intact_checkpoint(disk.path()).path));
    REQUIRE(exists(first));
    REQUIRE_FALSE(exists(checkpoint_path(disk.path(), 200)));
    REQUIRE_FALSE(exists(temporary_name(checkpoint_path(disk.path(), 200))));
}
