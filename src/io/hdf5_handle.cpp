#include "io/hdf5_handle.hpp"

#include "core/input_error.hpp"

#include <fmt/format.h>

#include <string>

namespace vesica {
namespace {

/// The walk starts at the innermost error, which is the reason; the rest repeats what the library was doing.
herr_t keep_first(unsigned, const H5E_error2_t* error, void* text) {
    auto& reason = *static_cast<std::string*>(text);
    if (reason.empty() && error->desc != nullptr)
        reason = error->desc;
    return 0;
}

/// HDF5 wraps the system's reason into a line of numbers: "..., errno = 28, error message = 'No space left on
/// device', buf = ..."; the user needs the words in quotes.
std::string words_of(const std::string& reason) {
    const std::string_view mark = "error message = '";
    const std::size_t begin = reason.find(mark);
    if (begin == std::string::npos)
        return reason;
    const std::size_t end = reason.find('\'', begin + mark.size());
    return reason.substr(begin + mark.size(), end - begin - mark.size());
}

} // namespace

QuietHdf5::QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() {
    H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

void fail_hdf5(const std::filesystem::path& path, std::string_view what) {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
    reason = words_of(reason);
    throw RunError(fmt::format("{}: {}{}{}", path.string(), what, reason.empty() ? "" : ": ", reason));
}

} // namespace vesica
