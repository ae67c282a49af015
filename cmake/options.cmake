option(VESICA_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(VESICA_BUILD_BENCHMARKS "Build bin/vesica_benchmarks, the kernels under Google Benchmark" OFF)
option(VESICA_BUILD_PEERS "Build the programs that benchmarks/compare-with-peers measures Palabos with" OFF)
option(VESICA_BUILD_PYTHON "Build the Python package's compiled part, if pybind11 is there" ${PROJECT_IS_TOP_LEVEL})
set(VESICA_PYTHON /usr/bin/python3 CACHE FILEPATH "The Python that sees the system's packages")
option(VESICA_WARNINGS_AS_ERRORS "Refuse to compile what the compiler warns about" OFF)
option(BUILD_SHARED_LIBS "Build libvesica as a shared library" OFF)
set(VESICA_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize= (address,undefined or thread)")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON) # the static library also goes into shared ones
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

# How this project is compiled. Nothing of it reaches a user of the library.
add_library(vesica_build_flags INTERFACE)
target_compile_options(vesica_build_flags INTERFACE
    # A fused multiply-add only where the source asks for it: otherwise two compilers, or the vector body and the
    # tail of one loop, would round differently.
    -ffp-contract=off
    # Functions of the library call each other directly; interposing them is not supported.
    -fno-semantic-interposition
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wcast-align -Wcast-qual
    -Wnon-virtual-dtor -Woverloaded-virtual -Wformat=2 -Wimplicit-fallthrough -Wundef
    $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wduplicated-branches -Wlogical-op>
    # GCC 12 warns about its own std::string operator+ (GCC bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${VESICA_WARNINGS_AS_ERRORS}>:-Werror>)
if(VESICA_SANITIZE)
    target_compile_options(vesica_build_flags INTERFACE
        -fsanitize=${VESICA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(vesica_build_flags INTERFACE -fsanitize=${VESICA_SANITIZE})
endif()
