#pragma once

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace vesica {

/// Throws RunError: `PATH: WHAT: the system's words for the error number`.
[[noreturn]] void fail_with_errno(const std::filesystem::path& path, std::string_view what,
                                  int error = errno);

/// An open file of the operating system; closed when it goes.
class FileDescriptor {
public:
    FileDescriptor() = default;
    explicit FileDescriptor(int number) : number_(number) {}
    FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept;
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor();

    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

private:
    int number_ = -1;
};

/// Opens with the flags of open(2); O_CLOEXEC is added. Throws RunError with `what` and the system's reason.
FileDescriptor open_file(const std::filesystem::path& path, int flags, std::string_view what);
/// The same of a file that has another name to be told by.
FileDescriptor open_file(const std::filesystem::path& path, int flags, std::string_view what,
                         const std::filesystem::path& told);

/// Writes every byte or throws RunError.
void write_fully(const FileDescriptor& file, std::string_view bytes, const std::filesystem::path& path);

/// The same, from `offset` on.
void write_at(const FileDescriptor& file, std::uint64_t offset, std::string_view bytes,
              const std::filesystem::path& path);

/// Reads up to `count` bytes at `offset`; fewer only at the end of the file. Returns the number read.
std::size_t read_at(const FileDescriptor& file, std::uint64_t offset, char* into, std::size_t count,
                    const std::filesystem::path& path);

/// Length in bytes. Throws RunError when it is not a regular file.
std::uint64_t length_of(const FileDescriptor& file, const std::filesystem::path& path);

/// Asks for the bytes written so far to be on their way to the device, so that less is left for synchronise.
void start_writeback(const FileDescriptor& file);

/// Waits until the bytes are on the device.
void synchronise(const FileDescriptor& file, const std::filesystem::path& path);

/// Waits until the names in a directory are on the device, where the file system can do that.
void synchronise_directory(const std::filesystem::path& directory);

/// The whole content. Throws RunError.
std::string read_whole_file(const std::filesystem::path& path);

/// Creates one directory if it is not there; its parent must be. Throws RunError.
void make_subdirectory(const std::filesystem::path& directory);

/// Throws RunError unless the file system of `directory` has room for `bytes` more.
void require_space(const std::filesystem::path& directory, std::uint64_t bytes);

} // namespace vesica
