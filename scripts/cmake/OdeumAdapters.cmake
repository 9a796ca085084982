# SPDX-License-Identifier: BSD-3-Clause
# The libraries of adapters/.

# Enters the folders of adapters/. A folder NAME has a CMakeLists.txt that calls odeum_adapter(...), and, for
# integrators, a solvers.hpp that declares
#   void odeum::adapters::NAME::add_solvers(std::vector<Solver>&);
# and, for solvers of sparse symmetric systems, a linear.hpp that declares
#   void odeum::adapters::NAME::add_linear_peers(std::vector<linear::LinearPeerInfo>&);
# and, where users of the library tune options, a variants.hpp that declares
#   void odeum::adapters::NAME::add_variants(std::map<std::string, std::vector<Variant>>&);
# odeum_adapters.hpp includes these headers; lists/adapters_<stem>.inc names the folders that have one.
macro(odeum_add_adapters)
  file(GLOB odeum_folders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/adapters/*/CMakeLists.txt)
  foreach(odeum_folder IN LISTS odeum_folders)
    get_filename_component(odeum_folder ${odeum_folder} DIRECTORY)
    add_subdirectory(${odeum_folder})
  endforeach()
  # Set by odeum_adapter in the folders' own scopes, hence global properties.
  get_property(ODEUM_ADAPTERS_BUILT GLOBAL PROPERTY ODEUM_ADAPTERS_BUILT)
  get_property(odeum_rows GLOBAL PROPERTY ODEUM_LIBRARY_ROWS)
  odeum_write_verbatim(${ODEUM_GENERATED}/lists/libraries.inc "${odeum_rows}")
  foreach(odeum_stem IN ITEMS solvers linear variants)
    set(odeum_with "")
    foreach(odeum_name IN LISTS ODEUM_ADAPTERS_BUILT)
      if(EXISTS ${PROJECT_SOURCE_DIR}/adapters/${odeum_name}/${odeum_stem}.hpp)
        list(APPEND odeum_with ${odeum_name})
      endif()
    endforeach()
    odeum_write_list(adapters_${odeum_stem} ${odeum_with})
    odeum_each(odeum_includes "#include \"NAME/${odeum_stem}.hpp\"\n" ${odeum_with})
    odeum_write_verbatim(${ODEUM_GENERATED}/odeum_adapters_${odeum_stem}.hpp "#pragma once\n${odeum_includes}")
  endforeach()
endmacro()

# odeum_adapter(NAME <folder> OPTION <ODEUM_WITH_X> FOUND <bool> VERSION <text>
#               LIBRARIES <solver id prefixes>... SOURCES <files>... LINK <targets>...
#               INCLUDE <folders>... DEFINE <definitions>... PACKAGE <arguments of find_package>)
# PACKAGE: what a project that uses the installed libraries has to find, where LINK names its targets.
# Declares the option (on where the library was found) and, where it is on, the library target
# odeum_adapter_<folder>.
function(odeum_adapter)
  cmake_parse_arguments(A "" "NAME;OPTION;FOUND;VERSION;PACKAGE" "LIBRARIES;SOURCES;LINK;INCLUDE;DEFINE" ${ARGN})
  if(A_FOUND)
    set(default ON)
  else()
    set(default OFF)
  endif()
  option(${A_OPTION} "Build the ${A_NAME} adapter" ${default})
  if(${A_OPTION} AND NOT A_FOUND)
    message(FATAL_ERROR "${A_OPTION} is ON, but the library was not found")
  endif()
  list(TRANSFORM A_LIBRARIES REPLACE "(.+)" "\"\\1\"" OUTPUT_VARIABLE quoted)
  list(JOIN quoted ", " quoted)
  if(${A_OPTION})
    add_library(odeum_adapter_${A_NAME} STATIC ${A_SOURCES})
    target_link_libraries(odeum_adapter_${A_NAME} PUBLIC odeum_core PRIVATE $<BUILD_INTERFACE:odeum_options>)
    # No warnings from a peer's headers.
    target_link_libraries(odeum_adapter_${A_NAME} PUBLIC ${A_LINK})
    target_include_directories(odeum_adapter_${A_NAME} SYSTEM PUBLIC $<BUILD_INTERFACE:${A_INCLUDE}>)
    target_include_directories(odeum_adapter_${A_NAME} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/adapters>)
    target_compile_definitions(odeum_adapter_${A_NAME} PUBLIC ${A_DEFINE})
    set(row "    {\"${A_NAME}\", {${quoted}}, \"${A_OPTION}\", true, \"${A_VERSION}\"},\n")
    set_property(GLOBAL APPEND PROPERTY ODEUM_ADAPTERS_BUILT ${A_NAME})
    if(A_PACKAGE)
      set_property(GLOBAL APPEND_STRING PROPERTY ODEUM_PACKAGES " \"${A_PACKAGE}\"")
    endif()
  else()
    set(row "    {\"${A_NAME}\", {${quoted}}, \"${A_OPTION}\", false, \"\"},\n")
  endif()
  set_property(GLOBAL APPEND_STRING PROPERTY ODEUM_LIBRARY_ROWS "${row}")
endfunction()
