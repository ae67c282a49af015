# vesica_room(<name> [USES <room>...])
# Declares the room src/<name>: its sources go into the library, its headers are installed. The rooms it uses must be
# declared above it, so that the edges cannot form a cycle.
function(vesica_room name)
    cmake_parse_arguments(PARSE_ARGV 1 room "" "" "USES")
    get_property(rooms GLOBAL PROPERTY VESICA_ROOMS)
    foreach(used IN LISTS room_USES)
        if(NOT used IN_LIST rooms)
            message(FATAL_ERROR "vesica_room(${name}) uses ${used}, which is not declared above it")
        endif()
    endforeach()
    set(folder "${PROJECT_SOURCE_DIR}/src/${name}")
    file(GLOB headers CONFIGURE_DEPENDS "${folder}/*.hpp")
    file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
    file(GLOB kernels CONFIGURE_DEPENDS "${folder}/*.isa.cpp")
    if(kernels)
        list(REMOVE_ITEM sources ${kernels})
    endif()
    list(REMOVE_ITEM sources "${PROJECT_SOURCE_DIR}/src/cli/main.cpp")
    set_property(GLOBAL APPEND PROPERTY VESICA_ROOMS ${name})
    if(name STREQUAL "python") # a module of its own, cmake/python.cmake
        set_property(GLOBAL PROPERTY VESICA_PYTHON_SOURCES ${sources})
        return()
    endif()
    set_property(GLOBAL APPEND PROPERTY VESICA_HEADERS ${headers})
    set_property(GLOBAL APPEND PROPERTY VESICA_SOURCES ${sources})
    set_property(GLOBAL APPEND PROPERTY VESICA_KERNELS ${kernels})
endfunction()

# The library of all rooms, and the program.
function(vesica_house)
    get_property(headers GLOBAL PROPERTY VESICA_HEADERS)
    get_property(sources GLOBAL PROPERTY VESICA_SOURCES)
    get_property(kernels GLOBAL PROPERTY VESICA_KERNELS)
    include(version)

    add_library(vesica ${sources})
    add_library(vesica::vesica ALIAS vesica)
    target_sources(vesica PUBLIC FILE_SET HEADERS
        BASE_DIRS "${PROJECT_SOURCE_DIR}/src" "${VESICA_GENERATED_DIR}"
        FILES ${headers} "${VESICA_VERSION_HEADER}")
    target_compile_features(vesica PUBLIC cxx_std_20)
    target_compile_definitions(vesica PUBLIC ${VESICA_DEPENDENCY_DEFINITIONS})
    target_link_libraries(vesica PUBLIC ${VESICA_DEPENDENCIES} PRIVATE $<BUILD_INTERFACE:vesica_build_flags>)
    foreach(library IN LISTS VESICA_PRIVATE_DEPENDENCIES)
        target_link_libraries(vesica PRIVATE $<LINK_ONLY:${library}>)
        target_include_directories(vesica SYSTEM PRIVATE $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
    endforeach()
    # The one file that sees httplib.h, as its library was compiled.
    set_source_files_properties("${PROJECT_SOURCE_DIR}/src/io/report_server.cpp" PROPERTIES
        SKIP_PRECOMPILE_HEADERS ON
        COMPILE_DEFINITIONS "$<TARGET_PROPERTY:httplib::httplib,INTERFACE_COMPILE_DEFINITIONS>")
    set_target_properties(vesica PROPERTIES LINKER_LANGUAGE CXX
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    # What most files include, parsed once. The preset `clang` goes without, so that each file includes what it uses.
    target_precompile_headers(vesica PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory>
        <optional> <string> <variant> <vector> <fmt/format.h>)
    add_dependencies(vesica vesica_version)

    if(kernels)
        add_library(vesica_kernel_flags INTERFACE)
        target_include_directories(vesica_kernel_flags INTERFACE
            "${PROJECT_SOURCE_DIR}/src" "${VESICA_GENERATED_DIR}")
        target_link_libraries(vesica_kernel_flags INTERFACE ${VESICA_DEPENDENCIES} vesica_build_flags)
        target_compile_definitions(vesica_kernel_flags INTERFACE ${VESICA_DEPENDENCY_DEFINITIONS})
        vesica_instruction_sets(vesica LINK vesica_kernel_flags SOURCES ${kernels})
    endif()

    if(EXISTS "${PROJECT_SOURCE_DIR}/src/cli/main.cpp")
        add_executable(vesica_program "${PROJECT_SOURCE_DIR}/src/cli/main.cpp")
        set_target_properties(vesica_program PROPERTIES OUTPUT_NAME vesica)
        target_link_libraries(vesica_program PRIVATE vesica vesica_build_flags)
    endif()
endfunction()
