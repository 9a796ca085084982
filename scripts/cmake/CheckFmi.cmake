# SPDX-License-Identifier: BSD-3-Clause
# Part of CheckPackage.cmake: FMUs are made of C outside of the tree and put before the installed program.
set(ENV{XDG_CACHE_HOME} ${FOLDER})
run(${PREFIX}/bin/odeum doctor)
if(output MATCHES "fmi +not built in")
  message("not checked: this build is without FMI")
  return()
endif()
configure(fmi fmi_build)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
must(${CMAKE_COMMAND} --build ${FOLDER}/fmi_build)
set(at ${FOLDER}/fmi_build)

foreach(version IN ITEMS 2 3)
  set(fmu ${at}/oscillator${version}.fmu)
  expect(0 "run ${fmu}" "Oscillator .FMI ${version}.0, Model Exchange" "set mu = 1, a = 0, fault = 0" "states 2: x, v"
         "truth computed by .* known to [0-9.]+e-1[2-5]")
  expect(0 "run ${fmu} --set mu=0 --solver odeum/rodas4 cvode/bdf --tol 1e-8" "set mu = 0" "odeum/rodas4 .*status ok .*error [0-9.]+e-0[789]"
         "cvode/bdf .*status ok")
endforeach()
# A model with events: they are located, told, and crossed by the truth.
set(ball ${at}/ball3.fmu)
expect(0 "run ${ball}" "events 1 event indicator, located" "truth computed by .* known to [0-9.]+e-1[0-5]")
expect(0 "run ${ball} --set e=0.5 --solver odeum/rodas4 cvode/bdf --tol 1e-8" "odeum/rodas4 .*status ok .*events 6: state event at t = 0.4515.*error ")
# The FMU beside a case of the project, in each kind of study.
expect(0 "converge ${fmu} lotka_volterra --mode fixed --solver odeum/rk4 --solver odeum/rodas4 --solver gsl/rk4 --out ${FOLDER}/out"
       "oscillator3 odeum/rk4 fixed 4 (3\\.9|4\\.0)[0-9]+ confirmed" "oscillator3 odeum/rodas4 fixed 4 [34]\\.[0-9]+ confirmed"
       "oscillator3 gsl/rk4 fixed 4 (3\\.9|4\\.0)[0-9]+ confirmed" "lotka_volterra odeum/rk4 fixed 4 [34]\\.[0-9]+ confirmed")
expect(0 "limits ${fmu} --solver odeum/rk4 --out ${FOLDER}/out" "oscillator3 odeum/rk4")
expect(0 "drift ${fmu} --solver odeum/rk4 --out ${FOLDER}/out" "no invariant of the case is known")
# Its work-precision diagram, by the report's page.
expect(0 "report ${fmu} --solver odeum/rk4 --solver odeum/dormand_prince54 --solver cvode/adams --out ${FOLDER}/report")
file(STRINGS ${FOLDER}/report/precision.csv rows REGEX "oscillator3,.*,ok,")
list(LENGTH rows count)
if(count LESS 20)
  message(FATAL_ERROR "the report has ${count} points of precision for the FMU")
endif()
file(READ ${FOLDER}/report/page.json text)
if(NOT text MATCHES "\"id\":\"oscillator3\"" OR NOT text MATCHES "\"name\":\"precision\",\"file\"[^{]*\"parts\":.{\"data\":\"precision\"[^}]*}.,\"cases\":.\"oscillator3\"")
  message(FATAL_ERROR "page.json has no points of the FMU to draw")
endif()
# What is refused; reasons are tested in tests/adapters/fmi_test.cpp.
expect(2 "run ${at}/nothing.fmu" "nothing.fmu: is not a file")
expect(2 "converge ${fmu} --set nu=1" "the model has no variable nu; it has x, v, mu, a, fault")
file(WRITE ${FOLDER}/u.csv "time,u\n0,1\n")
expect(2 "run ${fmu} --inputs ${FOLDER}/u.csv" "u.csv:1:6: inputs: the model has no such input; got u, expected no column")
expect(2 "run lotka_volterra --inputs ${FOLDER}/u.csv" "--inputs: got lotka_volterra, expected an FMU")
expect(2 "run ${fmu} --set fault=9" "foreign code crashed: Aborted")
expect(3 "run ${fmu} --set fault=3 --solver odeum/rk4 --step 0.01" "foreign code crashed: Aborted")
# A run of too many steps is refused before a truth is computed.
file(ARCHIVE_EXTRACT INPUT ${fmu} DESTINATION ${FOLDER}/long)
file(READ ${FOLDER}/long/modelDescription.xml text)
string(REGEX REPLACE "stopTime=\"[^\"]*\"" "stopTime=\"1e300\"" text "${text}")
file(WRITE ${FOLDER}/long/modelDescription.xml "${text}")
must(${CMAKE_COMMAND} -E chdir ${FOLDER}/long ${CMAKE_COMMAND} -E tar cf ${FOLDER}/long.fmu --format=zip .)
expect(2 "run ${FOLDER}/long.fmu --solver odeum/rk4 --step 0.1" "more than 1e.09 steps to t = 1e.300")
if(output MATCHES "truth")
  message(FATAL_ERROR "a truth was computed for 1e300 seconds: ${output}")
endif()
