# SPDX-License-Identifier: BSD-3-Clause
# cmake -DNODE=<program> -DROOT=<source> -DD3=<d3.min.js> -P CheckExpressions.cmake
# What the page computes, in Node alone (tests/viewer/expressions.mjs).
if(NOT NODE)
  message("not checked: needs Node (Debian: nodejs) on the path")
  return()
endif()
execute_process(COMMAND ${NODE} ${ROOT}/tests/viewer/expressions.mjs ${D3} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the page does not compute what it should")
endif()
