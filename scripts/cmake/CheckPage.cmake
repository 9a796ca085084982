# SPDX-License-Identifier: BSD-3-Clause
# cmake -DODEUM=<program> -DCHROMIUM=<program> -DNODE=<program> -DROOT=<source> -DFOLDER=<folder>
#       -P CheckPage.cmake
# Makes a small report and opens it in headless Chromium (tests/viewer/page.mjs), and runs the commands that it prints.
if(NOT CHROMIUM OR NOT NODE)
  message("not checked: needs Chromium and Node (Debian: chromium, nodejs) on the path")
  return()
endif()
file(REMOVE_RECURSE ${FOLDER})
execute_process(
  COMMAND ${ODEUM} report --quick --case damped_oscillator_underdamped --case free_fall --case robertson_40
          --case cloth11_two_way --case pendulum_large
          --solver odeum/rk4 --solver odeum/explicit_euler --solver odeum/radau_iia5
          --solver odeum/velocity_verlet --solver gsl/rk4 --solver gsl/rk8pd --solver cvode/* --out ${FOLDER}
  OUTPUT_QUIET RESULT_VARIABLE result ERROR_VARIABLE errors)
if(errors MATCHES "was not built in|no solver matches")
  message("not checked: needs the adapters of GSL and SUNDIALS")
  return()
endif()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the report was not made (${result}): ${errors}")
endif()
# Rules of accessibility, where somebody has installed them: npm install --prefix build/axe axe-core
find_file(AXE axe.min.js PATHS ${ROOT}/build/axe/node_modules/axe-core NO_DEFAULT_PATH)
if(NOT AXE)
  set(AXE "")
endif()
execute_process(COMMAND ${NODE} ${ROOT}/tests/viewer/page.mjs ${CHROMIUM} ${FOLDER} ${AXE} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the page does not hold what it should")
endif()
# Thirty of its sentences with numbers, picked at random, equal their rows.
execute_process(COMMAND ${NODE} ${ROOT}/tests/viewer/sentences.mjs ${CHROMIUM} ${FOLDER} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a sentence of the page does not say what its rows do")
endif()
# The commands that it prints make its runs again (scripts/reproduce).
execute_process(COMMAND ${NODE} ${ROOT}/scripts/viewer/reproduce.mjs ${CHROMIUM} ${FOLDER} ${ODEUM} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a command of the page does not make its run again")
endif()
