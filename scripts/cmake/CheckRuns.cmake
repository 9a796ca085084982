# SPDX-License-Identifier: BSD-3-Clause
# cmake -DODEUM=<program> -DCHROMIUM=<program> -DNODE=<program> -DROOT=<source> -DFOLDER=<folder> -P CheckRuns.cmake
# Makes the pages of single problems and opens them in headless Chromium (tests/viewer/runs.mjs).
if(NOT CHROMIUM OR NOT NODE)
  message("not checked: needs Chromium and Node (Debian: chromium, nodejs) on the path")
  return()
endif()
file(REMOVE_RECURSE ${FOLDER})
function(make name)
  execute_process(COMMAND ${ODEUM} ${ARGN} --out ${FOLDER}/${name} OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
make(case run damped_oscillator_undamped --solver explicit_euler --solver midpoint --step 0.05)
# |1 + h lambda| = 1.4 for explicit Euler: an error of thousands on velocities of 9.
make(diverged run damped_oscillator_underdamped --solver explicit_euler --solver rk4 --step 0.5)
make(path run kepler_e06 --solver dormand_prince54 --tol 1e-6)
make(why why robertson_40 --solver dormand_prince54 --tol 1e-3)
make(scene run spring_explicit_euler --solver explicit_euler --solver midpoint --until 1)
make(types classify "y*u_xx + u_yy = 0" --divisions 24)
make(field poisson square:16 --exact "x*(1 - x)*y*(1 - y)")
make(fine poisson square:101)
execute_process(COMMAND ${NODE} ${ROOT}/tests/viewer/runs.mjs ${CHROMIUM} ${FOLDER} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a page does not hold what it should")
endif()
