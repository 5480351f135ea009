# Headers that nearly every source includes, parsed once for each kind of target; a clean build takes
# half as long. The presets ci and tidy do without, so a source that leans on them is found there.
function(tlsph_precompile name)
  cmake_parse_arguments(precompile "" "" "HEADERS;LINK" ${ARGN})
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "// Nothing but the headers.\n")
  add_library(${name} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  target_link_libraries(${name} PRIVATE tlsph_settings ${precompile_LINK})
  target_precompile_headers(${name} PRIVATE ${precompile_HEADERS})
endfunction()

set(TLSPH_COMMON_HEADERS <Eigen/Core> <Eigen/SparseCore> <fmt/format.h> <algorithm> <array> <cmath> <filesystem>
    <functional> <map> <memory> <optional> <string> <string_view> <utility> <variant> <vector>)
tlsph_precompile(tlsph_precompiled HEADERS ${TLSPH_COMMON_HEADERS} LINK Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX)

# In batches the templates of Eigen are instantiated once for several files.
option(TLSPH_BATCHES "Compile the sources of a folder several files at a time" OFF)

# A room is a folder below src/ with its headers below include/tlsph/; it becomes one library,
# tlsph_<room>, that links exactly the rooms and third parties it may include.
# Usage: tlsph_room(kernels ROOMS core LINK fmt::fmt)
# SINGLY: its sources are not compiled several at a time: they hide names of each other, or their speed
# must not depend on what else is compiled.
# STUDY: experiments about the method. The program links them; tlsph::tlsph does not.
function(tlsph_room name)
  cmake_parse_arguments(room "STUDY;SINGLY" "" "ROOMS;LINK;PRIVATE_LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${name}/*.cpp")
  list(TRANSFORM room_ROOMS PREPEND tlsph_)
  if(sources)
    add_library(tlsph_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_precompile_headers(tlsph_${name} REUSE_FROM tlsph_precompiled)
    if(TLSPH_BATCHES AND NOT room_SINGLY)
      set_target_properties(tlsph_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 4)
      # The sources of a batch look like headers to the compiler.
      target_compile_options(tlsph_${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endif()
    target_link_libraries(tlsph_${name} PRIVATE ${room_PRIVATE_LINK})
  else()
    add_library(tlsph_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(tlsph_${name} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  target_link_libraries(tlsph_${name} ${scope} tlsph_settings ${room_ROOMS} ${room_LINK})
  set(kind ROOM)
  if(room_STUDY)
    set(kind STUDY)
  endif()
  set_property(GLOBAL APPEND PROPERTY TLSPH_${kind}_TARGETS tlsph_${name})
endfunction()
