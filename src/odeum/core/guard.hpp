// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <chrono>
#include <cstdint>
#include <string>

#include "odeum/core/outcome.hpp"

namespace odeum {

/// Checks every evaluation of a right-hand side: counts it, keeps the budget, and records the first
/// non-finite value with its time and component. Such a value does not end a run, since a solver
/// may reject the step that it came from; it explains a run that fails. One guard per solve.
class Guard {
 public:
  /// `tolerance`, which has to outlive this, weighs the components where their derivatives are
  /// formed by differences.
  Guard(std::size_t dimension, const Budget& budget, const Tolerance* tolerance = nullptr)
      : dimension_(dimension),
        rarely_(dimension > large ? 0xf : 0x3ff),
        budget_(budget),
        start_(Clock::now()) {
    if (tolerance && tolerance->thresholds.size() == dimension)
      weights_ = tolerance->thresholds.data();
  }

  /// To be called before an evaluation. False: the budget is spent, stop.
  bool admit() {
    if (tripped()) return false;
    const bool look = spent() >= budget_.evaluations || (rhs_evaluations_ & rarely_) == rarely_;
    if (look && !may_go_on()) return false;
    ++rhs_evaluations_;
    return true;
  }

  /// To be called after an evaluation with its values, of n components from index `first` on (an
  /// acceleration is the second half). False: one is not finite.
  bool inspect(double t, const double* values, std::size_t n, std::size_t first = 0) {
    if (is_finite(values, n)) return true;
    if (first_non_finite_.empty()) describe(t, values, n, first);
    return false;
  }

  /// An evaluation by `call`, which fills size() `values`, with what is to be done before and after
  /// it; one that is not admitted gives zeros. It counts as `count` evaluations. `second_half`: the
  /// values are the second half of the right-hand side. Returns 0, or 1 where the budget is spent.
  /// It is inlined by force, and a timed run does not ask for the size: otherwise the steps of
  /// small problems take up to 14 % longer.
  template <class Size, class Call>
  [[gnu::always_inline]] int evaluate(double t, double* values, Size&& size, bool second_half,
                                      Call&& call, int count = 1) {
    if (!budget_.watched) {
      call();
      return 0;
    }
    bool admitted = admit();
    for (int k = 1; k < count; ++k) admitted = admitted && admit();
    if (admitted) {
      call();
      const std::size_t n = size();
      inspect(t, values, n, second_half ? n : 0);
      return 0;
    }
    for (std::size_t i = 0; i < size(); ++i) values[i] = 0;
    return 1;
  }

  void count_jacobian() { ++jacobian_evaluations_; }
  /// A product of the Jacobian with a vector counts like an evaluation.
  void count_products(std::uint64_t count) { products_ += count; }

  /// The weights of the components, one each, see DifferenceIncrements; null: all alike.
  const double* weights() const { return weights_; }

  bool tripped() const { return !exhausted_.empty(); }  ///< the budget is spent
  const std::string& first_non_finite() const { return first_non_finite_; }  ///< empty: none
  std::uint64_t rhs_evaluations() const { return rhs_evaluations_; }
  std::uint64_t jacobian_evaluations() const { return jacobian_evaluations_; }

  /// The verdict on a solve. A spent budget overrides the library's status; a success is accepted
  /// only if every stop was recorded, the end was reached and the states are finite.
  void conclude(const Request& request, Outcome& outcome) const;

 private:
  /// Reading the clock costs more than a small right-hand side. Of more unknowns than these a step
  /// may solve systems for tens of milliseconds between a few evaluations.
  static constexpr std::size_t large = 128;
  std::uint64_t spent() const { return rhs_evaluations_ + products_; }
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool may_go_on();
  bool exhaust(std::string why);
  void describe(double t, const double* values, std::size_t n, std::size_t first);
  void judge(const Request& request, Outcome& outcome) const;

  std::size_t dimension_;
  std::uint64_t rarely_;  ///< evaluations between readings of the clock, less one
  Budget budget_;
  const double* weights_ = nullptr;
  Clock::time_point start_;
  std::uint64_t rhs_evaluations_ = 0;
  std::uint64_t jacobian_evaluations_ = 0;
  std::uint64_t products_ = 0;
  std::string exhausted_, first_non_finite_;
};

}  // namespace odeum
