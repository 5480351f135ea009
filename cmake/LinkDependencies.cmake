# The third parties that the libraries need when they are linked. This file serves the project itself
# and, installed beside tlsphConfig.cmake, every project that links the installed libraries.
find_package(PkgConfig REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
pkg_check_modules(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial)

if(NOT TARGET tlsph::suitesparse)
  add_library(tlsph::suitesparse INTERFACE IMPORTED)
  find_path(SUITESPARSE_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
  target_include_directories(tlsph::suitesparse SYSTEM INTERFACE "${SUITESPARSE_INCLUDE}")
  foreach(part spqr cholmod umfpack amd colamd suitesparseconfig)
    find_library(SUITESPARSE_${part} ${part} REQUIRED)
    target_link_libraries(tlsph::suitesparse INTERFACE "${SUITESPARSE_${part}}")
  endforeach()
endif()
