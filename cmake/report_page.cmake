# The page of `vesica report`: report/ bundled into share/vesica/report.html, beside the program's folder. Without npm, or
# without the network where its libraries are not there yet, all else is built, and the command says what is missing.
option(VESICA_BUILD_REPORT "Build the page of `vesica report`, where npm is" ON)
set(VESICA_REPORT_PAGE "${PROJECT_BINARY_DIR}/share/vesica/report.html")
if(NOT VESICA_BUILD_REPORT)
    return()
endif()
find_program(VESICA_NPM npm)
find_program(VESICA_NODE node nodejs)
mark_as_advanced(VESICA_NPM VESICA_NODE)
if(NOT VESICA_NPM OR NOT VESICA_NODE)
    message(STATUS "No npm: built without the page of `vesica report` (Debian's packages nodejs and npm)")
    return()
endif()

set(report_folder "${PROJECT_SOURCE_DIR}/report")
file(GLOB report_sources CONFIGURE_DEPENDS "${report_folder}/src/*" "${report_folder}/*.mjs")
add_custom_command(OUTPUT "${VESICA_REPORT_PAGE}"
    COMMAND "${CMAKE_COMMAND}" "-DNPM=${VESICA_NPM}" "-DNODE=${VESICA_NODE}" "-DREPORT=${report_folder}"
            "-DPAGE=${VESICA_REPORT_PAGE}" -P "${PROJECT_SOURCE_DIR}/cmake/build_report_page.cmake"
    DEPENDS ${report_sources} "${report_folder}/package.json" "${report_folder}/package-lock.json"
            "${PROJECT_SOURCE_DIR}/cmake/build_report_page.cmake"
    COMMENT "Bundling the report's page" VERBATIM)
add_custom_target(vesica_report_page ALL DEPENDS "${VESICA_REPORT_PAGE}")
if(TARGET vesica_program)
    add_dependencies(vesica_program vesica_report_page)
endif()
