include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/vesica")

target_include_directories(vesica INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/vesica>)
install(TARGETS vesica EXPORT vesica_targets
    FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/vesica")
install(EXPORT vesica_targets NAMESPACE vesica:: FILE vesicaTargets.cmake DESTINATION "${package_dir}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/vesicaConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/vesicaConfig.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/vesicaConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/vesicaConfig.cmake" "${PROJECT_BINARY_DIR}/vesicaConfigVersion.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake" DESTINATION "${package_dir}")

if(TARGET vesica_program)
    set_target_properties(vesica_program PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
    install(TARGETS vesica_program)
endif()
install(FILES "${PROJECT_SOURCE_DIR}/docs/man/vesica.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${PROJECT_SOURCE_DIR}/tools/completion/vesica.bash"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME vesica)
install(FILES "${VESICA_REPORT_PAGE}" DESTINATION "${CMAKE_INSTALL_DATADIR}/vesica" OPTIONAL)
foreach(folder cases data)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}")
        install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" DESTINATION "${CMAKE_INSTALL_DATADIR}/vesica"
            PATTERN "*.py" EXCLUDE)
    endif()
endforeach()
# What `vesica reproduce` executes, beside the cases and data that it reads.
foreach(folder reproduction tools/validation python/vesica)
    get_filename_component(parent "${folder}" DIRECTORY)
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" DESTINATION "${CMAKE_INSTALL_DATADIR}/vesica/${parent}"
        PATTERN "results" EXCLUDE PATTERN "__pycache__" EXCLUDE PATTERN "write_page.py" EXCLUDE)
endforeach()
