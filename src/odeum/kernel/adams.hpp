// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/multistep.hpp"
#include "odeum/tableau/multistep_coefficients.hpp"

namespace odeum {

/// Adams-Bashforth of order K at a fixed step: y_{n+1} = y_n + h sum_i beta_i f_{n-i}. With
/// `Correct` its result is a prediction, evaluated and corrected by Adams-Moulton of the same order
/// (PECE; the last evaluation is the next step's first).
template <std::size_t K, bool Correct, Ode P, class OneStep>
class Adams {
 public:
  explicit Adams(const P& problem)
      : problem_(problem),
        starting_(problem),
        slopes_(make_state(problem)),
        predicted_(make_state(problem)),
        f_predicted_(predicted_) {}

  void start(double, double, const State<P>&) { slopes_.clear(); }

  Status step(double t, double h, State<P>& y) {
    problem_.rhs(t, y.data(), slopes_.push().data());
    if (!slopes_.full()) return starting_.advance(t, h, y);
    const auto f = slopes_.places();
    each_component(y, [&](std::size_t n) {
      double sum = 0;
      for (std::size_t i = 0; i < K; ++i) sum += bashforth.beta[i + 1] * f[i][n];
      predicted_[n] = y[n] + h * sum;
    });
    if constexpr (!Correct) {
      y = predicted_;
    } else {
      problem_.rhs(t + h, predicted_.data(), f_predicted_.data());
      each_component(y, [&](std::size_t n) {
        double sum = moulton.beta[0] * f_predicted_[n];
        for (std::size_t i = 0; i + 1 < K; ++i) sum += moulton.beta[i + 1] * f[i][n];
        y[n] += h * sum;
      });
    }
    return Status::ok;
  }

 private:
  static constexpr auto bashforth = adams_bashforth_coefficients<K>();
  static constexpr auto moulton = adams_moulton_coefficients<(K > 1 ? K - 1 : 1)>();
  static_assert(multistep_proven<bashforth, K>());
  static_assert(!Correct || multistep_proven<moulton, (K > 1 ? K : 2)>());

  const P& problem_;
  StartingProcedure<OneStep, P> starting_;
  History<K, State<P>> slopes_;
  State<P> predicted_, f_predicted_;
};

/// Base of an Adams method that is started by the one-step method `Start`.
template <std::size_t K, bool Correct, class Start>
struct AdamsMethod : ForAnyProblem {
  template <class P>
  using Stepper = Adams<K, Correct, P, typename Start::template Stepper<P>>;
  static constexpr MethodInfo named(std::string_view id) {
    return {.id = id,
            .family = "multistep",
            .order = K,
            .one_step = K == 1,
            .source = Correct ? "Moulton 1926; Hairer, Norsett, Wanner, Solving ODEs I, (III.1.5), "
                                "(III.1.9), III.1 (PECE)"
                              : "Bashforth, Adams 1883; Hairer, Norsett, Wanner, Solving ODEs I, "
                                "(III.1.5)"};
  }
};

}  // namespace odeum
