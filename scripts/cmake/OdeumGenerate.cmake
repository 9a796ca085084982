# SPDX-License-Identifier: BSD-3-Clause
# Makes of the names of files and folders what the build has of them: lists of methods, cases, studies and libraries,
# units that compile methods, and texts that are compiled in. Globs use CONFIGURE_DEPENDS: the next build picks up a
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

# odeum_methods.hpp: every file in src/odeum/methods, its stem the method's type and id. own/*.cpp: units that
# compile them for the shared types (solvers/own_methods.hpp) and for the proofs (proof/facts.hpp). Methods whose
# names begin with the same word are a family and have one unit; families of one or two methods share units, since
# each unit costs a second besides its methods. The name of a unit is that of its families, joined by "-".
# The units are left in ODEUM_METHOD_FILES.
function(odeum_generate_methods)
  odeum_stems(methods src/odeum/methods/*.hpp)
  odeum_each(includes "#include \"odeum/methods/NAME.hpp\"\n" ${methods})
  list(JOIN methods ", " types)
  odeum_write_verbatim(${ODEUM_GENERATED}/odeum_methods.hpp
                       "#pragma once\n#include \"odeum/kernel/method_list.hpp\"\n${includes}
namespace odeum::methods {\nusing All = MethodList<${types}>;\n}\n")
  set(families "")
  foreach(method IN LISTS methods)
    string(REGEX MATCH "^[a-z]+" family ${method})
    list(APPEND families ${family})
    list(APPEND of_${family} ${method})
  endforeach()
  list(REMOVE_DUPLICATES families)
  odeum_write_list(families ${families})
  set(units "")
  set(small "")
  set(count 0)
  foreach(family IN LISTS families)
    list(LENGTH of_${family} methods_of_family)
    if(methods_of_family GREATER 2)
      list(APPEND units ${family})
      continue()
    endif()
    string(APPEND small "-${family}")
    math(EXPR count "${count} + ${methods_of_family}")
    if(count GREATER 3)
      list(APPEND units ${small})
      set(small "")
      set(count 0)
    endif()
  endforeach()
  if(small)
    list(APPEND units ${small})
  endif()
  set(files "")
  foreach(unit IN LISTS units)
    string(REGEX REPLACE "^-" "" unit ${unit})
    string(REPLACE "-" ";" families ${unit})
    set(text "#include \"odeum/proof/facts_of.hpp\"\n#include \"odeum/solvers/enroll_method.hpp\"\n")
    foreach(family IN LISTS families)
      odeum_each(includes "#include \"odeum/methods/NAME.hpp\"\n" ${of_${family}})
      odeum_each(own "  all.push_back(own_method<methods::NAME>());\n" ${of_${family}})
      odeum_each(facts "  all.push_back(proof::facts_of<methods::NAME>());\n" ${of_${family}})
      string(APPEND text "\n${includes}
namespace odeum {\nvoid add_${family}(std::vector<Solver>& all) {\n${own}}
void add_${family}(std::vector<proof::MethodFacts>& all) {\n${facts}}\n}  // namespace odeum\n")
    endforeach()
    odeum_write_verbatim(${ODEUM_GENERATED}/own/${unit}.cpp "${text}")
    list(APPEND files ${ODEUM_GENERATED}/own/${unit}.cpp)
  endforeach()
  set(ODEUM_METHOD_FILES ${files} PARENT_SCOPE)
endfunction()

# The lists of cases (every C++ file in cases/, its stem the function that states them; every text there, whose
# problem is printed as C++, see odeum_print_cases) and of studies (every folder in src/odeum/studies that has a study.cpp). The files are left in
# ODEUM_CASE_FILES, the texts in ODEUM_CASE_TEXTS.
function(odeum_generate_lists)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.cpp)
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
endfunction()

# Units of timed runs, see src/odeum/cases/inlined.hpp: one for each three of ODEUM_INLINED_METHODS with all problems
# of cases/inlined, and one for odeint on each of ODEUM_INLINED_ODEINT (cases/inlined/lists.cmake). They are left in
# ODEUM_INLINED_FILES and ODEUM_INLINED_ODEINT_FILES, and one in plain C++17 in ODEUM_INLINED_17_FILES.
function(odeum_generate_inlined)
  include(${PROJECT_SOURCE_DIR}/cases/inlined/lists.cmake)
  odeum_stems(problems cases/inlined/*.hpp)
  if(NOT ODEUM_INLINED)
    set(ODEUM_INLINED_METHODS "")
  endif()
  if(NOT ODEUM_INLINED OR NOT "odeint" IN_LIST ODEUM_ADAPTERS_BUILT)
    set(ODEUM_INLINED_ODEINT "")
  endif()
  set(files ${PROJECT_SOURCE_DIR}/cases/inlined/all.cpp)
  list(JOIN problems ", " types)
  odeum_each(includes "#include \"inlined/NAME.hpp\"\n" ${problems})
  set(rest ${ODEUM_INLINED_METHODS})
  while(rest)
    list(SUBLIST rest 0 3 methods)
    list(POP_FRONT rest first second third)
    odeum_each(headers "#include \"odeum/methods/NAME.hpp\"\n" ${methods})
    odeum_each(functions
"void add_NAME(const Case& c, std::vector<Entrant>& all) { add_method<methods::NAME, ${types}>(c, all); }\n" ${methods})
    odeum_write_verbatim(${ODEUM_GENERATED}/inlined/${first}.cpp "#include \"odeum/cases/inlined.hpp\"\n${headers}${includes}
namespace odeum::cases::inlined {\n${functions}}  // namespace odeum::cases::inlined\n")
    list(APPEND files ${ODEUM_GENERATED}/inlined/${first}.cpp)
  endwhile()
  set(odeint_files "")
  foreach(problem IN LISTS ODEUM_INLINED_ODEINT)
    odeum_write_verbatim(${ODEUM_GENERATED}/inlined/odeint_${problem}.cpp
"#include \"inlined/${problem}.hpp\"\n#include \"odeint/inlined_cases.hpp\"\n
namespace odeum::cases::inlined {
void add_odeint_${problem}(const Case& c, std::vector<Entrant>& all) { add_odeint<${problem}>(c, all); }
}  // namespace odeum::cases::inlined\n")
    list(APPEND odeint_files ${ODEUM_GENERATED}/inlined/odeint_${problem}.cpp)
  endforeach()
  list(TRANSFORM ODEUM_INLINED_ODEINT PREPEND odeint_ OUTPUT_VARIABLE odeint)
  set(files_17 "")
  if(ODEUM_INLINED_ODEINT)
    list(APPEND odeint rosenbrock4)
    list(APPEND files ${PROJECT_SOURCE_DIR}/cases/inlined/rosenbrock4.cpp)
    set(files_17 ${PROJECT_SOURCE_DIR}/cases/inlined/rosenbrock4_runs.cpp)
  endif()
  odeum_write_list(inlined ${odeint} ${ODEUM_INLINED_METHODS})
  set(ODEUM_INLINED_FILES ${files} PARENT_SCOPE)
  set(ODEUM_INLINED_ODEINT_FILES ${odeint_files} PARENT_SCOPE)
  set(ODEUM_INLINED_17_FILES ${files_17} PARENT_SCOPE)
endfunction()

# lists/<list>.inc: a pair {"stem", text} for each file of a pattern, so that the program needs no file beside it.
function(odeum_embed list pattern)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${pattern})
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
  target_link_libraries(odeum_print PRIVATE odeum_options fmt::fmt yaml-cpp)
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

# odeum_units.cpp, see HashUnits.cmake, as a source of the program; made of the object files of the targets
# that are named, anew whenever one of them changes.
function(odeum_hash_units program)
  set(objects "")
  foreach(target IN LISTS ARGN)
    list(APPEND objects $<TARGET_OBJECTS:${target}>)
  endforeach()
  file(GENERATE OUTPUT ${ODEUM_GENERATED}/odeum_objects.txt CONTENT "$<JOIN:${objects},\n>\n")
  add_custom_command(
    OUTPUT ${ODEUM_GENERATED}/odeum_units.cpp
    COMMAND ${CMAKE_COMMAND} -DOBJECTS=${ODEUM_GENERATED}/odeum_objects.txt -DOUTPUT=${ODEUM_GENERATED}/odeum_units.cpp
            -P ${PROJECT_SOURCE_DIR}/scripts/cmake/HashUnits.cmake
    DEPENDS ${objects} ${PROJECT_SOURCE_DIR}/scripts/cmake/HashUnits.cmake
    VERBATIM)
  set_source_files_properties(${ODEUM_GENERATED}/odeum_units.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${program} PRIVATE ${ODEUM_GENERATED}/odeum_units.cpp)
endfunction()
