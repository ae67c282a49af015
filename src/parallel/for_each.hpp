#pragma once

#include "parallel/subnormals.hpp"

#include <cstdint>

namespace vesica {

/// Calls body(thread, begin, end) once per thread with its block of [0, count), over threads that exist
/// already. The blocks depend on the number asked for only, even where the system grants fewer threads.
template <class Body>
void for_each_block(std::int64_t count, int threads, const Body& body) {
#if defined(_OPENMP)
#pragma omp parallel for schedule(static, 1) num_threads(threads) if (threads > 1)
#endif
    for (int self = 0; self < threads; ++self) {
        const FlushSubnormals flush;
        body(self, count * self / threads, count * (self + 1) / threads);
    }
}

/// Calls body(k) for k in [0, count), shared out in contiguous blocks. The bodies must not depend on each
/// other; then the result does not depend on the number of threads.
template <class Body>
void for_each_index(std::int64_t count, int threads, const Body& body) {
    for_each_block(count, threads, [&](int, std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k)
            body(k);
    });
}

} // namespace vesica
