# SPDX-License-Identifier: BSD-3-Clause
# Part of CheckPackage.cmake: the programs that `odeum run ... --code` prints are compiled against the
# installed package, run, and end at the state of the run.
set(odeum ${PREFIX}/bin/odeum)
file(WRITE ${FOLDER}/driven.yaml "parameters: {k: 2, w: 3}
states: {x: 1, v: 0}
equations: {x: v, v: \"-k*x - 0.1*v + sin(w*t)\"}
time: {end: 10}
")
file(WRITE ${FOLDER}/bounces.yaml "parameters: {r: 0.7}
states: {h: 1, v: 0, n: 0}
equations: {h: v, v: -9.81, n: 0}
time: {end: 2}
events:
  - {when: h, falling: true, set: {h: 0, v: -r*v, n: n + 1}}
  - {at: 0.25, every: 0.5, until: 1.5, set: {v: v + 0.1}}
")
set(runs "${FOLDER}/bounces.yaml --solver dormand_prince54 --tol 1e-8" "lotka_volterra --solver rk4 --step 0.01" "kepler_e06 --solver velocity_verlet --step 0.01"
         "vdp_mu1 --solver radau_iia5 --tol 1e-9" "damped_oscillator_critical --solver gragg_bulirsch_stoer --tol 1e-9"
         "${FOLDER}/driven.yaml --set k=3 --solver rodas4 --tol 1e-7" "${FOLDER}/driven.yaml --solver gsl/bsimp --tol 1e-8"
         "lotka_volterra --solver cvode/adams --tol 1e-8" "hires --solver cvode/bdf --tol 1e-6"
         "kepler_e06 --solver odeint/runge_kutta_dopri5 --tol 1e-8")
file(WRITE ${FOLDER}/projects/code/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(code LANGUAGES CXX)
find_package(Odeum REQUIRED COMPONENTS laboratory)
")
set(index 0)
foreach(line IN LISTS runs)
  separate_arguments(words UNIX_COMMAND "${line}")
  execute_process(COMMAND ${odeum} run ${words} --code OUTPUT_VARIABLE code ERROR_VARIABLE errors RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${line} --code: ${result}\n${errors}")
  endif()
  file(WRITE ${FOLDER}/projects/code/run${index}.cpp "${code}")
  file(APPEND ${FOLDER}/projects/code/CMakeLists.txt "add_executable(run${index} run${index}.cpp)
target_link_libraries(run${index} PRIVATE Odeum::laboratory)
")
  math(EXPR index "${index} + 1")
endforeach()
configure(code code_build -DCMAKE_CXX_COMPILER=${COMPILER})
must(${CMAKE_COMMAND} --build ${FOLDER}/code_build)
set(index 0)
foreach(line IN LISTS runs)
  separate_arguments(words UNIX_COMMAND "${line}")
  must(${FOLDER}/code_build/run${index})
  set(printed "${output}")
  must(${odeum} run ${words})
  # The first ten digits of the first component: flags may round the others in another way.
  string(REGEX MATCH "state +(-?[0-9.]+)" ignored "${output}")
  string(SUBSTRING "${CMAKE_MATCH_1}" 0 11 state)
  string(FIND "${printed}" "\n${state}" place)
  if(state STREQUAL "" OR place EQUAL -1)
    message(FATAL_ERROR "odeum run ${line} ends at ${CMAKE_MATCH_1}, the printed program says\n${printed}")
  endif()
  math(EXPR index "${index} + 1")
endforeach()
run(${odeum} run lotka_volterra --solver arkode/erkstep_cash_karp_6_4_5 --tol 1e-8 --code)
if(NOT result EQUAL 2 OR NOT output MATCHES "there is no program for arkode")
  message(FATAL_ERROR "--code for a peer: ${result}\n${output}")
endif()
run(${odeum} run ${FOLDER}/bounces.yaml --solver cvode/bdf --tol 1e-8 --code)
if(NOT result EQUAL 2 OR NOT output MATCHES "on a text with events")
  message(FATAL_ERROR "--code for a peer with events: ${result}\n${output}")
endif()
