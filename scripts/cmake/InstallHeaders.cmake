# SPDX-License-Identifier: BSD-3-Clause
# Run by cmake --install with ODEUM_SOURCE, ODEUM_INCLUDE (a folder below the prefix) and ODEUM_UNITS (sources that are
# installed to be compiled elsewhere): installs the headers of the documented interfaces, and all that these include.
# Interfaces: integration, methods, a stepper's accuracy test; of the laboratory its catalogue of cases.
file(GLOB next RELATIVE ${ODEUM_SOURCE}/src ${ODEUM_SOURCE}/src/odeum/api/*.hpp ${ODEUM_SOURCE}/src/odeum/methods/*.hpp
     ${ODEUM_SOURCE}/src/odeum/accuracy/*.hpp)
list(APPEND next odeum/cases/catalogue.hpp odeum/problem/shared.hpp odeum/input/near_words.hpp ${ODEUM_UNITS})
set(seen "")
while(next)
  list(POP_BACK next file)
  list(FIND seen ${file} at)
  if(NOT at EQUAL -1 OR NOT EXISTS ${ODEUM_SOURCE}/src/${file})  # generated, or installed elsewhere
    continue()
  endif()
  list(APPEND seen ${file})
  if(file MATCHES "\\.hpp$")
    get_filename_component(folder ${file} DIRECTORY)
    file(INSTALL ${ODEUM_SOURCE}/src/${file} DESTINATION ${CMAKE_INSTALL_PREFIX}/${ODEUM_INCLUDE}/${folder})
  endif()
  file(STRINGS ${ODEUM_SOURCE}/src/${file} lines REGEX "^#include \"odeum/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE ".*\"([^\"]+)\".*" "\\1" included "${line}")
    list(APPEND next ${included})
  endforeach()
endwhile()
