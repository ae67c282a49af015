#pragma once

#include "core/input_error.hpp"
#include "parallel/ranks.hpp"

#include <functional>
#include <optional>

namespace vesica {

/// Why something could not be done, as ranks tell each other.
struct Failure {
    bool by_input = false; ///< InputError rather than RunError
    std::string text;
};

/// Does something that no other rank has a part in, on every rank. Where it fails on one of them, all learn
/// of it and throw the same: InputError or RunError, with the words of the first that failed. By all ranks
/// together.
void agree(const Ranks& ranks, const std::function<void()>& work);

template <class Make>
auto agreed(const Ranks& ranks, const Make& make) {
    std::optional<decltype(make())> made;
    agree(ranks, [&] { made.emplace(make()); });
    return std::move(*made);
}

} // namespace vesica
