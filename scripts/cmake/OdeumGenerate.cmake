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
namespace odeum {\nvoid add_${family}(std::vector<OwnMethod>& all) {\n${own}}
void add_${family}(std::vector<proof::MethodFacts>& all) {\n${facts}}\n}  // namespace odeum\n")
    endforeach()
    odeum_write_verbatim(${ODEUM_GENERATED}/own/${unit}.cpp "${text}")
    list(APPEND files ${ODEUM_GENERATED}/own/${unit}.cpp)
  endforeach()
  set(ODEUM_METHOD_FILES ${files} PARENT_SCOPE)
endfunction()

# The lists of cases (every file in cases/, its stem the function that makes it) and of studies (every folder in
# src/odeum/studies that has a study.cpp). The files are left in ODEUM_CASE_FILES.
function(odeum_generate_lists)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.cpp)
  odeum_stems(cases cases/*.cpp)
  odeum_write_list(cases ${cases})
  set(ODEUM_CASE_FILES ${files} PARENT_SCOPE)
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

# Replaces each line "// part: NAME" of a script reports/viewer/STEM.js, whose text is in VARIABLE, by
# reports/viewer/STEM/NAME.js, or by reports/viewer/shared/NAME.js, which several scripts use. Every part
# of STEM must be named.
function(odeum_join_script stem variable)
  set(script "${${variable}}")
  file(GLOB own CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/viewer/${stem}/*.js)
  file(GLOB shared CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/viewer/shared/*.js)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${own} ${shared})
  foreach(part IN LISTS own shared)
    get_filename_component(name ${part} NAME_WE)
    file(READ ${part} text)
    string(FIND "${script}" "// part: ${name}\n" place)
    if(place EQUAL -1 AND part IN_LIST own)
      message(FATAL_ERROR "${stem}.js has no place for ${stem}/${name}.js")
    endif()
    string(REPLACE "// part: ${name}\n" "${text}" script "${script}")
  endforeach()
  if(script MATCHES "// part: [a-z]+\n")
    message(FATAL_ERROR "${stem}.js names a part that is not there: ${CMAKE_MATCH_0}")
  endif()
  set(${variable} "${script}" PARENT_SCOPE)
endfunction()

# Sets ${variable} to reports/columns.md with the files of all studies: a table of what their rows are, and their
# columns, before the examples.
function(odeum_join_columns variable)
  file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/studies/*/columns.md)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/columns.md ${parts})
  set(sections "")
  set(table "## Files of studies\n\n| file | a row is |\n|---|---|\n")
  foreach(part IN LISTS parts)
    file(READ ${part} text)
    string(APPEND sections "${text}\n")
    file(STRINGS ${part} lines REGEX "^(## |A row is )")
    set(file "")
    foreach(line IN LISTS lines)
      if(line MATCHES "^## (.*)$")
        set(file "${CMAKE_MATCH_1}")
      elseif(line MATCHES "^A row is ([^.]*)" AND file)
        string(APPEND table "| `${file}` | ${CMAKE_MATCH_1} |\n")
        set(file "")
      endif()
    endforeach()
    if(file)
      message(FATAL_ERROR "${part} does not say what a row of ${file} is: a line that begins with \"A row is \"")
    endif()
  endforeach()
  file(READ ${PROJECT_SOURCE_DIR}/reports/columns.md text)
  foreach(place IN ITEMS "## Files of no study" "## With pandas")
    string(FIND "${text}" "\n${place}\n" at)
    if(at LESS 0)
      message(FATAL_ERROR "reports/columns.md has no section ${place}")
    endif()
  endforeach()
  string(REPLACE "\n## Files of no study\n" "\n${table}\n## Files of no study\n" text "${text}")
  string(REPLACE "\n## With pandas\n" "\n${sections}## With pandas\n" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# odeum_texts.cpp: the static texts of the report page (its style sheet, its scripts, the trade-offs, the
# columns of the files, the findings: reports/findings.md, then every reports/findings/*.md), see src/odeum/report/texts.hpp.
function(odeum_generate_texts)
  file(GLOB findings CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/findings/*.md)
  list(PREPEND findings ${PROJECT_SOURCE_DIR}/reports/findings.md)
  set(style ${PROJECT_SOURCE_DIR}/reports/viewer/page.css)
  set(trade_offs ${PROJECT_SOURCE_DIR}/reports/trade-offs.md)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${findings} ${style} ${trade_offs})
  set(body "#include \"odeum/report/texts.hpp\"\n\nnamespace odeum::report {\n")
  file(READ ${style} text)
  string(APPEND body "std::string_view page_style() { return R\"odeum-text(${text})odeum-text\"; }\n")
  file(READ ${trade_offs} text)
  string(APPEND body "std::string_view trade_offs() { return R\"odeum-text(${text})odeum-text\"; }\n")
  odeum_join_columns(text)
  string(APPEND body "std::string_view columns_text() { return R\"odeum-text(${text})odeum-text\"; }\n")
  set(all "")
  foreach(file IN LISTS findings)
    file(READ ${file} text)
    string(APPEND all "${text}\n")
  endforeach()
  foreach(part IN ITEMS page.js replay.html replay.css replay.js)
    file(READ ${PROJECT_SOURCE_DIR}/reports/viewer/${part} text)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/viewer/${part})
    if(part MATCHES "^(.*)\\.js$")
      odeum_join_script(${CMAKE_MATCH_1} text)
    endif()
    string(REPLACE "." "_" name ${part})
    string(APPEND body "std::string_view ${name}() { return R\"odeum-text(${text})odeum-text\"; }\n")
  endforeach()
  string(APPEND body "std::string_view findings() { return R\"odeum-text(${all})odeum-text\"; }\n}\n")
  odeum_write_verbatim(${ODEUM_GENERATED}/odeum_texts.cpp "${body}")
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
