// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/facts.hpp"

namespace odeum::proof {

MakeStepper<FunctionMechanics<false>> MethodFacts::on_mechanics() const {
  if (on_separable) return on_separable;
  if (!on_problem) return {};
  return [make = on_problem](const FunctionMechanics<false>& problem) { return make(problem); };
}

}  // namespace odeum::proof
