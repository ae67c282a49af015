#pragma once

#include "io/posix_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace vesica {

/// A file that appears under its name whole or not at all: bytes go to `.NAME.partial` in the same directory,
/// commit() makes them durable and renames. Without commit() the destructor removes what was begun.
class AtomicFile {
public:
    /// Throws RunError when the temporary file cannot be created.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Appends; throws RunError (disk full, quota).
    void write(std::string_view bytes);
    /// Overwrites bytes that are there already.
    void write_at(std::uint64_t offset, std::string_view bytes);
    /// Asks the file system for so many bytes and gives them back: quotas and full disks show now, in plain
    /// words, instead of inside a library. Throws RunError. Call it before anything is written.
    void try_space(std::uint64_t bytes);
    /// Keeps room for a file of so many bytes, where the file system can do that, for a library that writes
    /// by itself and does not recover from a full disk; commit() gives back what is left of it. Throws
    /// RunError.
    void reserve(std::uint64_t bytes);
    /// fsync, rename, fsync of the directory. The old file, if any, is replaced in one instant.
    void commit();

    const std::filesystem::path& target() const { return target_; }
    /// For libraries that insist on opening a path themselves; they must close it before commit().
    const std::filesystem::path& temporary() const { return temporary_; }
    const FileDescriptor& descriptor() const { return file_; }

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    FileDescriptor file_;
    bool reserved_ = false;
    bool committed_ = false;
};

/// One whole text or byte string into one file. Throws RunError.
void write_atomically(const std::filesystem::path& target, std::string_view content);

/// The name under which `target` grows until it is whole.
std::filesystem::path temporary_name(const std::filesystem::path& target);

} // namespace vesica
