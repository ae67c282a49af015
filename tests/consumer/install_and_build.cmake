# Installs the build in BUILD_DIR below WORK_DIR, then configures, builds and runs the consumer against that copy alone.
file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/prefix")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${prefix}"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S "${SOURCE_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/build" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${WORK_DIR}/build/consumer" "${prefix}/share/vesica/cases/discocyte.toml" COMMAND_ERROR_IS_FATAL ANY)
if(EXISTS "${prefix}/bin/vesica")
    execute_process(COMMAND "${prefix}/bin/vesica" --version COMMAND_ERROR_IS_FATAL ANY)
    # An item that needs the scripts, the program's own tables and a picture, and no run.
    execute_process(COMMAND "${prefix}/bin/vesica" reproduce appendix-b -o "${WORK_DIR}/reproduction" COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND "${prefix}/bin/vesica" reproduce --list COMMAND_ERROR_IS_FATAL ANY)
endif()
