# Generates core/version.hpp, when configured and again in every build, so that the commit it names is the one compiled.
# The file is only touched when its text changes.
if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(VESICA_GENERATED_DIR "${PROJECT_BINARY_DIR}/generated")
    set(VESICA_VERSION_HEADER "${VESICA_GENERATED_DIR}/core/version.hpp")
    set(write_version_header ${CMAKE_COMMAND}
        "-DVERSION=${PROJECT_VERSION}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DHEADER=${VESICA_VERSION_HEADER}"
        "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
        -P "${CMAKE_CURRENT_LIST_FILE}")
    execute_process(COMMAND ${write_version_header} COMMAND_ERROR_IS_FATAL ANY)
    add_custom_target(vesica_version COMMAND ${write_version_header}
        BYPRODUCTS "${VESICA_VERSION_HEADER}" COMMENT "Looking up the version" VERBATIM)
    return()
endif()

set(COMMIT "unknown")
find_program(GIT git)
if(GIT AND EXISTS "${SOURCE_DIR}/.git")
    execute_process(COMMAND "${GIT}" describe --always --dirty --tags WORKING_DIRECTORY "${SOURCE_DIR}"
        OUTPUT_VARIABLE description OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(description)
        set(COMMIT "${description}")
    endif()
endif()
configure_file("${SOURCE_DIR}/src/core/version.hpp.in" "${HEADER}" @ONLY)
