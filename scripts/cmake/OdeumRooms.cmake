# SPDX-License-Identifier: BSD-3-Clause
# The rooms of src/odeum as targets.

# odeum_headers, which has the precompiled header of all rooms: g++ 12 crashes on one of -O1 at a higher level.
function(odeum_add_headers)
  add_library(odeum_headers OBJECT ${ODEUM_GENERATED}/odeum_build_info.cpp)
  target_include_directories(odeum_headers PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(odeum_headers PRIVATE odeum_options fmt::fmt)
  target_precompile_headers(odeum_headers PRIVATE <algorithm> <cmath> <functional> <map> <memory> <string> <vector>
                            <fmt/format.h> <odeum/problem/ode_view.hpp>)
endfunction()

# odeum_add_rooms(<target> OBJECT|STATIC <level> <room>...): the files of these rooms at one level of optimisation, -O1
# where a run spends no time. Vector code (scene/springs/CMakeLists.txt) and programs are not among them.
function(odeum_add_rooms target kind level)
  list(TRANSFORM ARGN REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/odeum/\\1/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB files CONFIGURE_DEPENDS ${patterns})
  list(FILTER files EXCLUDE REGEX "(_lanes|/main)\\.cpp$")
  add_library(${target} ${kind} ${files})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${ODEUM_GENERATED})
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:odeum_options> $<BUILD_INTERFACE:Eigen3::Eigen>
                                          $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> fmt::fmt yaml-cpp ZLIB::ZLIB)
  target_precompile_headers(${target} REUSE_FROM odeum_headers)
endfunction()
