#pragma once

#include "core/large_memory.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace vesica {

/// Looks at the components of a field: component k of cell c is data[k * stride + c]. Never owns.
template <class T>
struct FieldView {
    T* data = nullptr;
    std::int64_t stride = 0;

    T* component(int k) const { return data + k * stride; }

    operator FieldView<const T>() const // NOLINT(google-explicit-constructor): looking is always allowed
        requires(!std::is_const_v<T>) {
        return {data, stride};
    }
};

/// Owns the components of a field, each an array of its own (structure of arrays). Memory is aligned to cache
/// lines and left untouched (large_array).
template <class T>
class Field {
public:
    static constexpr std::size_t alignment = 64;

    Field() = default;
    Field(int components, std::int64_t cells)
        : components_(components),
          stride_(padded_stride(cells)),
          data_(large_array<T>(static_cast<std::size_t>(components * stride_))) {
        static_assert(std::is_trivially_copyable_v<T>);
    }

    FieldView<T> view() { return {data_.get(), stride_}; }
    FieldView<const T> view() const { return {data_.get(), stride_}; }

    int components() const { return components_; }
    std::int64_t stride() const { return stride_; }
    std::size_t bytes() const {
        return static_cast<std::size_t>(components_) * static_cast<std::size_t>(stride_) * sizeof(T);
    }

private:
    /// Components a page apart land in the same cache sets: nineteen streams would evict each other. A stride
    /// of 13 cache lines beyond a multiple of the page spreads them.
    static std::int64_t padded_stride(std::int64_t cells) {
        constexpr std::int64_t page = 4096 / static_cast<std::int64_t>(sizeof(T));
        constexpr std::int64_t shift = 13 * 64 / static_cast<std::int64_t>(sizeof(T));
        return (cells + page - 1) / page * page + shift;
    }

    int components_ = 0;
    std::int64_t stride_ = 0;
    std::unique_ptr<T[], FreeLargeMemory> data_;
};

} // namespace vesica
