// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "odeum/core/outcome.hpp"
#include "odeum/core/request.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/linear/matrix_exponential.hpp"

namespace odeum::methods {

/// The exact propagator of y' = A y + b with constant A and b: with
///
///     B = [A b; 0 0],   (y, 1) <- e^(h B) (y, 1),
///
/// exact up to rounding, so that no order is claimed. Adaptive runs step from stop to stop, or,
/// where stops are not to limit the steps, to each stop from the start.
struct exponential_propagator {
  static constexpr MethodInfo info{
      .id = "exponential_propagator",
      .family = "exponential",
      .order = 0,
      .controller = "none: exact at every step",
      .source =
          "Moler, Van Loan, SIAM Rev. 45 (2003) 3-49; Higham, SIAM J. Matrix Anal. Appl. 26 "
          "(2005) 1179-1193, algorithm 2.3"};
  static constexpr auto inlined = Inlined::nonstiff;
  static constexpr std::string_view needs = "a linear problem y' = A y + b with constant A and b";
  template <class P>
  static constexpr bool fits = LinearConstant<P>;
  template <class P>
  static bool fits_problem(const P& problem) {
    return offers_linear_matrix(problem);
  }

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : problem_(problem), product_(make_state(problem)) {}

    /// non_finite, without a state, where e^(h B) overflows.
    Status step(double /*t*/, double h, State<P>& y) {
      const std::size_t n = y.size();
      if (!(h == h_)) make_propagator(n, h);
      if (propagator_.empty()) return Status::non_finite;
      for (std::size_t i = 0; i < n; ++i) {
        const double* const row = propagator_.data() + i * (n + 1);
        double sum = row[n];
        for (std::size_t j = 0; j < n; ++j) sum += row[j] * y[j];
        product_[i] = sum;
      }
      y = product_;
      return Status::ok;
    }

   private:
    void make_propagator(std::size_t n, double h) {
      std::vector<double> a(n * n), matrix((n + 1) * (n + 1));
      problem_.linear_matrix(a.data());
      const State<P> zero = make_state(problem_);
      State<P> b = zero;
      problem_.rhs(0, zero.data(), b.data());
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) matrix[i * (n + 1) + j] = h * a[i * n + j];
        matrix[i * (n + 1) + n] = h * b[i];
      }
      propagator_ = linear::matrix_exponential(matrix, n + 1);
      h_ = h;
    }

    const P& problem_;
    double h_ = std::nan("");
    std::vector<double> propagator_;
    State<P> product_;
  };

  template <class P>
  static Outcome integrate(const P& problem, double t0, const State<P>& y0,
                           const Request& request) {
    Outcome outcome;
    Stepper<P> stepper(problem);
    State<P> y = y0;
    double t = t0;
    for (const double stop : request.stops) {
      outcome.t = t;
      if (request.over_stops) {
        t = t0;
        y = y0;
      }
      outcome.status = stepper.step(t, stop - t, y);
      if (outcome.status != Status::ok) {
        outcome.detail = "the propagator overflows at t = " + std::to_string(t);
        return outcome;
      }
      t = stop;
      outcome.counters.steps = request.over_stops ? 1 : outcome.counters.steps + 1;
      outcome.record(stop, y.data(), y.size());
    }
    return outcome;
  }

  static double amplification(double re, double /*im*/) { return std::exp(re); }
};

}  // namespace odeum::methods
