#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "small_disk.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

TEST_CASE("a file appears whole at commit and not before") {
    const ScratchDirectory scratch;
    const auto path = scratch / "a.txt";
    AtomicFile file(path);
    file.write("first ");
    file.write("second");
    REQUIRE_FALSE(exists(path));
    file.write_at(0, "FIRST");
    file.commit();
    REQUIRE(content_of(path) == "FIRST second");
    REQUIRE_FALSE(exists(file.temporary()));
}

TEST_CASE("a file that is not committed leaves the old one and no trace") {
    const ScratchDirectory scratch;
    const auto path = scratch / "a.txt";
    put_content(path, "old");
    {
        AtomicFile file(path);
        file.write("new");
        REQUIRE(exists(file.temporary()));
    }
    REQUIRE(content_of(path) == "old");
    REQUIRE(std::distance(std::filesystem::directory_iterator(scratch.path()), {}) == 1);
}

TEST_CASE("a write into a vanished directory is an error of the run") {
    const ScratchDirectory scratch;
    const auto path = scratch / "out" / "a.txt";
    REQUIRE_THAT(complaint_of<RunError>([&] { write_atomically(path, "text"); }),
                 Catch::Equals(path.string() + ": cannot create: No such file or directory"));

    create_directory(scratch / "out");
    AtomicFile file(path);
    file.write("text");
    remove_all(scratch / "out");
    REQUIRE_THAT(complaint_of<RunError>([&] { file.commit(); }),
                 Catch::Equals(path.string() + ": cannot rename into place: No such file or directory"));
}

TEST_CASE("a full disk is an error of the run and hurts no old file") {
    const SmallDisk disk("64k");
    if (!disk.mounted())
        return; // only root can mount one
    const auto path = disk / "a.txt";
    write_atomically(path, "old");
    REQUIRE_THAT(complaint_of<RunError>([&] { write_atomically(path, std::string(100000, 'x')); }),
                 Catch::Equals(path.string() + ": cannot write: No space left on device"));
    REQUIRE(content_of(path) == "old");
    REQUIRE_FALSE(exists(temporary_name(path)));
}

TEST_CASE("a read-only directory is an error of the run") {
    const SmallDisk disk("64k");
    if (!disk.mounted())
        return;
    disk.make_read_only();
    REQUIRE_THAT(complaint_of<RunError>([&] { write_atomically(disk / "a.txt", "text"); }),
                 Catch::EndsWith("a.txt: cannot create: Read-only file system"));
}

TEST_CASE("space is asked for before it is needed") {
    const ScratchDirectory scratch;
    require_space(scratch.path(), 1);
    REQUIRE_THAT(complaint_of<RunError>([&] { require_space(scratch.path(), std::uint64_t{1} << 60); }),
                 Catch::Contains("1152921504606.8 MB are needed, ") && Catch::Contains("free some space"));
}
