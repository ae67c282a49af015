# The Python package: its compiled part, vesica._vesica, beside links to its Python files, so that
#     PYTHONPATH=<build>/python python3
# finds it as it stands in the sources. tools/make-python installs a copy into a virtual environment.
if(NOT VESICA_BUILD_PYTHON OR VESICA_SANITIZE) # the interpreter knows nothing of sanitizers
    return()
endif()
set(PYBIND11_FINDPYTHON ON)
set(Python_EXECUTABLE "${VESICA_PYTHON}")
find_package(pybind11 2.10 QUIET)
if(NOT pybind11_FOUND)
    message(STATUS "No pybind11: the Python package is not built")
    return()
endif()

set(VESICA_PYTHON_DIR "${PROJECT_BINARY_DIR}/python")
get_property(sources GLOBAL PROPERTY VESICA_PYTHON_SOURCES)
pybind11_add_module(vesica_python MODULE NO_EXTRAS ${sources})
target_link_libraries(vesica_python PRIVATE vesica vesica_build_flags)
add_dependencies(vesica_python vesica_version)
set_target_properties(vesica_python PROPERTIES
    OUTPUT_NAME _vesica LIBRARY_OUTPUT_DIRECTORY "${VESICA_PYTHON_DIR}/vesica")

file(GLOB parts CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/python/vesica/*")
list(FILTER parts EXCLUDE REGEX "__pycache__")
file(MAKE_DIRECTORY "${VESICA_PYTHON_DIR}/vesica")
foreach(part IN LISTS parts)
    get_filename_component(name "${part}" NAME)
    file(CREATE_LINK "${part}" "${VESICA_PYTHON_DIR}/vesica/${name}" SYMBOLIC)
endforeach()
