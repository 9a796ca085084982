# SPDX-License-Identifier: BSD-3-Clause
# Generates from the names of files and folders the lists of methods, cases, studies and libraries, the units that
# compile methods, and the texts that are compiled in. Globs use CONFIGURE_DEPENDS: the next build picks up a
# new file. A file is written only when its text changes, so an unrelated re-configure rebuilds nothing.

set(ODEUM_GENERATED ${PROJECT_BINARY_DIR}/generated)

# Writes a text as it is, only when it changes.
function(odeum_write_verbatim path text)
  if(EXISTS ${path})
    file(READ ${path} old)
    if(old STREQUAL text)
      return()
    endif()
  endif()
  file(WRITE ${path} "${text}")
endfunction()

# Sets a variable to the stems of the files of a pattern.
macro(odeum_stems variable pattern)
  file(GLOB ${variable} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${pattern})
  list(TRANSFORM ${variable} REPLACE "^.*/([^/.]+)[^/]*$" "\\1")
endmacro()

# Sets a variable to a text repeated for each of the names that follow, with the name for NAME in it.
function(odeum_each variable text)
  set(all "")
  foreach(name IN LISTS ARGN)
    string(REPLACE "NAME" "${name}" one "${text}")
    string(APPEND all "${one}")
  endforeach()
  set(${variable} "${all}" PARENT_SCOPE)
endfunction()

# lists/<list>.inc: a line ODEUM_ITEM(name) for each of the names; the file that includes it defines that macro.
function(odeum_write_list list)
  odeum_each(lines "ODEUM_ITEM(NAME)\n" ${ARGN})
  odeum_write_verbatim(${ODEUM_GENERATED}/lists/${list}.inc "${lines}")
endfunction()

# <folder>/<name>.cpp for each of the names, a text with the name for NAME in it; the files are left in a variable.
function(odeum_write_units variable folder text)
  set(files "")
  foreach(name IN LISTS ARGN)
    string(REPLACE "NAME" "${name}" unit "${text}")
    odeum_write_verbatim(${ODEUM_GENERATED}/${folder}/${name}.cpp "${unit}")
    list(APPEND files ${ODEUM_GENERATED}/${folder}/${name}.cpp)
  endforeach()
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

# odeum_methods.hpp: every file in src/odeum/methods, its stem the method's type and id. own/<method>.cpp: units that
# compile them for the shared types (solvers/own_methods.hpp) and for the proofs (proof/facts.hpp), left in
# ODEUM_METHOD_FILES.
function(odeum_generate_methods)
  odeum_stems(methods src/odeum/methods/*.hpp)
  odeum_each(includes "#include \"odeum/methods/NAME.hpp\"\n" ${methods})
  list(JOIN methods ", " types)
  odeum_write_verbatim(${ODEUM_GENERATED}/odeum_methods.hpp
                       "#pragma once\n#include \"odeum/kernel/method_list.hpp\"\n${includes}
namespace odeum::methods {\nusing All = MethodList<${types}>;\n}\n")
  odeum_write_list(methods ${methods})
  odeum_write_units(files own
"#include \"odeum/methods/NAME.hpp\"\n#include \"odeum/proof/facts_of.hpp\"\n#include \"odeum/solvers/enroll_method.hpp\"\n
namespace odeum {
void add_NAME(std::vector<Solver>& all) { all.push_back(own_method<methods::NAME>()); }
void add_NAME(std::vector<proof::MethodFacts>& all) { all.push_back(proof::facts_of<methods::NAME>()); }
}  // namespace odeum\n" ${methods})
  set(ODEUM_METHOD_FILES ${files} PARENT_SCOPE)
endfunction()

# The lists of cases (every C++ file in cases/, its stem the function that states them; every text there, whose
# problem is printed as C++, see odeum_print_cases) and of studies (every folder in src/odeum/studies that has a study.cpp) and of kinds of problems. The files are left in
# ODEUM_CASE_FILES, the texts in ODEUM_CASE_TEXTS.
function(odeum_generate_lists)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.cpp)
  # A case is often begun as a copy of another one, with the same local names.
  set_source_files_properties(${files} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.yaml)
  odeum_stems(cases cases/*.cpp)
  odeum_stems(printed cases/*.yaml)
  foreach(stem IN LISTS printed)
    list(APPEND files ${ODEUM_GENERATED}/cases/${stem}.cpp)
  endforeach()
  odeum_write_list(cases ${cases})
  odeum_write_list(printed ${printed})
  set(ODEUM_CASE_FILES ${files} PARENT_SCOPE)
  set(ODEUM_CASE_TEXTS ${texts} PARENT_SCOPE)
  file(GLOB studies CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/studies/*/study.cpp)
  list(TRANSFORM studies REPLACE "^.*/([^/]+)/study.cpp$" "\\1")
  odeum_write_list(studies ${studies})
  file(GLOB kinds CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/cases/kinds/*/kind.cpp)
  list(TRANSFORM kinds REPLACE "^.*/([^/]+)/kind.cpp$" "\\1")
  odeum_write_list(kinds ${kinds})
endfunction()

# lists/<list>.inc: a pair {"stem", text} for each file of some patterns, so that the program needs no file beside it.
function(odeum_embed list)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE patterns)
  file(GLOB files CONFIGURE_DEPENDS ${patterns})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(pairs "")
  foreach(file IN LISTS files)
    get_filename_component(stem ${file} NAME_WLE)
    file(READ ${file} text)
    string(APPEND pairs "{\"${stem}\", R\"odeum-text(${text})odeum-text\"},\n")
  endforeach()
  odeum_write_verbatim(${ODEUM_GENERATED}/lists/${list}.inc "${pairs}")
