# SPDX-License-Identifier: BSD-3-Clause
# cmake -DCOMPILER=<C++ compiler> -DROOT=<checkout> -DFOLDER=<folder> -P CheckProofMessage.cmake
# Spoils methods and compiles them: the compiler refuses each, and names the row of weights, the order,
# the rooted tree and the residual of the first condition that fails.
function(expect method from to pattern)
  file(READ ${ROOT}/src/odeum/methods/${method}.hpp text)
  string(REPLACE "${from}" "${to}" spoilt "${text}")
  if(spoilt STREQUAL text)
    message(FATAL_ERROR "${method}.hpp holds no \"${from}\"")
  endif()
  string(REPLACE "#pragma once" "" spoilt "${spoilt}")
  file(WRITE ${FOLDER}/spoilt_${method}.cpp "${spoilt}")
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${ROOT}/src ${FOLDER}/spoilt_${method}.cpp
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    message(FATAL_ERROR "${method} with ${to} for ${from} compiles")
  endif()
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${method} with ${to} for ${from}: no \"${pattern}\" in\n${output}")
  endif()
  message("${method}: ${CMAKE_MATCH_0}")
endfunction()
set(node "odeum::tree<>")
set(chain2 "odeum::tree<${node} ?>")
# The second stage of RK4 moves: sum b_i c_i is off by 0.001 / 3.
expect(rk4 "{0, 1. / 2, 0, 0}" "{0, 0.501, 0, 0}"
       "OrderConditionFails<odeum::WeightRow::b, 2, ${chain2}, (odeum::Decimal)?{333, -6}>")
# A weight of the embedded row moves: its sum is off by 1e-4.
expect(bogacki_shampine32 "1. / 8" "0.1251"
       "OrderConditionFails<odeum::WeightRow::b_hat, 1, ${node}, (odeum::Decimal)?{100, -6}>")
# A Rosenbrock method: its Gamma moves.
expect(ros2 "-2 * ros2_gamma" "-2.001 * ros2_gamma"
       "OrderConditionFails<odeum::WeightRow::b, 2, ${chain2}, (odeum::Decimal)?{-146, -6}>")
# A Nystroem method: a weight of the velocity moves.
expect(dormand_nystroem64 "25. / 522" "0.048"
       "OrderConditionFails<odeum::WeightRow::b_v, 1, ${node}, (odeum::Decimal)?{107, -6}>")
# Too low an order is claimed.
expect(rk4 ".order = 4" ".order = 3" "HasHigherOrderThanStated<odeum::WeightRow::b, 4>")
