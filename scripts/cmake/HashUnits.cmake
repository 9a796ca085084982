# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, odeum_units.cpp: a hash of the object files in the list OBJECTS (a file, one path a line)
# for each unit that results are kept by, see src/odeum/cli/kept_results.hpp:
#   own/<family>, of an object <family>-<family>.cpp.o both; adapter/<folder>; case/<stem of its file>; rest: all
#   others, but for lists and pages.
file(STRINGS ${OBJECTS} objects)
list(SORT objects)
foreach(object IN LISTS objects)
  set(unit rest)
  if(object MATCHES "/(odeum_build_info|odeum_texts|all_cases|all_studies|cases/libraries|own_methods|proof/facts)\\.cpp\\.o")
    continue()
  elseif(object MATCHES "/odeum/report/|/odeum/studies/[a-z]+/(section[a-z_]*|study)\\.cpp\\.o|/unity_pages[a-z_]*_cxx\\.|/odeum_inlined(_odeint)?\\.dir/")
    continue()
  elseif(object MATCHES "/own/([a-z-]+)\\.cpp\\.o")
    string(REPLACE "-" ";" unit ${CMAKE_MATCH_1})
    list(TRANSFORM unit PREPEND own/)
  elseif(object MATCHES "/odeum_adapter_([a-z]+)\\.dir/")
    set(unit adapter/${CMAKE_MATCH_1})
  elseif(object MATCHES "/odeum_cases\\.dir/(\\./)?(generated/)?cases/([a-z0-9_]+)\\.cpp\\.o")
    set(unit case/${CMAKE_MATCH_3})
  endif()
  file(SHA256 ${object} hash)
  foreach(each IN LISTS unit)
    list(APPEND units ${each})
    string(APPEND hashes_${each} ${hash})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES units)
set(rows "")
foreach(unit IN LISTS units)
  string(SHA256 hash "${unit} ${hashes_${unit}}")
  string(APPEND rows "      {\"${unit}\", \"${hash}\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"odeum/cli/units.hpp\"

namespace odeum::build {
const std::vector<std::pair<std::string, std::string>> units{
${rows}};
}
")
