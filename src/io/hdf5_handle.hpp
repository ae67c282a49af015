#pragma once

#include <hdf5.h>

#include <filesystem>
#include <string_view>
#include <utility>

namespace vesica {

/// An identifier of the HDF5 library, closed when it goes.
template <herr_t (*close_identifier)(hid_t)>
class Hdf5Handle {
public:
    Hdf5Handle() = default;
    explicit Hdf5Handle(hid_t id) : id_(id) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    ~Hdf5Handle() {
        if (id_ >= 0)
            close_identifier(id_);
    }

    operator hid_t() const { return id_; }
    bool valid() const { return id_ >= 0; }
    /// Closes now; negative on failure, which a destructor could not tell.
    herr_t close() { return id_ >= 0 ? close_identifier(std::exchange(id_, -1)) : 0; }

private:
    hid_t id_ = -1;
};

using Hdf5File = Hdf5Handle<H5Fclose>;
using Hdf5Group = Hdf5Handle<H5Gclose>;
using Hdf5Dataset = Hdf5Handle<H5Dclose>;
using Hdf5Attribute = Hdf5Handle<H5Aclose>;
using Hdf5Space = Hdf5Handle<H5Sclose>;
using Hdf5Type = Hdf5Handle<H5Tclose>;
using Hdf5Properties = Hdf5Handle<H5Pclose>;

/// Keeps HDF5 from printing its error stack; errors become RunError instead.
class QuietHdf5 {
public:
    QuietHdf5();
    ~QuietHdf5();
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// Throws RunError `PATH: WHAT: innermost reason HDF5 gives`.
[[noreturn]] void fail_hdf5(const std::filesystem::path& path, std::string_view what);

/// Passes a good identifier or status on; throws RunError for a negative one.
template <class Result>
Result hdf5_checked(Result result, const std::filesystem::path& path, std::string_view what) {
    if (result < 0)
        fail_hdf5(path, what);
    return result;
}

} // namespace vesica
