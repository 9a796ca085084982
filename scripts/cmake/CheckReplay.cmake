# SPDX-License-Identifier: BSD-3-Clause
# cmake -DODEUM=<program> -DCHROMIUM=<program> -DFOLDER=<folder> -P CheckReplay.cmake
# Runs a scene and opens its replay page in headless Chromium: the page draws (attributes of
# its root state that and the number of pixels drawn), and no script fails.
if(NOT CHROMIUM)
  message("not checked: needs Chromium (Debian: chromium) on the path")
  return()
endif()
foreach(scene IN ITEMS spinning_pair fountain cloth_on_sphere cloth_over_ball)
  set(out ${FOLDER}/${scene})
  file(REMOVE_RECURSE ${out})
  execute_process(COMMAND ${ODEUM} run ${scene} --until 0.3 --no-truth --out ${out} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(
    COMMAND ${CHROMIUM} --headless --no-sandbox --disable-gpu-sandbox --use-angle=swiftshader
            --enable-unsafe-swiftshader --disable-dev-shm-usage --user-data-dir=${FOLDER}/profile
            --window-size=900,700 --virtual-time-budget=3000 --dump-dom file://${out}/replay.html
    OUTPUT_VARIABLE page ERROR_VARIABLE errors TIMEOUT 120 RESULT_VARIABLE result)
  string(REGEX MATCH "<html[^>]*>" root "${page}")
  if(root MATCHES "data-error=\"no WebGL\"")
    message("not checked: this Chromium offers no WebGL")
    return()
  endif()
  if(NOT result EQUAL 0 OR NOT root MATCHES "data-drawn=\"yes\"")
    message(FATAL_ERROR "${scene}: the page did not draw (${result}): ${root}\n${errors}")
  endif()
  if(NOT root MATCHES "data-gl-error=\"0\"")
    message(FATAL_ERROR "${scene}: WebGL reports an error: ${root}")
  endif()
  string(REGEX REPLACE ".*data-lit=\"([0-9]+)\".*" "\\1" lit "${root}")
  # At the start the fountain is one particle of about 130 pixels.
  if(NOT lit MATCHES "^[0-9]+$" OR lit LESS 50)
    message(FATAL_ERROR "${scene}: the picture is empty: ${root}")
  endif()
  if(scene STREQUAL "cloth_over_ball" AND NOT root MATCHES "data-touching=\"[1-9]")
    message(FATAL_ERROR "${scene}: no particle is shown in contact: ${root}")
  endif()
  message("${scene}: ${lit} pixels lit")
endforeach()
