#pragma once

#include "parallel/for_each.hpp"

#include <algorithm>
#include <exception>
#include <vector>

namespace vesica {

/// for_each_index of bodies that may throw: all are called, then the first exception goes on.
template <class Body>
void for_each_task(std::int64_t count, int threads, const Body& body) {
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    const int hands =
        static_cast<int>(std::clamp<std::int64_t>(threads, 1, std::max<std::int64_t>(count, 1)));
    for_each_index(count, hands, [&](std::int64_t k) {
        try {
            body(k);
        } catch (...) {
            failures[static_cast<std::size_t>(k)] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
}

} // namespace vesica
