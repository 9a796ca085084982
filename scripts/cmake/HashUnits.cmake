# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, odeum_units.cpp: a hash of the object files in the list OBJECTS (a file, one path a line)
# for each unit that results are kept by, see src/odeum/cli/kept_results.hpp:
#   own/<family>, adapter/<folder>, case/<stem of its file>; rest: all others, but for lists and pages.
file(STRINGS ${OBJECTS} objects)
list(SORT objects)
foreach(object IN LISTS objects)
  if(object MATCHES "/(odeum_build_info|odeum_cases|odeum_studies|odeum_texts|odeum_libraries|own/catalogue)\\.cpp\\.o|/odeum/report/|/odeum/studies/[a-z]+/(section[a-z_]*|study)\\.cpp\\.o|/odeum_inlined\\.dir/")
    continue()
  elseif(object MATCHES "/own/([a-z]+)\\.cpp\\.o")
    set(unit own/${CMAKE_MATCH_1})
  elseif(object MATCHES "/odeum_adapter_([a-z]+)\\.dir/")
    set(unit adapter/${CMAKE_MATCH_1})
  elseif(object MATCHES "/odeum_cases\\.dir/(\\./|generated/)?cases/([a-z0-9_]+)\\.cpp\\.o")
    set(unit case/${CMAKE_MATCH_2})
  else()
    set(unit rest)
  endif()
  file(SHA256 ${object} hash)
  list(APPEND units ${unit})
  string(APPEND hashes_${unit} ${hash})
endforeach()
list(REMOVE_DUPLICATES units)
set(rows "")
foreach(unit IN LISTS units)
  string(SHA256 hash "${hashes_${unit}}")
  string(APPEND rows "      {\"${unit}\", \"${hash}\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"odeum/cli/units.hpp\"

namespace odeum::build {
const std::vector<std::pair<std::string, std::string>> units{
${rows}};
}
")
