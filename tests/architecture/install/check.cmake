# Installs the build to a scratch folder, then configures, builds and runs another project that knows
# nothing but that folder.
#   cmake -DBUILD=… -DSOURCE=… -DCOMPILER=… -DFLAGS=… -DTYPE=… -DSCRATCH=… -P check.cmake
set(prefix "${SCRATCH}/prefix")
file(REMOVE_RECURSE "${SCRATCH}")

execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${prefix}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# An install tree must not point back to where it was built.
file(GLOB_RECURSE package_files "${prefix}/*.cmake")
if(NOT package_files)
  message(FATAL_ERROR "nothing was installed for find_package")
endif()
foreach(file IN LISTS package_files)
  file(READ "${file}" text)
  foreach(folder IN ITEMS "${SOURCE}/" "${BUILD}/")
    string(FIND "${text}" "${folder}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${file} names ${folder}")
    endif()
  endforeach()
endforeach()

execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/consumer" -B "${SCRATCH}/build"
                        "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
                        "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_BUILD_TYPE=${TYPE}" "-DEXAMPLES=${SOURCE}/examples"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${SCRATCH}/build" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${SCRATCH}/build/consumer" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL "0.75 0.5 0.25\n")
  message(FATAL_ERROR "the consumer printed: ${printed}")
endif()
file(GLOB lessons "${SOURCE}/examples/*.cpp")
foreach(source IN LISTS lessons)
  cmake_path(GET source STEM lesson)
  execute_process(COMMAND "${SCRATCH}/build/${lesson}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(EXISTS "${prefix}/bin/tlsph")
  execute_process(COMMAND "${prefix}/bin/tlsph" --help OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endif()
