# SPDX-License-Identifier: BSD-3-Clause
# Part of CheckPackage.cmake: plug-ins in C and Fortran are built from the installed header alone, and
# judged by the installed program; each fault of tests/package/plugin/bad.c costs its own rows only.
configure(plugin plugin_build)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
must(${CMAKE_COMMAND} --build ${FOLDER}/plugin_build)
set(at ${FOLDER}/plugin_build)

set(ENV{XDG_CACHE_HOME} ${FOLDER})
set(good "--plugin ${at}/libmy_rk4.so --plugin ${at}/libmy_pendulum.so")

expect(0 "list solvers ${good}" "mine/rk4 +explicit_rk +4")
expect(0 "list cases ${good}" "models_driven +A driven oscillator" "models_chain")
expect(0 "doctor ${good}" "mine +plug-in .*libmy_rk4.so")
# Beside a peer, on a case of the project and on those of the other plug-in.
expect(0 "converge ${good} --case lotka_volterra --case models_* --solver mine/* --solver odeum/rk4 --solver cvode/adams --out ${FOLDER}/out"
       "lotka_volterra mine/rk4 fixed 4 [34]\\.[0-9]+ confirmed" "models_driven mine/rk4 fixed 4 [34]\\.[0-9]+ confirmed"
       "models_chain mine/rk4 fixed 4 [34]\\.[0-9]+ confirmed" "models_driven odeum/rk4 fixed 4 [34]\\.[0-9]+ confirmed"
       "lotka_volterra mine/rk4 adaptive 4 [34]\\.[0-9]+ confirmed" "lotka_volterra cvode/adams")
expect(0 "run models_chain ${good} --solver odeum/rodas4 --tol 1e-8" "status ok" "error [0-9.]+e-(09|10|11)")
# A problem without an exact solution has a computed one.
expect(0 "run models_pendulum ${good} --solver odeum/dormand_prince853 --tol 1e-10" "status ok"
       "error [0-9.]+e-(09|10|11|12) .* against computed from the plug-in models by")
expect(0 "converge ${good} --case models_pendulum --mode fixed --solver odeum/rk4 --out ${FOLDER}/out"
       "models_pendulum odeum/rk4 fixed 4 (3\\.9|4\\.0)[0-9]+ confirmed")
expect(0 "run models_driven ${good} --solver odeum/velocity_verlet --step 0.01" "status ok")
expect(0 "limits ${good} --case models_chain --solver odeum/rk4 --out ${FOLDER}/out")
expect(0 "stability ${good} --solver mine/rk4 --out ${FOLDER}/out" "rk4 +real +2\\.785")
expect(0 "precision ${good} --case lotka_volterra --solver mine/* --solver odeum/rk4 --seconds 0.1 --out ${FOLDER}/out" "mine/rk4")
# Absolute tolerances reach a solver of version 2; one of version 1 takes the relative one for both.
set(tolerances "--plugin ${at}/libmy_rk4_version1.so --rtol 1e-9 --atol 1e-3")
expect(0 "run lotka_volterra ${good} ${tolerances} --solver mine/rk4" "status ok" "error [0-9.]+(e-0[1-4])? ")
expect(0 "run lotka_volterra ${good} ${tolerances} --solver older/rk4" "status ok" "error [0-9.]+e-(07|08|09|10) ")
if(EXISTS ${at}/libmy_fortran.so)
  expect(0 "converge --plugin ${at}/libmy_fortran.so --case lotka_volterra --solver fortran/heun --out ${FOLDER}/out"
         "fortran/heun fixed 2 (1\\.9|2\\.0)[0-9]+ confirmed")
endif()

# What is refused before anything runs.
foreach(fault IN ITEMS "bad_version|version 99" "no_entry|exports no function odeum_plugin_entry" "null_plugin|returned a null pointer"
        "no_name|null pointer for its name" "taken_name|library of the name cvode already" "twice|two solvers of the name euler"
        "bad_exact|exact solution rises" "bad_rhs|rhs fails or is not finite" "crash_on_load|crashed: Aborted")
  string(REPLACE "|" ";" fault "${fault}")
  list(GET fault 0 name)
  list(GET fault 1 sentence)
  expect(2 "list solvers --plugin ${at}/libbad_${name}.so" "${sentence}")
endforeach()
expect(2 "list solvers --plugin ${at}/nothing.so" "is not a file")
expect(2 "list solvers --plugin ${at}/CMakeCache.txt" "cannot be loaded")
expect(2 "list solvers --plugin ${at}/libmy_rk4.so --plugin ${at}/libmy_rk4.so" "library of the name mine already")

# What fails in a run: the other solver's row is as without it.
foreach(fault IN ITEMS "crash|crashed: Segmentation fault" "exit_process|ended its process with exit code 0"
        "exit_late|ended its process with exit code 3" "corrupt|crashed" "nonsense|not finite" "past_state|wrote outside of its state"
        "fail|status refused: euler: step returned 7" "null_create|create returned a null pointer" "hang|no right-hand side within its budget for 5 s")
  string(REPLACE "|" ";" fault "${fault}")
  list(GET fault 0 name)
  list(GET fault 1 sentence)
  expect(3 "run lotka_volterra --plugin ${at}/libbad_${name}.so --solver bad/euler --step 0.01" "${sentence}")
endforeach()
expect(3 "run lotka_volterra --plugin ${at}/libbad_fail.so --solver bad/euler --tol 1e-3" "status refused: euler: solve returned 7")
expect(3 "run lotka_volterra --plugin ${at}/libbad_backwards.so --solver bad/euler --tol 1e-3" "moved t backwards")
# The usual silence of 5 s was waited for once; good code could not be silent for 1 s either.
set(ENV{ODEUM_SILENCE_SECONDS} 1)
# It goes on to evaluate after its budget.
expect(0 "converge --plugin ${at}/libbad_ignore_budget.so --mode fixed --case lotka_volterra --solver bad/euler --out ${FOLDER}/out"
       "bad/euler fixed 1 - over_budget.*no right-hand side within its budget for 1 s.* and was ended")
# In a run, whose budget is 600 s.
expect(3 "run lotka_volterra --plugin ${at}/libbad_ignore_budget.so --solver bad/euler --step 0.01" "at one time for ever, and was ended")
expect(0 "converge --plugin ${at}/libbad_crash.so --mode fixed --case lotka_volterra --case bad_decay --solver bad/euler --solver odeum/rk4 --out ${FOLDER}/out"
       "lotka_volterra bad/euler fixed 1 - failed" "lotka_volterra odeum/rk4 fixed 4 [34]\\.[0-9]+ confirmed"
       "bad_decay odeum/rk4 fixed 4 [34]\\.[0-9]+ confirmed")

# A problem that fails only later, for whoever solves it and for what else looks at it.
expect(3 "run bad_decay --plugin ${at}/libbad_rhs_hang.so --solver odeum/rk4 --step 0.1" "no right-hand side within its budget for 1 s")
expect(0 "converge --plugin ${at}/libbad_rhs_crash.so --mode fixed --case lotka_volterra --case bad_decay --solver gsl/rk4 --solver odeum/rk4 --out ${FOLDER}/out"
       "bad_decay odeum/rk4 fixed 4 - failed.*crashed: Aborted" "lotka_volterra odeum/rk4 fixed 4 [34]\\.[0-9]+ confirmed")
