#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace vesica {

std::filesystem::path temporary_name(const std::filesystem::path& target) {
    return target.parent_path() / ("." + target.filename().string() + ".partial");
}

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)), temporary_(temporary_name(target_)) {
    // Errors name the target: the temporary name means nothing to the user.
    int number = -1;
    do {
        number = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    } while (number < 0 && errno == EINTR);
    if (number < 0)
        fail_with_errno(target_, "cannot create");
    file_ = FileDescriptor(number);
}

AtomicFile::~AtomicFile() {
    if (!committed_)
        ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
    write_fully(file_, bytes, target_);
}

void AtomicFile::write_at(std::uint64_t offset, std::string_view bytes) {
    vesica::write_at(file_, offset, bytes, target_);
}

void AtomicFile::try_space(std::uint64_t bytes) {
    if (::fallocate(file_.number(), 0, 0, static_cast<off_t>(bytes)) != 0) {
        // Other reasons mean that this file system cannot say; then the writing itself will tell.
        if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)
            fail_with_errno(target_, "cannot write");
        return;
    }
    if (::ftruncate(file_.number(), 0) != 0)
        fail_with_errno(target_, "cannot write");
}

void AtomicFile::reserve(std::uint64_t bytes) {
    if (::fallocate(file_.number(), FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0)
        reserved_ = true;
    else if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)
        fail_with_errno(target_, "cannot write");
}

void AtomicFile::commit() {
    if (reserved_ && ::ftruncate(file_.number(), static_cast<off_t>(length_of(file_, target_))) != 0)
        fail_with_errno(target_, "cannot write");
    synchronise(file_, target_);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail_with_errno(target_, "cannot rename into place");
    committed_ = true;
    synchronise_directory(target_.parent_path());
}

void write_atomically(const std::filesystem::path& target, std::string_view content) {
    AtomicFile file(target);
    file.write(content);
    file.commit();
}

} // namespace vesica
