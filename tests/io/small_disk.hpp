#pragma once

#include "scratch_directory.hpp"

#include <sys/mount.h>
#include <unistd.h>

#include <filesystem>
#include <string>

/// A file system of a given size, to be filled. Only root may mount one; elsewhere `mounted()` is false.
class SmallDisk {
public:
    explicit SmallDisk(const std::string& size) {
        const std::string options = "size=" + size;
        mounted_ = ::geteuid() == 0 &&
                   ::mount("vesica-test", scratch_.path().c_str(), "tmpfs", 0, options.c_str()) == 0;
    }
    ~SmallDisk() {
        if (mounted_)
            ::umount2(scratch_.path().c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool mounted() const { return mounted_; }
    const std::filesystem::path& path() const { return scratch_.path(); }
    std::filesystem::path operator/(const std::string& name) const { return scratch_ / name; }
    void make_read_only() const {
        ::mount("vesica-test", path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr);
    }
    /// Leaves about `bytes` free.
    void fill_but(std::size_t bytes) const {
        const auto room = std::filesystem::space(path()).available;
        if (room > bytes)
            put_content(path() / "filling", std::string(room - bytes, 'x'));
    }

private:
    ScratchDirectory scratch_;
    bool mounted_ = false;
};
