#include "core/input_error.hpp"
#include "io/output_directory.hpp"
#include "io/run_log.hpp"
#include "small_disk.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <regex>

using namespace vesica;

namespace {

std::string refusal(const std::filesystem::path& path, bool overwrite = false) {
    return complaint_of<RunError>([&] { OutputDirectory::create(path, overwrite); });
}

} // namespace

TEST_CASE("a new directory is created, an empty one is taken") {
    const ScratchDirectory scratch;
    {
        const OutputDirectory made = OutputDirectory::create(scratch / "out", false);
        REQUIRE(is_directory(scratch / "out"));
        REQUIRE(made / "log.txt" == scratch / "out" / "log.txt");
    }
    REQUIRE(refusal(scratch / "out").empty()); // a run that failed before its first file leaves an empty one
    REQUIRE(refusal(scratch.path() / "with slash" / "").empty());
    REQUIRE(refusal(scratch.path() / "not" / "there" / "yet").empty());
    REQUIRE(is_directory(scratch.path() / "not" / "there" / "yet"));
}

TEST_CASE("a directory that cannot serve is refused in words that say what to do") {
    const ScratchDirectory scratch;
    put_content(scratch / "file", "");
    REQUIRE_THAT(refusal(scratch / "file"),
                 Catch::EndsWith("file: is a file; expected a directory; choose another with -o DIR"));
    REQUIRE_THAT(refusal(scratch.path() / "file" / "below" / "out"),
                 Catch::EndsWith("below: cannot create the directory: Not a directory"));
    REQUIRE_THAT(
        refusal(scratch.path()),
        Catch::EndsWith(": is not empty; choose another directory with -o DIR, or replace the earlier run "
                        "with --overwrite"));
    REQUIRE_THAT(complaint_of<InputError>([&] { OutputDirectory::open(scratch / "no"); }),
                 Catch::EndsWith("no: is not a directory; expected the directory of an earlier run"));
}

TEST_CASE("a directory where nothing may be written is refused") {
    const SmallDisk disk("64k");
    if (!disk.mounted())
        return; // only root can mount one
    disk.make_read_only();
    REQUIRE_THAT(refusal(disk.path()),
                 Catch::EndsWith(": cannot write into this directory: Read-only file system"));
    REQUIRE_THAT(refusal(disk / "out"),
                 Catch::EndsWith("out: cannot create the directory: Read-only file system"));
}

TEST_CASE("overwriting removes what a run left and nothing else") {
    const ScratchDirectory scratch;
    for (const char* name : {"fields", "surfaces", "checkpoints", "notes"})
        create_directory(scratch / name);
    const std::vector<std::string> ours = {".summary.json.partial",
                                           "checkpoints/.step_000000200.h5.partial",
                                           "checkpoints/step_000000100.h5",
                                           "fields.h5",
                                           "fields.xmf",
                                           "fields/step_000000100.h5",
                                           "log.txt",
                                           "metrics.csv",
                                           "summary.json",
                                           "surfaces/surface_000000100.vtp",
                                           "surfaces/surfaces.pvd"};
    const std::vector<std::string> others = {"case.toml",
                                             "resolved.toml",
                                             "thesis.tex",
                                             "metrics.csv.backup",
                                             "step_000000100.h5",
                                             "surfaces/surface_final.vtp",
                                             "surfaces/surface_1.vtp",
                                             "notes/log.txt",
                                             "fields/step_000000100.h5.gz"};
    for (const auto& name : ours)
        put_content(scratch / name, "x");
    for (const auto& name : others)
        put_content(scratch / name, "x");
    const auto removable = removable_outputs(scratch.path());
    REQUIRE(std::vector<std::string>(removable.begin(), removable.end()) == ours);

    REQUIRE(refusal(scratch.path(), true).empty());
    for (const auto& name : ours)
        REQUIRE_FALSE(exists(scratch / name));
    for (const auto& name : others)
        REQUIRE(exists(scratch / name));
    REQUIRE_FALSE(exists(scratch / "checkpoints"));
    REQUIRE(exists(scratch / "surfaces"));
}

TEST_CASE("two runs cannot write into one directory") {
    const ScratchDirectory scratch;
    const OutputDirectory first = OutputDirectory::create(scratch / "out", false);
    put_content(first / "metrics.csv", "x");
    const std::string expected =
        "out: another run is writing into this directory; wait for it, or choose another "
        "with -o DIR";
    REQUIRE_THAT(refusal(scratch / "out", true), Catch::EndsWith(expected));
    REQUIRE(exists(first / "metrics.csv"));
    REQUIRE_THAT(complaint_of<RunError>([&] { OutputDirectory::open(scratch / "out"); }),
                 Catch::EndsWith(expected));

    // Another process is kept out just the same.
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(refusal(scratch / "out", true).ends_with(expected) ? 0 : 1);
    int status = -1;
    ::waitpid(child, &status, 0);
    REQUIRE(status == 0);
}

TEST_CASE("the lock goes with the run") {
    const ScratchDirectory scratch;
    { const OutputDirectory first = OutputDirectory::create(scratch / "out", false); }
    REQUIRE(complaint_of<RunError>([&] { OutputDirectory::open(scratch / "out"); }).empty());
}

TEST_CASE("the log has a line with its time per event and grows when a run is resumed") {
    const ScratchDirectory scratch;
    const auto path = scratch / "log.txt";
    RunLog(path).information("first {} with braces");
    {
        RunLog log(path);
        log.warning("second");
        log.error("third");
    }
    const std::string time = R"(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3} )";
    REQUIRE(std::regex_match(content_of(path), std::regex(time + R"(info: first \{\} with braces\n)" + time +
                                                          "warning: second\n" + time + "error: third\n")));
    REQUIRE_THAT(complaint_of<RunError>([&] { RunLog log(scratch.path()); }),
                 Catch::Contains("cannot open the log"));
}
