# SPDX-License-Identifier: BSD-3-Clause
# cmake -DBUILD=<build folder> -DFOLDER=<folder> -DDOCS=<where documents go> -P CheckInstall.cmake
# Installs into a fresh folder and runs the installed program in another, without the
# checkout: a case, a built-in scene, an installed tableau. No program and no library searches the current
# folder or a relative one for libraries: the file libz.so.1 there is not a library, and who loads it fails.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/elsewhere)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix
                OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
find_program(READELF readelf REQUIRED)
file(GLOB peers ${FOLDER}/prefix/lib/odeum/peers/*.so ${FOLDER}/prefix/lib/odeum/*.so)
foreach(file IN ITEMS ${BUILD}/odeum ${FOLDER}/prefix/bin/odeum ${peers})
  execute_process(COMMAND ${READELF} -d ${file} OUTPUT_VARIABLE sections COMMAND_ERROR_IS_FATAL ANY)
  if(sections MATCHES "\\((RPATH|RUNPATH)\\)[^[]*\\[([^]]*)\\]")
    set(path "${CMAKE_MATCH_2}")
    if(NOT ":${path}" MATCHES "^(:\\$ORIGIN/[^:]+)+$")
      message(FATAL_ERROR "${file} searches for libraries in \"${path}\"; only $ORIGIN/... is expected")
    endif()
  endif()
endforeach()
# Nothing that a run could write to decides which function is called; what is not tuned for this processor guards its
# stack and its copies, too.
execute_process(COMMAND ${READELF} -dlW ${FOLDER}/prefix/bin/odeum OUTPUT_VARIABLE sections COMMAND_ERROR_IS_FATAL ANY)
foreach(mark IN ITEMS "GNU_RELRO" "BIND_NOW" "GNU_STACK[^\n]* RW ")
  if(NOT sections MATCHES "${mark}")
    message(FATAL_ERROR "the installed program has no ${mark}")
  endif()
endforeach()
if(NOT NATIVE)
  execute_process(COMMAND ${READELF} -W --dyn-syms ${FOLDER}/prefix/bin/odeum OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  foreach(mark IN ITEMS __stack_chk_fail _chk@)
    if(NOT symbols MATCHES "${mark}")
      message(FATAL_ERROR "the installed program does not call ${mark}")
    endif()
  endforeach()
endif()
file(WRITE ${FOLDER}/elsewhere/libz.so.1 "no library")
execute_process(COMMAND ${EMULATOR} ${BUILD}/odeum --version WORKING_DIRECTORY ${FOLDER}/elsewhere
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# Runs the program; its output has to hold the pattern.
function(expect pattern)
  execute_process(COMMAND ${EMULATOR} ${FOLDER}/prefix/bin/odeum ${ARGN} WORKING_DIRECTORY ${FOLDER}/elsewhere
                  OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "odeum ${ARGN}: ${result}, no \"${pattern}\" in\n${output}\n${errors}")
  endif()
endfunction()
expect("hanging_cloth" list scenes)
expect("pleiades" run pleiades --solver rk4 --step 0.01)
expect("spinning pair" run spinning_pair --until 0.1 --out run)
if(EXISTS ${FOLDER}/prefix/lib/odeum/odeum_sbml.so)
  file(WRITE ${FOLDER}/elsewhere/decay.xml "<?xml version='1.0' encoding='UTF-8'?>
<sbml xmlns='http://www.sbml.org/sbml/level3/version2/core' level='3' version='2'><model>
<listOfParameters><parameter id='x' value='1' constant='false'/></listOfParameters>
<listOfRules><rateRule variable='x'><math xmlns='http://www.w3.org/1998/Math/MathML'>
<apply><minus/><ci>x</ci></apply></math></rateRule></listOfRules></model></sbml>")
  expect("x' = " run decay.xml --until 1 --solver rk4 --step 0.1)
endif()
expect("Gauss" verify ${FOLDER}/prefix/${DOCS}/cases/tableaus/gauss4.yaml)
foreach(file IN ITEMS replay.html final.csv)
  if(NOT EXISTS ${FOLDER}/elsewhere/run/${file})
    message(FATAL_ERROR "the installed program wrote no ${file}")
  endif()
endforeach()
foreach(file IN ITEMS README.md LICENSE reports/findings.md reports/docs/tutorial.md cases/scenes/chain.yaml cases/reference)
  if(NOT EXISTS ${FOLDER}/prefix/${DOCS}/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()
foreach(file IN ITEMS bash-completion/completions/odeum zsh/vendor-completions/_odeum fish/vendor_completions.d/odeum.fish
        man/man1/odeum.1)
  file(READ ${FOLDER}/prefix/share/${file} text LIMIT 1000)
  if(NOT text MATCHES "odeum")
    message(FATAL_ERROR "share/${file} was not installed")
  endif()
endforeach()
