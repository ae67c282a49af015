# A file named *.isa.cpp is compiled once per instruction set; the program chooses one when it starts.
#
# Such a file defines, at namespace scope, entry functions whose names contain isa_entry_<set> (VESICA_ISA is defined as
# the set's name, to paste it). Everything else it emits is hidden from the final link: an inline function compiled for
# AVX-512 has the same symbol as the generic one, the linker keeps either, and a machine without AVX-512 would die in
# code that never asked for it. So the objects of a set are linked into one relocatable object, in which every defined
# symbol but the entries is made local. Consequence: a static variable of an inline function exists once per set.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    set(vesica_known_isas baseline avx2 avx512)
    set(VESICA_ISA_FLAGS_baseline -march=x86-64)
    set(VESICA_ISA_FLAGS_avx2 -march=x86-64-v3)
    set(VESICA_ISA_FLAGS_avx512 -march=skylake-avx512 -mprefer-vector-width=512)
else()
    set(vesica_known_isas baseline)
    set(VESICA_ISA_FLAGS_baseline "")
endif()
set(VESICA_ISAS "${vesica_known_isas}" CACHE STRING "Instruction sets the kernels are compiled for")
foreach(isa IN LISTS VESICA_ISAS)
    if(NOT isa IN_LIST vesica_known_isas)
        message(FATAL_ERROR "VESICA_ISAS names ${isa}; this machine knows: ${vesica_known_isas}")
    endif()
endforeach()
if(NOT "baseline" IN_LIST VESICA_ISAS)
    message(FATAL_ERROR "VESICA_ISAS must name baseline, which runs everywhere")
endif()

# The sanitizers keep tables of global symbols that do not survive being made local.
if(VESICA_SANITIZE AND NOT VESICA_ISAS STREQUAL "baseline")
    message(STATUS "Sanitizers: kernels for the baseline only")
    set(VESICA_ISAS baseline)
endif()

set(vesica_kernel_optimisation -O3)
if(VESICA_SANITIZE)
    set(vesica_kernel_optimisation -O1) # an instrumented kernel takes ten minutes to optimise fully
else()
    # GNU's ld and objcopy, whatever the compiler links with.
    find_program(VESICA_RELOCATABLE_LINKER NAMES ld.bfd ld REQUIRED)
    find_program(VESICA_OBJCOPY NAMES objcopy REQUIRED)
    find_program(VESICA_NM NAMES nm REQUIRED)
    mark_as_advanced(VESICA_RELOCATABLE_LINKER VESICA_OBJCOPY VESICA_NM)
endif()

# vesica_instruction_sets(<target> <link> SOURCES <file>...)
# Adds the files, compiled for each of VESICA_ISAS, to <target>; <link> are the libraries to compile them with.
# Sets the property VESICA_KERNEL_OBJECTS of <target> to the relocatable objects ("<isa>=<path>").
function(vesica_instruction_sets target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK;SOURCES")
    foreach(isa IN LISTS VESICA_ISAS)
        string(TOUPPER ${isa} upper)
        target_compile_definitions(${target} PRIVATE VESICA_HAS_ISA_${upper}=1)
        set(objects ${target}_kernels_${isa})
        add_library(${objects} OBJECT ${arg_SOURCES})
        target_link_libraries(${objects} PRIVATE ${arg_LINK})
        target_compile_definitions(${objects} PRIVATE VESICA_ISA=${isa})
        target_compile_options(${objects} PRIVATE
            ${vesica_kernel_optimisation} -ffp-contract=off -fno-math-errno -fno-trapping-math -Wno-psabi ${VESICA_ISA_FLAGS_${isa}}
            # Unique symbols of GCC cannot be made local. GCC 12's own AVX-512 intrinsics start from undefined
            # registers, which it then warns of.
            $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique -Wno-maybe-uninitialized -Wno-uninitialized>)
        set_target_properties(${objects} PROPERTIES INTERPROCEDURAL_OPTIMIZATION OFF)
        if(VESICA_SANITIZE)
            # So does a check at every reference to a pack; the address sanitizer sees what a bad pointer does. Options
            # of a file come last, after those that ask for all checks.
            set_source_files_properties(${arg_SOURCES} PROPERTIES
                COMPILE_OPTIONS "-fno-sanitize=null,alignment,object-size,pointer-overflow,vptr")
            target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
            continue()
        endif()

        set(joined "${CMAKE_CURRENT_BINARY_DIR}/${objects}.joined.o")
        set(localised "${CMAKE_CURRENT_BINARY_DIR}/${objects}.o")
        add_custom_command(OUTPUT "${localised}"
            COMMAND ${VESICA_RELOCATABLE_LINKER} -r -d --force-group-allocation
                    -o "${joined}" "$<TARGET_OBJECTS:${objects}>"
            COMMAND ${VESICA_OBJCOPY} --wildcard "--keep-global-symbol=*isa_entry_${isa}*" "${joined}" "${localised}"
            COMMAND ${CMAKE_COMMAND} -E rm "${joined}"
            DEPENDS "$<TARGET_OBJECTS:${objects}>"
            COMMENT "Closing the kernels for ${isa}"
            COMMAND_EXPAND_LISTS VERBATIM)
        set_source_files_properties("${localised}" PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
        target_sources(${target} PRIVATE "${localised}")
        set_property(TARGET ${target} APPEND PROPERTY VESICA_KERNEL_OBJECTS "${isa}=${localised}")
    endforeach()
endfunction()
