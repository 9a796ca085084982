# SPDX-License-Identifier: BSD-3-Clause
# Generates the lists of methods, cases, studies and libraries from their files and folders. Globs use
# CONFIGURE_DEPENDS: the next build picks up a new file. Headers are written only
# when their text changes, so an unrelated re-configure rebuilds nothing.

set(ODEUM_GENERATED ${PROJECT_BINARY_DIR}/generated)

function(odeum_write path text)
  file(CONFIGURE OUTPUT ${path} CONTENT "${text}" @ONLY)
endfunction()

# odeum_methods.hpp: every file in src/odeum/methods, its stem the method's type and id. own/*.cpp: a
# unit for each family of them, the files whose names begin with the same word, which compiles its
# members for the shared types (solvers/own_methods.hpp) and for the proofs (proof/facts.hpp), and
# catalogue.cpp, which lists all. Their names are left in ODEUM_METHOD_FILES.
function(odeum_generate_methods)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/methods/*.hpp)
  set(includes "")
  set(types "")
  set(families "")
  foreach(file IN LISTS files)
    get_filename_component(stem ${file} NAME_WE)
    string(APPEND includes "#include \"odeum/methods/${stem}.hpp\"\n")
    list(APPEND types ${stem})
    string(REGEX MATCH "^[a-z]+" family ${stem})
    list(APPEND families ${family})
    list(APPEND members_${family} ${stem})
  endforeach()
  list(JOIN types ",\n                       " list)
  odeum_write(${ODEUM_GENERATED}/odeum_methods.hpp
"#pragma once
#include \"odeum/kernel/method_list.hpp\"
${includes}
namespace odeum::methods {
using All = MethodList<${list}>;
}
")
  list(REMOVE_DUPLICATES families)
  set(units "")
  set(declarations "")
  set(calls "")
  foreach(family IN LISTS families)
    set(includes "")
    set(own "")
    set(facts "")
    foreach(stem IN LISTS members_${family})
      string(APPEND includes "#include \"odeum/methods/${stem}.hpp\"\n")
      string(APPEND own "  all.push_back(own_method<methods::${stem}>());\n")
      string(APPEND facts "  all.push_back(proof::facts_of<methods::${stem}>());\n")
    endforeach()
    odeum_write(${ODEUM_GENERATED}/own/${family}.cpp
"#include \"odeum/solvers/enroll_method.hpp\"
#include \"odeum/proof/facts_of.hpp\"
${includes}
namespace odeum {
void add_${family}(std::vector<OwnMethod>& all) {
${own}}
void add_${family}(std::vector<proof::MethodFacts>& all) {
${facts}}
}
")
    list(APPEND units ${ODEUM_GENERATED}/own/${family}.cpp)
    string(APPEND declarations "void add_${family}(std::vector<OwnMethod>&);\nvoid add_${family}(std::vector<proof::MethodFacts>&);\n")
    string(APPEND calls "    add_${family}(list);\n")
  endforeach()
  odeum_write(${ODEUM_GENERATED}/own/catalogue.cpp
"#include \"odeum/solvers/own_methods.hpp\"
#include \"odeum/proof/facts.hpp\"

namespace odeum {
${declarations}
const std::vector<OwnMethod>& own_methods() {
  static const std::vector<OwnMethod> all = [] {
    std::vector<OwnMethod> list;
${calls}    return list;
  }();
  return all;
}
const std::vector<proof::MethodFacts>& proof::all_method_facts() {
  static const std::vector<MethodFacts> all = [] {
    std::vector<MethodFacts> list;
${calls}    return list;
  }();
  return all;
}
}
")
  set(ODEUM_METHOD_FILES ${units} ${ODEUM_GENERATED}/own/catalogue.cpp PARENT_SCOPE)
endfunction()

# odeum_cases.cpp: all_cases() from every file in cases/, its stem the function that makes it, and
# case_files(), which names them. A text is printed as C++, by odeum_print_cases().
function(odeum_generate_cases)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.cpp ${PROJECT_SOURCE_DIR}/cases/*.yaml)
  set(stems "")
  set(units "")
  set(texts "")
  foreach(file IN LISTS files)
    get_filename_component(stem ${file} NAME_WE)
    list(APPEND stems ${stem})
    if(file MATCHES "\\.yaml$")
      list(APPEND texts ${file})
      list(APPEND units ${ODEUM_GENERATED}/cases/${stem}.cpp)
    else()
      list(APPEND units ${file})
    endif()
  endforeach()
  list(SORT stems)
  set(declarations "")
  set(calls "")
  foreach(stem IN LISTS stems)
    string(APPEND declarations "std::vector<Case> ${stem}();\n")
    string(APPEND calls "    add(cases::${stem}(), \"${stem}\");\n")
  endforeach()
  odeum_write(${ODEUM_GENERATED}/odeum_cases.cpp
"#include <utility>

#include \"odeum/solvers/case.hpp\"
#include \"odeum/solvers/case_files.hpp\"
#include \"odeum/cases/runtime_cases.hpp\"

namespace odeum {
namespace cases {
${declarations}}
namespace {
std::map<std::string, std::string> files;
}
const std::vector<Case>& all_cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    const auto add = [&](std::vector<Case> more, const char* file) {
      for (Case& c : more) {
        if (file) files[c.id] = file;
        list.push_back(std::move(c));
      }
    };
${calls}    add(cases::runtime_cases(), nullptr);
    return list;
  }();
  return all;
}
const std::map<std::string, std::string>& case_files() {
  all_cases();
  return files;
}
}
")
  set(ODEUM_CASE_FILES ${units} ${ODEUM_GENERATED}/odeum_cases.cpp PARENT_SCOPE)
  set(ODEUM_CASE_TEXTS ${texts} PARENT_SCOPE)
endfunction()

# What prints texts as C++ (src/odeum/print), and a command for each of ODEUM_CASE_TEXTS: its problem as
# generated/problems/<stem>.hpp, its cases as generated/cases/<stem>.cpp; the target odeum_printed is all of them.
function(odeum_print_cases)
  add_executable(odeum_print ${PROJECT_SOURCE_DIR}/src/odeum/print/main.cpp $<TARGET_OBJECTS:odeum_formula>)
  target_include_directories(odeum_print PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(odeum_print PRIVATE odeum_options fmt::fmt yaml-cpp)
  set(printed "")
  foreach(text IN LISTS ODEUM_CASE_TEXTS)
    get_filename_component(stem ${text} NAME_WE)
    set(outputs ${ODEUM_GENERATED}/problems/${stem}.hpp ${ODEUM_GENERATED}/cases/${stem}.cpp)
    add_custom_command(OUTPUT ${outputs} COMMAND odeum_print ${text} ${ODEUM_GENERATED} DEPENDS ${text} VERBATIM)
    list(APPEND printed ${outputs})
  endforeach()
  add_custom_target(odeum_printed DEPENDS ${printed})
endfunction()

# odeum_studies.cpp: make_studies() from every folder in src/odeum/studies that has a study.cpp, which
# defines std::unique_ptr<Study> make_<folder>().
function(odeum_generate_studies)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/studies/*/study.cpp)
  set(declarations "")
  set(calls "")
  foreach(file IN LISTS files)
    get_filename_component(name ${file} DIRECTORY)
    get_filename_component(name ${name} NAME)
    string(APPEND declarations "std::unique_ptr<Study> make_${name}();\n")
    string(APPEND calls "  studies.push_back(make_${name}());\n")
  endforeach()
  odeum_write(${ODEUM_GENERATED}/odeum_studies.cpp
"#include <algorithm>

#include \"odeum/studies/study.hpp\"

namespace odeum::study {
${declarations}
Studies make_studies() {
  Studies studies;
${calls}  std::stable_sort(studies.begin(), studies.end(), [](const auto& a, const auto& b) {
    return a->declaration().place < b->declaration().place;
  });
  return studies;
}
}
")
endfunction()

# The unit of rosenbrock4 for a file of cases/inlined, whose `using` names the type of its problem.
function(odeum_write_rosenbrock problem stem)
  file(STRINGS ${problem} alias REGEX "^using ${stem} = ")
  string(REGEX REPLACE "^using ${stem} = ([A-Za-z0-9_]+).*" "\\1" type "${alias}")
  file(STRINGS ${problem} header REGEX "#include \"problems/")
  set(arguments "const OdeView& view, double t0, const std::vector<double>& y0, const Request& request")
  odeum_write(${ODEUM_GENERATED}/inlined/rosenbrock_${stem}.cpp
"#include \"odeint/rosenbrock.hpp\"
${header}

namespace odeum::cases::inlined {
Outcome rosenbrock4_${stem}(${arguments}) {
  return adapters::odeint::run_bare_rosenbrock4<${type}>(view, t0, y0, request);
}
Outcome rosenbrock4_dense_output_${stem}(${arguments}) {
  return adapters::odeint::run_bare_rosenbrock4_dense_output<${type}>(view, t0, y0, request);
}
}
")
endfunction()

# inlined_solvers() of solvers/inlined.hpp, see src/odeum/cases/inlined.hpp: a unit for each method with
# `inlined` in its file, and one for odeint on each problem of cases/inlined, whose stem names
# the problem's type. Their names are left in ODEUM_INLINED_FILES. Where a problem's file says that its
# header is plain C++17, a unit of that standard has odeint's rosenbrock4 on it (uBLAS asks for
# that); those names are left in ODEUM_INLINED_17_FILES.
function(odeum_generate_inlined)
  file(GLOB problems CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/inlined/*.hpp)
  file(GLOB methods CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/odeum/methods/*.hpp)
  if(NOT ODEUM_INLINED)
    set(problems "")
    set(methods "")
  endif()
  set(includes "")
  set(types "")
  set(names "")
  set(units "")
  set(units_17 "")
  set(rosenbrock_declarations "")
  set(rosenbrock_calls "")
  foreach(problem IN LISTS problems)
    get_filename_component(stem ${problem} NAME_WE)
    file(STRINGS ${problem} plain_17 REGEX "plain C\\+\\+17")
    if("odeint" IN_LIST ODEUM_ADAPTERS_BUILT AND plain_17)
      odeum_write_rosenbrock(${problem} ${stem})
      list(APPEND units_17 ${ODEUM_GENERATED}/inlined/rosenbrock_${stem}.cpp)
      foreach(run IN ITEMS rosenbrock4 rosenbrock4_dense_output)
        string(APPEND rosenbrock_declarations
               "Outcome ${run}_${stem}(const OdeView&, double, const std::vector<double>&, const Request&);\n")
      endforeach()
      string(APPEND rosenbrock_calls
             "  add_rosenbrock4<${stem}>(c, all, rosenbrock4_${stem}, rosenbrock4_dense_output_${stem});\n")
    endif()
    string(APPEND includes "#include \"inlined/${stem}.hpp\"\n")
    string(APPEND types ", ${stem}")
    # All that odeint inlines is explicit.
    file(STRINGS ${problem} stiff_only REGEX "has_nonstiff_cases<.*> = false")
    if("odeint" IN_LIST ODEUM_ADAPTERS_BUILT AND NOT stiff_only)
      odeum_write(${ODEUM_GENERATED}/inlined/odeint_${stem}.cpp
"#include \"inlined/${stem}.hpp\"
#include \"odeint/inlined_cases.hpp\"

namespace odeum::cases::inlined {
void add_odeint_${stem}(const Case& c, std::vector<Entrant>& all) { add_odeint<${stem}>(c, all); }
}
")
      list(APPEND names odeint_${stem})
    endif()
  endforeach()
  if(units_17)
    odeum_write(${ODEUM_GENERATED}/inlined/rosenbrock4.cpp
"${includes}#include \"odeint/inlined_rosenbrock.hpp\"

namespace odeum::cases::inlined {
${rosenbrock_declarations}
void add_rosenbrock4(const Case& c, std::vector<Entrant>& all) {
${rosenbrock_calls}}
}
")
    list(APPEND names rosenbrock4)
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${methods} ${problems})
  foreach(method IN LISTS methods)
    file(STRINGS ${method} inlined REGEX "inlined = Inlined::")
    if(inlined)
      get_filename_component(stem ${method} NAME_WE)
      odeum_write(${ODEUM_GENERATED}/inlined/${stem}.cpp
"#include \"odeum/cases/inlined.hpp\"
#include \"odeum/methods/${stem}.hpp\"
${includes}
namespace odeum::cases::inlined {
void add_${stem}(const Case& c, std::vector<Entrant>& all) {
  add_method<methods::${stem}${types}>(c, all);
}
}
")
      list(APPEND names ${stem})
    endif()
  endforeach()
  set(declarations "")
  set(calls "")
  foreach(name IN LISTS names)
    list(APPEND units ${ODEUM_GENERATED}/inlined/${name}.cpp)
    string(APPEND declarations "void add_${name}(const Case&, std::vector<Entrant>&);\n")
    string(APPEND calls "  cases::inlined::add_${name}(c, all);\n")
  endforeach()
  odeum_write(${ODEUM_GENERATED}/inlined/all.cpp
"#include \"odeum/solvers/inlined.hpp\"

namespace odeum {
namespace cases::inlined {
${declarations}}
std::vector<Entrant> inlined_solvers([[maybe_unused]] const Case& c) {
  std::vector<Entrant> all;
${calls}  return all;
}
}
")
  set(ODEUM_INLINED_FILES ${units} ${ODEUM_GENERATED}/inlined/all.cpp PARENT_SCOPE)
  set(ODEUM_INLINED_17_FILES ${units_17} PARENT_SCOPE)
endfunction()

# odeum_reference.hpp/.cpp: the text of every file in cases/reference, so that the program needs
# no file beside it.
function(odeum_generate_reference)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/reference/*.csv)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(body "")
  foreach(file IN LISTS files)
    get_filename_component(stem ${file} NAME_WLE)
    file(READ ${file} text)
    string(APPEND body "  if (name == \"${stem}\") return R\"csv(${text})csv\";\n")
  endforeach()
  odeum_write(${ODEUM_GENERATED}/odeum_reference.hpp
"#pragma once
#include <string_view>
namespace odeum::cases {
/// The text of cases/reference/<name>.csv; throws std::runtime_error where there is none.
std::string_view reference_text(std::string_view name);
}
")
  odeum_write(${ODEUM_GENERATED}/odeum_reference.cpp
"#include \"odeum_reference.hpp\"

#include <stdexcept>
#include <string>

namespace odeum::cases {
std::string_view reference_text(std::string_view name) {
${body}  throw std::runtime_error(\"no reference \" + std::string(name));
}
}
")
endfunction()

# odeum_scenes.cpp: the text of every file in cases/scenes, see src/odeum/cases/scene_case.hpp.
function(odeum_generate_scenes)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/scenes/*.yaml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(body "")
  foreach(file IN LISTS files)
    get_filename_component(stem ${file} NAME_WLE)
    file(READ ${file} text)
    string(APPEND body "      {\"${stem}\", R\"odeum-scene(${text})odeum-scene\"},\n")
  endforeach()
  odeum_write_verbatim(${ODEUM_GENERATED}/odeum_scenes.cpp
"#include \"odeum/cases/scene_case.hpp\"

namespace odeum::cases {
const std::vector<SceneText>& all_scenes() {
  static const std::vector<SceneText> all{
${body}  };
  return all;
}
}
")
endfunction()

# Writes a text as it is, only when it changes. (odeum_write would replace @...@ within it.)
function(odeum_write_verbatim path text)
  set(old "")
  if(EXISTS ${path})
    file(READ ${path} old)
  endif()
  if(NOT old STREQUAL text)
    file(WRITE ${path} "${text}")
  endif()
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

# odeum_adapters.hpp/.cpp: enroll_adapters() over every folder in adapters/, all_libraries(),
# linear_peers() and variants(). A folder NAME has a CMakeLists.txt that calls odeum_adapter(...), and, for integrators, an
# enroll.hpp that declares
#   template <Ode P> void odeum::adapters::NAME::enroll(const Contest<P>&, std::vector<Entrant>&);
# and, for solvers of sparse symmetric systems, a linear.hpp that declares
#   void odeum::adapters::NAME::add_linear_peers(std::vector<linear::LinearPeerInfo>&);
# and, where users of the library tune options, a variants.hpp that declares
#   void odeum::adapters::NAME::add_variants(std::map<std::string, std::vector<Variant>>&);
macro(odeum_add_adapters)
  file(GLOB odeum_adapter_folders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/adapters/*/CMakeLists.txt)
  foreach(odeum_folder IN LISTS odeum_adapter_folders)
    get_filename_component(odeum_folder ${odeum_folder} DIRECTORY)
    add_subdirectory(${odeum_folder})
  endforeach()
  # Set by odeum_adapter in the folders' own scopes, hence global properties.
  get_property(ODEUM_ADAPTERS_BUILT GLOBAL PROPERTY ODEUM_ADAPTERS_BUILT)
  get_property(ODEUM_LIBRARY_ROWS GLOBAL PROPERTY ODEUM_LIBRARY_ROWS)
  set(odeum_includes "")
  set(odeum_calls "")
  set(odeum_list_includes "")
  set(odeum_variant_calls "")
  set(odeum_linear_calls "")
  foreach(odeum_name IN LISTS ODEUM_ADAPTERS_BUILT)
    if(EXISTS ${PROJECT_SOURCE_DIR}/adapters/${odeum_name}/enroll.hpp)
      string(APPEND odeum_includes "#include \"${odeum_name}/enroll.hpp\"\n")
      string(APPEND odeum_calls "  adapters::${odeum_name}::enroll(contest, entrants);\n")
    endif()
    if(EXISTS ${PROJECT_SOURCE_DIR}/adapters/${odeum_name}/linear.hpp)
      string(APPEND odeum_list_includes "#include \"${odeum_name}/linear.hpp\"\n")
      string(APPEND odeum_linear_calls "    adapters::${odeum_name}::add_linear_peers(list);\n")
    endif()
    if(EXISTS ${PROJECT_SOURCE_DIR}/adapters/${odeum_name}/variants.hpp)
      string(APPEND odeum_list_includes "#include \"${odeum_name}/variants.hpp\"\n")
      string(APPEND odeum_variant_calls "    adapters::${odeum_name}::add_variants(by_solver);\n")
    endif()
  endforeach()
  odeum_write(${ODEUM_GENERATED}/odeum_adapters.hpp
"#pragma once
#include <vector>

#include \"odeum/solvers/solver.hpp\"
${odeum_includes}
namespace odeum {
template <Ode P>
void enroll_adapters([[maybe_unused]] const Contest<P>& contest,
                     [[maybe_unused]] std::vector<Entrant>& entrants) {
${odeum_calls}}
}
")
  odeum_write(${ODEUM_GENERATED}/odeum_libraries.cpp
"#include \"odeum/solvers/case.hpp\"
#include \"odeum/solvers/runtime_library.hpp\"
#include \"odeum/solvers/variants.hpp\"
#include \"odeum/linear/eigen_solvers.hpp\"
${odeum_list_includes}
namespace odeum {
const std::vector<LibraryInfo>& built_in_libraries() {
  static const std::vector<LibraryInfo> all{
${ODEUM_LIBRARY_ROWS}  };
  return all;
}
const std::vector<linear::LinearPeerInfo>& linear::linear_peers() {
  static const std::vector<LinearPeerInfo> all = [] {
    std::vector<LinearPeerInfo> list;
    add_eigen_peers(list);
${odeum_linear_calls}    return list;
  }();
  return all;
}
std::vector<Variant> variants_of(const std::string& solver) {
  static const std::map<std::string, std::vector<Variant>> all = [] {
    std::map<std::string, std::vector<Variant>> by_solver;
${odeum_variant_calls}    return by_solver;
  }();
  const auto tuned = all.find(solver);
  return tuned == all.end() ? std::vector<Variant>{} : tuned->second;
}
}
")
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
