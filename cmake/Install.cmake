# tlsph::tlsph, the library as others link it, without the studies, and its way to an install tree:
#
#   find_package(tlsph REQUIRED)
#   target_link_libraries(app PRIVATE tlsph::tlsph)
#
# The rooms are static libraries; what a room links privately reaches the application as a target of
# LinkDependencies.cmake, which the package configuration finds again. Header-only third parties are
# wrapped in $<BUILD_INTERFACE:…> where they are named, because no application needs them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
option(TLSPH_INSTALL "Generate the rules of installation" ${PROJECT_IS_TOP_LEVEL})

get_property(rooms GLOBAL PROPERTY TLSPH_ROOM_TARGETS)
add_library(tlsph INTERFACE)
target_link_libraries(tlsph INTERFACE ${rooms})
add_library(tlsph::tlsph ALIAS tlsph)
foreach(room IN LISTS rooms)
  string(REGEX REPLACE "^tlsph_" "" name ${room})
  add_library(tlsph::${name} ALIAS ${room})
  set_property(TARGET ${room} PROPERTY EXPORT_NAME ${name})
endforeach()

if(NOT TLSPH_INSTALL)
  return()
endif()

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/tlsph")
install(TARGETS tlsph tlsph_settings ${rooms} EXPORT tlsphTargets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT tlsphTargets NAMESPACE tlsph:: DESTINATION "${package}")
foreach(room IN LISTS rooms)
  string(REGEX REPLACE "^tlsph_" "" name ${room})
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/tlsph/${name}"
          DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tlsph" FILES_MATCHING PATTERN "*.hpp")
endforeach()
if(TARGET tlsph_program)
  install(TARGETS tlsph_program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# Where the program looks for what draws its figures and for the cases of `tlsph validate`
# (validation_folder in src/studies/figure.cpp).
install(DIRECTORY "${PROJECT_SOURCE_DIR}/validation" DESTINATION "${CMAKE_INSTALL_DATADIR}/tlsph"
        FILES_MATCHING PATTERN "*.py" PATTERN "*.cpp" PATTERN "*.toml" PATTERN "*.csv" PATTERN "*.md"
        PATTERN "__pycache__" EXCLUDE)

configure_package_config_file(cmake/tlsphConfig.cmake.in "${PROJECT_BINARY_DIR}/tlsphConfig.cmake"
                              INSTALL_DESTINATION "${package}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tlsphConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/tlsphConfig.cmake" "${PROJECT_BINARY_DIR}/tlsphConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/LinkDependencies.cmake"
        DESTINATION "${package}")
