#include "io/posix_file.hpp"

#include "core/input_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <system_error>

namespace vesica {

void fail_with_errno(const std::filesystem::path& path, std::string_view what, int error) {
    throw RunError(fmt::format("{}: {}: {}", path.string(), what, std::generic_category().message(error)));
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

FileDescriptor::~FileDescriptor() {
    if (number_ >= 0)
        ::close(number_);
}

FileDescriptor open_file(const std::filesystem::path& path, int flags, std::string_view what) {
    return open_file(path, flags, what, path);
}

FileDescriptor open_file(const std::filesystem::path& path, int flags, std::string_view what,
                         const std::filesystem::path& told) {
    int number = -1;
    do {
        // A named pipe would keep us waiting for its other end; length_of says that it is no regular file.
        number = ::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666);
    } while (number < 0 && errno == EINTR);
    if (number < 0)
        fail_with_errno(told, what);
    return FileDescriptor(number);
}

void write_fully(const FileDescriptor& file, std::string_view bytes, const std::filesystem::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail_with_errno(path, "cannot write");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void write_at(const FileDescriptor& file, std::uint64_t offset, std::string_view bytes,
              const std::filesystem::path& path) {
    while (!bytes.empty()) {
        const ssize_t written =
            ::pwrite(file.number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail_with_errno(path, "cannot write");
        bytes.remove_prefix(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

std::size_t read_at(const FileDescriptor& file, std::uint64_t offset, char* into, std::size_t count,
                    const std::filesystem::path& path) {
    std::size_t done = 0;
    while (done < count) {
        const ssize_t got =
            ::pread(file.number(), into + done, count - done, static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            fail_with_errno(path, "cannot read");
        if (got == 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::uint64_t length_of(const FileDescriptor& file, const std::filesystem::path& path) {
    struct stat status = {};
    if (::fstat(file.number(), &status) != 0)
        fail_with_errno(path, "cannot read its length");
    if (!S_ISREG(status.st_mode))
        throw RunError(fmt::format("{}: is not a regular file", path.string()));
    return static_cast<std::uint64_t>(status.st_size);
}

void start_writeback(const FileDescriptor& file) {
    ::sync_file_range(file.number(), 0, 0,
                      SYNC_FILE_RANGE_WRITE); // a hint: whoever ignores it loses time only
}

void synchronise(const FileDescriptor& file, const std::filesystem::path& path) {
    // EINVAL: the file system (a pipe, some network mounts) knows no such thing, and there is nothing to wait
    // for.
    if (::fsync(file.number()) != 0 && errno != EINVAL)
        fail_with_errno(path, "cannot write to the device");
}

void synchronise_directory(const std::filesystem::path& directory) {
    const auto folder = directory.empty() ? std::filesystem::path(".") : directory;
    const FileDescriptor opened = open_file(folder, O_RDONLY | O_DIRECTORY, "cannot open the directory");
    synchronise(opened, folder);
}

std::string read_whole_file(const std::filesystem::path& path) {
    const FileDescriptor file = open_file(path, O_RDONLY, "cannot open");
    std::string content(length_of(file, path), '\0');
    content.resize(read_at(file, 0, content.data(), content.size(), path));
    return content;
}

void make_subdirectory(const std::filesystem::path& directory) {
    if (::mkdir(directory.c_str(), 0777) == 0)
        return;
    const int reason = errno;
    std::error_code ignored;
    if (reason == EEXIST && std::filesystem::is_directory(directory, ignored))
        return;
    fail_with_errno(directory, "cannot create the directory", reason);
}

void require_space(const std::filesystem::path& directory, std::uint64_t bytes) {
    struct statvfs status = {};
    const auto folder = directory.empty() ? std::filesystem::path(".") : directory;
    if (::statvfs(folder.c_str(), &status) != 0)
        fail_with_errno(folder, "cannot ask for the free space");
    if (status.f_blocks == 0)
        return; // some network file systems do not tell
    const double free_bytes = static_cast<double>(status.f_bavail) * static_cast<double>(status.f_frsize);
    if (free_bytes >= static_cast<double>(bytes))
        return;
    throw RunError(fmt::format("{}: {:.1f} MB are needed, {:.1f} MB are free; free some space, or write "
                               "fewer and smaller outputs",
                               folder.string(), static_cast<double>(bytes) / 1e6, free_bytes / 1e6));
}

} // namespace vesica
