# SPDX-License-Identifier: BSD-3-Clause
# cmake -DCOMPILER=<C++ compiler> -DROOT=<checkout> -DFOLDER=<folder> -P CheckProofMessage.cmake
# Spoils methods and compiles them: the compiler refuses each, and names the row of weights, the order,
# the rooted tree and the residual of the first condition that fails.
function(expect_message name text pattern)
  file(WRITE ${FOLDER}/spoilt_${name}.cpp "${text}")
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${ROOT}/src ${FOLDER}/spoilt_${name}.cpp
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    message(FATAL_ERROR "${name} compiles, though spoilt")
  endif()
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${name}: no \"${pattern}\" in\n${output}")
  endif()
  message("${name}: ${CMAKE_MATCH_0}")
endfunction()
# A method's file with one text replaced.
function(expect method from to pattern)
  file(READ ${ROOT}/src/odeum/methods/${method}.hpp text)
  string(REPLACE "${from}" "${to}" spoilt "${text}")
  if(spoilt STREQUAL text)
    message(FATAL_ERROR "${method}.hpp holds no \"${from}\"")
  endif()
  string(REPLACE "#pragma once" "" spoilt "${spoilt}")
  expect_message(${method} "${spoilt}" "${pattern}")
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
# A splitting: a kick moves.
expect(mclachlan_atela3 "{0.26833009578175992496, -0.18" "{0.2684, -0.18"
       "OrderConditionFails<odeum::WeightRow::b_v, 1, ${node}, (odeum::Decimal)?{699, -7}>")
# A weight of the second estimate moves, and a coefficient of an interpolant.
expect(dormand_prince853 "0.022058823529411764706" "0.023"
       "OrderConditionFails<odeum::WeightRow::further, 1, ${node}, (odeum::Decimal)?{941, -6}>")
expect(tsitouras54 "0.1017," "0.1018,"
       "OrderConditionFails<odeum::WeightRow::dense, 1, ${node}, (odeum::Decimal)?{141, -7}>")
# Too low an order is claimed.
expect(rk4 ".order = 4" ".order = 3" "HasHigherOrderThanStated<odeum::WeightRow::b, 4>")
# A multistep formula is derived: one of its coefficients moves.
expect_message(adams_moulton "#include \"odeum/tableau/multistep_coefficients.hpp\"
constexpr auto formula = [] {
  auto c = odeum::adams_moulton_coefficients<3>()\;
  c.beta[2] += 0.001\;
  return c\;
}()\;
static_assert(odeum::multistep_proven<formula, 4>())\;
" "NotExactForPolynomial<1, (odeum::Decimal)?{-100, -5}>")
