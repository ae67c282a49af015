#pragma once

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace vesica {

struct FreeLargeMemory {
    void operator()(void* memory) const { std::free(memory); }
};

/// An array of `count` numbers that a step streams through from end to end, aligned to a cache line at least.
/// It is not touched here, so that the threads that will work on it place its pages by their first write.
/// Nineteen populations lie far apart: with pages of 4 kB a row of cells needs more entries of the
/// translation table than there are, and on a virtual machine every miss walks two of them. So the system is
/// asked for huge pages; where it has none, nothing changes. Throws std::bad_alloc.
template <class T>
std::unique_ptr<T[], FreeLargeMemory> large_array(std::size_t count) {
    constexpr std::size_t huge_page = std::size_t{1} << 21;
    constexpr std::size_t cache_line = 64;
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T) - huge_page)
        throw std::bad_alloc();
    const std::size_t alignment = count * sizeof(T) >= 2 * huge_page ? huge_page : cache_line;
    const std::size_t bytes = (count * sizeof(T) + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, bytes);
    if (memory == nullptr && bytes > 0)
        throw std::bad_alloc();
#if defined(__linux__)
    if (alignment == huge_page)
        static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE)); // advice: a refusal is not an error
#endif
    return std::unique_ptr<T[], FreeLargeMemory>(static_cast<T*>(memory));
}

} // namespace vesica
