// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/harness/outcome.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/tableau/tableau.hpp"

namespace odeum {

/// One step of any explicit Runge-Kutta method on any problem:
///
///     k_i = f(t + c_i h, y + h sum_{j<i} a_ij k_j),   y <- y + h sum_i b_i k_i.
///
/// Stages are unrolled and zero coefficients vanish at compile time; the newest stage is added
/// last, which leaves one multiply-add between an evaluation and the next.
template <const auto& T, Ode P>
class ExplicitRungeKutta {
 public:
  static_assert(T.is_explicit());
  static constexpr std::size_t stages = T.stages;

  explicit ExplicitRungeKutta(const P& problem)
      : problem_(problem), argument_(make_state(problem)) {
    k_.fill(make_state(problem));
  }

  Status step(double t, double h, State<P>& y) {
    evaluate_stages(t, h, y, std::make_index_sequence<stages>{});
    add_weighted<Row::main>(h, y, y, std::make_index_sequence<stages>{});
    return Status::ok;
  }

  /// The same step; `error` becomes h sum_i (b_i - b_hat_i) k_i.
  Status step(double t, double h, State<P>& y, State<P>& error) requires(T.embedded()) {
    evaluate_stages(t, h, y, std::make_index_sequence<stages>{});
    for (auto& e : error) e = 0;
    add_weighted<Row::difference>(h, error, error, std::make_index_sequence<stages>{});
    add_weighted<Row::main>(h, y, y, std::make_index_sequence<stages>{});
    return Status::ok;
  }

 private:
  enum class Row { main, difference };

  template <std::size_t... I>
  void evaluate_stages(double t, double h, const State<P>& y, std::index_sequence<I...>) {
    (evaluate_stage<I>(t, h, y, std::make_index_sequence<I>{}), ...);
  }

  template <std::size_t I, std::size_t... J>
  void evaluate_stage(double t, double h, const State<P>& y, std::index_sequence<J...>) {
    if constexpr (I == 0) {
      problem_.rhs(t, y.data(), k_[0].data());
    } else {
      const std::array<double, I> ha{(h * T.a[I][J])...};
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = y[n];
        ((T.a[I][J] != 0 ? void(sum += ha[J] * k_[J][n]) : void()), ...);
        argument_[n] = sum;
      }
      problem_.rhs(t + T.c(I) * h, argument_.data(), k_[I].data());
    }
  }

  template <Row row>
  static constexpr double weight(std::size_t i) {
    return row == Row::main ? T.b[i] : T.b[i] - T.b_hat[i];
  }

  template <Row row, std::size_t... I>
  void add_weighted(double h, const State<P>& from, State<P>& to, std::index_sequence<I...>) {
    const std::array<double, stages> hb{(h * weight<row>(I))...};
    for (std::size_t n = 0; n < to.size(); ++n) {
      double sum = from[n];
      ((weight<row>(I) != 0 ? void(sum += hb[I] * k_[I][n]) : void()), ...);
      to[n] = sum;
    }
  }

  const P& problem_;
  std::array<State<P>, stages> k_;
  State<P> argument_;
};

/// Base of a method that is an explicit tableau and nothing else.
template <const auto& T>
struct ExplicitRungeKuttaMethod {
  static_assert(T.is_explicit());
  static constexpr const auto& tableau = T;
  template <class P>
  using Stepper = ExplicitRungeKutta<T, P>;
  static double amplification(double re, double im) {
    return std::abs(stability_function(T, {re, im}));
  }
};

}  // namespace odeum
