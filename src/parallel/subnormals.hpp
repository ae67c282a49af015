#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace vesica {

/// While one lives, its thread takes numbers below the smallest normal one for zero. Ripples that spread into
/// a fluid at rest begin with such numbers, and a processor that takes them seriously is a hundred times as
/// slow: in single precision a step would take seconds.
class FlushSubnormals {
public:
#if defined(__SSE2__)
    FlushSubnormals() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | flush_to_zero | subnormals_are_zero);
    }
    ~FlushSubnormals() {
        _mm_setcsr(before_);
    }

private:
    static constexpr unsigned flush_to_zero = 0x8000;
    static constexpr unsigned subnormals_are_zero = 0x0040;
    unsigned before_;
#else
    FlushSubnormals() {}
    ~FlushSubnormals() {}
#endif

public:
    FlushSubnormals(const FlushSubnormals&) = delete;
    FlushSubnormals& operator=(const FlushSubnormals&) = delete;
};

} // namespace vesica
