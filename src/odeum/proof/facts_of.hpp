// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/proof/facts.hpp"

#include "odeum/kernel/adams.hpp"
#include "odeum/kernel/backward_differences.hpp"

namespace odeum::proof {
namespace detail {

template <class M, class P>
MakeStepper<P> maker() {
  if constexpr (M::template fits<P> && requires { typename M::template Stepper<P>; })
    return [](const P& problem) -> std::unique_ptr<AnyStepper> {
      return std::make_unique<ErasedStepper<typename M::template Stepper<P>, P>>(problem);
    };
  else
    return {};
}

// The recurrence of a multistep method, read from the type of its stepper.
template <class Stepper>
struct Recurrence {};
template <std::size_t K, Ode P, class OneStep>
struct Recurrence<BackwardDifferences<K, P, OneStep>> {
  static std::vector<std::complex<double>> at(std::complex<double> z) {
    constexpr auto formula = backward_difference_coefficients<K>();
    std::vector<std::complex<double>> c(K);
    for (std::size_t i = 0; i < K; ++i) c[i] = -formula.alpha[i + 1] / (formula.alpha[0] - z);
    return c;
  }
};
template <std::size_t K, bool Correct, Ode P, class OneStep>
struct Recurrence<Adams<K, Correct, P, OneStep>> {
  static std::vector<std::complex<double>> at(std::complex<double> z) {
    constexpr auto bashforth = adams_bashforth_coefficients<K>();
    constexpr auto moulton = adams_moulton_coefficients<(K > 1 ? K - 1 : 1)>();
    std::vector<std::complex<double>> predicted(K), c(K);
    for (std::size_t i = 0; i < K; ++i)
      predicted[i] = (i == 0 ? 1.0 : 0.0) + z * bashforth.beta[i + 1];
    if (!Correct) return predicted;
    for (std::size_t i = 0; i < K; ++i) {
      c[i] = (i == 0 ? 1.0 : 0.0) + z * moulton.beta[0] * predicted[i];
      if (i + 1 < K) c[i] += z * moulton.beta[i + 1];
    }
    return c;
  }
};

}  // namespace detail

/// The facts of method M, compiled for the problems of the proofs.
template <class M>
MethodFacts facts_of() {
  MethodFacts facts;
  facts.info = M::info;
  facts.needs = M::needs;
  if constexpr (requires { M::rounding(); }) facts.rounding = M::rounding();
  if constexpr (requires { dynamic_tableau(M::tableau); })
    facts.tableau = dynamic_tableau(M::tableau);
  if constexpr (requires { M::amplification(0.0, 0.0); }) facts.amplification = M::amplification;
  if constexpr (requires { M::oscillator_map(0.0); }) facts.oscillator_map = M::oscillator_map;
  facts.on_problem = detail::maker<M, FunctionProblem>();
  if constexpr (requires { typename M::template Stepper<FunctionProblem>; }) {
    using Rule = detail::Recurrence<typename M::template Stepper<FunctionProblem>>;
    if constexpr (requires { Rule::at; }) facts.recurrence = Rule::at;
  }
  if constexpr (!M::template fits<FunctionProblem>) {
    facts.on_separable = detail::maker<M, FunctionMechanics<false>>();
    facts.on_second_order = detail::maker<M, FunctionMechanics<true>>();
  }
  return facts;
}

}  // namespace odeum::proof