endfunction()

# What prints texts as C++ (src/odeum/print), and a command for each of ODEUM_CASE_TEXTS: its problem as
# generated/problems/<stem>.hpp, and what hands it to the reader as generated/cases/<stem>.cpp; the target odeum_printed is all of them.
function(odeum_print_cases)
  add_executable(odeum_print ${PROJECT_SOURCE_DIR}/src/odeum/print/main.cpp $<TARGET_OBJECTS:odeum_formula>)
  target_include_directories(odeum_print PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(odeum_print PRIVATE odeum_options fmt::fmt yaml-cpp Threads::Threads ${CMAKE_DL_LIBS})
  set(printed "")
  foreach(text IN LISTS ODEUM_CASE_TEXTS)
    get_filename_component(stem ${text} NAME_WE)
    set(outputs ${ODEUM_GENERATED}/problems/${stem}.hpp ${ODEUM_GENERATED}/cases/${stem}.cpp)
    add_custom_command(OUTPUT ${outputs} COMMAND odeum_print ${text} ${ODEUM_GENERATED} DEPENDS ${text} odeum_print
                       VERBATIM)
    list(APPEND printed ${outputs})
  endforeach()
  add_custom_target(odeum_printed DEPENDS ${printed})
endfunction()

# share/odeum beside the program: the files that a report is read with (src/odeum/report/shared_files.hpp), as links
# into the checkout, so that a changed text or script is shown without a build, and the packaged libraries of the page.
function(odeum_link from to)
  get_filename_component(folder ${to} DIRECTORY)
  file(RELATIVE_PATH relative ${folder} ${from})
  file(CREATE_LINK ${relative} ${to} SYMBOLIC)
endfunction()
function(odeum_share_files)
  set(share ${PROJECT_BINARY_DIR}/share/odeum)
  file(REMOVE_RECURSE ${share}/pages)
  file(MAKE_DIRECTORY ${share}/pages ${share}/libraries)
  file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/studies/*/page.md ${PROJECT_SOURCE_DIR}/src/odeum/*/replays/page.md)
  foreach(page IN LISTS pages)
    get_filename_component(folder ${page} DIRECTORY)
    get_filename_component(name ${folder} NAME)
    odeum_link(${folder} ${share}/pages/${name})
    install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/odeum/pages/${name}
            FILES_MATCHING PATTERN "*.md" PATTERN "*.js")
  endforeach()
  odeum_link(${PROJECT_SOURCE_DIR}/reports/viewer ${share}/viewer)
  odeum_link(${PROJECT_SOURCE_DIR}/reports ${share}/documents)
  find_file(ODEUM_D3 d3.min.js PATHS /usr/share/nodejs/d3/dist /usr/share/javascript/d3 REQUIRED)
  find_file(ODEUM_MARKDOWN_IT markdown-it.js PATHS /usr/share/javascript/markdown-it REQUIRED)
  mark_as_advanced(ODEUM_D3 ODEUM_MARKDOWN_IT)
  file(COPY ${ODEUM_D3} ${ODEUM_MARKDOWN_IT} DESTINATION ${share}/libraries)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/reports/viewer ${share}/libraries DESTINATION ${CMAKE_INSTALL_DATADIR}/odeum)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/reports/ DESTINATION ${CMAKE_INSTALL_DATADIR}/odeum/documents
          FILES_MATCHING PATTERN "*.md" PATTERN docs EXCLUDE PATTERN viewer EXCLUDE PATTERN pictures EXCLUDE)
endfunction()

# odeum_build_info.cpp: the values of core/build_info.hpp. The revision is the one at configure time.
function(odeum_generate_build_info)
  set(revision "")
  find_package(Git QUIET)
  if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty --abbrev=12
                    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                    OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_directory_property(options COMPILE_OPTIONS)
  list(JOIN options " " options)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}" flags)
  # What references are computed by: those that other code computed are not taken from the cache.
  file(GLOB truth_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/truth/* ${PROJECT_SOURCE_DIR}/src/odeum/formula/*
       ${PROJECT_SOURCE_DIR}/src/odeum/cases/text_truth.cpp ${PROJECT_SOURCE_DIR}/src/odeum/methods/verner98.hpp ${PROJECT_SOURCE_DIR}/src/odeum/truth/foreign_reference.cpp
       ${PROJECT_SOURCE_DIR}/src/odeum/linear/banded_lu.hpp ${PROJECT_SOURCE_DIR}/src/odeum/linear/ordering.cpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${truth_files})
  set(hashes "")
  foreach(file IN LISTS truth_files)
    file(SHA256 ${file} hash)
    string(APPEND hashes ${hash})
  endforeach()
  string(SHA256 truth_code "${hashes}")
  odeum_write_verbatim(${ODEUM_GENERATED}/odeum_build_info.cpp
"#include \"odeum/core/build_info.hpp\"

namespace odeum::build {
constinit const std::string_view version = \"${PROJECT_VERSION}\";
constinit const std::string_view revision = \"${revision}\";
constinit const std::string_view compiler = \"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\";
constinit const std::string_view type = \"${CMAKE_BUILD_TYPE}\";
constinit const std::string_view flags = R\"(${flags})\";
constinit const std::string_view truth_code = \"${truth_code}\";
}
")
endfunction()
