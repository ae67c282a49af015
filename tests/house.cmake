# Tests of the house itself: the rooms' edges, the texts, the kernels' borders, the installed package.
add_test(NAME house.rooms COMMAND "${VESICA_PYTHON}" "${PROJECT_SOURCE_DIR}/tools/check-rooms")
add_test(NAME house.text COMMAND "${VESICA_PYTHON}" "${PROJECT_SOURCE_DIR}/tools/check-text")
set_tests_properties(house.rooms house.text PROPERTIES ENVIRONMENT "${test_environment}")
if(VESICA_SANITIZE)
    return() # no closed kernels; and a consumer would need the same sanitizer
endif()

get_target_property(kernel_objects vesica VESICA_KERNEL_OBJECTS)
if(kernel_objects)
    foreach(object IN LISTS kernel_objects)
        string(REGEX MATCH "^([^=]+)=(.*)$" _ "${object}")
        add_test(NAME house.kernel_symbols.${CMAKE_MATCH_1} COMMAND "${VESICA_PYTHON}"
            "${PROJECT_SOURCE_DIR}/tools/check-kernel-symbols" ${VESICA_NM} ${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
    endforeach()
endif()

# As in the library, or in a small program that throws across the border of a set.
foreach(build_type Debug Release)
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/instruction_sets_${build_type}")
    add_test(NAME house.instruction_sets.${build_type} COMMAND "${CMAKE_CTEST_COMMAND}"
        --build-and-test "${CMAKE_CURRENT_SOURCE_DIR}/house/instruction_sets" "${folder}"
        --build-generator ${CMAKE_GENERATOR}
        --build-options -DCMAKE_BUILD_TYPE=${build_type} "-DVESICA_ISAS=${VESICA_ISAS}"
            -DCMAKE_C_COMPILER=${CMAKE_C_COMPILER} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
        --test-command "${CMAKE_CTEST_COMMAND}" --output-on-failure)
endforeach()

# The kernels' headers through the compiler of NVIDIA's GPUs, where there is one.
find_program(VESICA_NVCC nvcc HINTS /usr/local/cuda/bin)
mark_as_advanced(VESICA_NVCC)
if(VESICA_NVCC)
    add_test(NAME house.gpu_kernels.compile COMMAND ${CMAKE_COMMAND} "-DNVCC=${VESICA_NVCC}"
        "-DCXX_COMPILER=${CMAKE_CXX_COMPILER}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}"
        "-DPROGRAM=${CMAKE_CURRENT_BINARY_DIR}/gpu_kernels"
        -P "${CMAKE_CURRENT_SOURCE_DIR}/house/compile_gpu_kernels.cmake")
    add_test(NAME house.gpu_kernels.run COMMAND "${CMAKE_CURRENT_BINARY_DIR}/gpu_kernels")
    set_tests_properties(house.gpu_kernels.compile PROPERTIES FIXTURES_SETUP gpu_kernels)
    set_tests_properties(house.gpu_kernels.run PROPERTIES FIXTURES_REQUIRED gpu_kernels SKIP_RETURN_CODE 77)
endif()

# A ten-line program against an installed copy.
add_test(NAME house.consumer COMMAND ${CMAKE_COMMAND}
    -DBUILD_DIR=${PROJECT_BINARY_DIR} -DSOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR}/consumer
    -DWORK_DIR=${CMAKE_CURRENT_BINARY_DIR}/consumer -DGENERATOR=${CMAKE_GENERATOR} -DBUILD_TYPE=${CMAKE_BUILD_TYPE}
    -DC_COMPILER=${CMAKE_C_COMPILER} -DCXX_COMPILER=${CMAKE_CXX_COMPILER}
    -P "${CMAKE_CURRENT_SOURCE_DIR}/consumer/install_and_build.cmake")
