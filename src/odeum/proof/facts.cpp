// SPDX-License-Identifier: BSD-3-Clause
// The one translation unit that compiles every own method for the proofs.
#include "odeum/proof/facts.hpp"

#include "odeum_methods.hpp"

namespace odeum::proof {
namespace {

template <class M, class P>
MakeStepper<P> maker() {
  if constexpr (M::template fits<P> && requires { typename M::template Stepper<P>; })
    return [](const P& problem) -> std::unique_ptr<AnyStepper> {
      return std::make_unique<ErasedStepper<typename M::template Stepper<P>, P>>(problem);
    };
  else
    return {};
}

template <class M>
MethodFacts facts_of() {
  MethodFacts facts;
  facts.info = M::info;
  facts.needs = M::needs;
  if constexpr (requires { dynamic_tableau(M::tableau); })
    facts.tableau = dynamic_tableau(M::tableau);
  if constexpr (requires { M::amplification(0.0, 0.0); }) facts.amplification = M::amplification;
  if constexpr (requires { M::oscillator_map(0.0); }) facts.oscillator_map = M::oscillator_map;
  facts.on_problem = maker<M, FunctionProblem>();
  if (!facts.on_problem) {
    if constexpr (!M::template fits<FunctionProblem>) {
      facts.on_separable = maker<M, FunctionMechanics<false>>();
      facts.on_second_order = maker<M, FunctionMechanics<true>>();
    }
  }
  return facts;
}

}  // namespace

MakeStepper<FunctionMechanics<false>> MethodFacts::on_mechanics() const {
  if (on_separable) return on_separable;
  if (!on_problem) return {};
  return [make = on_problem](const FunctionMechanics<false>& problem) { return make(problem); };
}

const std::vector<MethodFacts>& all_method_facts() {
  static const std::vector<MethodFacts> all = [] {
    std::vector<MethodFacts> list;
    methods::All::for_each([&]<class M>() { list.push_back(facts_of<M>()); });
    return list;
  }();
  return all;
}

}  // namespace odeum::proof
