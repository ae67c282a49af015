#pragma once

#include <cstdint>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace vesica {

/// Calls body(k) for k in [0, count), shared out in contiguous blocks over `threads` threads that exist
/// already. The bodies must not depend on each other; then the result does not depend on the number of
/// threads.
template <class Body>
void for_each_index(std::int64_t count, int threads, const Body& body) {
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
#endif
    for (std::int64_t k = 0; k < count; ++k)
        body(k);
    static_cast<void>(threads);
}

/// Calls body(thread, begin, end) once per thread with its block of [0, count).
template <class Body>
void for_each_block(std::int64_t count, int threads, const Body& body) {
#if defined(_OPENMP)
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        const std::int64_t team = omp_get_num_threads();
        const std::int64_t self = omp_get_thread_num();
        body(static_cast<int>(self), count * self / team, count * (self + 1) / team);
    }
#else
    body(0, std::int64_t{0}, count);
    static_cast<void>(threads);
#endif
}

} // namespace vesica
