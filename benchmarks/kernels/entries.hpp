#pragma once

// Each file of kernels registers its benchmarks through one entry per instruction set.
#define VESICA_BENCHMARK_ENTRY_OF(room, isa) isa_entry_##isa##_register_##room
#define VESICA_BENCHMARK_ENTRY(room, isa) VESICA_BENCHMARK_ENTRY_OF(room, isa)
#define VESICA_DECLARE_BENCHMARK_ENTRIES(isa)                                                                \
    void VESICA_BENCHMARK_ENTRY(collision, isa)(const char* isa_name);                                       \
    void VESICA_BENCHMARK_ENTRY(colour, isa)(const char* isa_name);                                          \
    void VESICA_BENCHMARK_ENTRY(geometry, isa)(const char* isa_name);                                        \
    void VESICA_BENCHMARK_ENTRY(membrane, isa)(const char* isa_name);                                        \
    void VESICA_BENCHMARK_ENTRY(passes, isa)(const char* isa_name)

namespace vesica {

VESICA_DECLARE_BENCHMARK_ENTRIES(baseline);
VESICA_DECLARE_BENCHMARK_ENTRIES(avx2);
VESICA_DECLARE_BENCHMARK_ENTRIES(avx512);

} // namespace vesica
