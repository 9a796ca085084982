// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>

#include "odeum/core/guarded.hpp"
#include "odeum/core/tolerance.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/difference_jacobian.hpp"

namespace odeum {

/// The watch of a plain run: evaluations are counted; there is no budget and no search for values
/// that are not finite.
class EvaluationCount {
 public:
  template <class Real, class Size, class Call>
  int evaluate(double, Real*, Size&&, bool, Call&& call, int count = 1) const {
    evaluations_ += static_cast<std::uint64_t>(count);
    call();
    return 0;
  }
  void count_jacobian() const {}
  void count_products(std::uint64_t) const {}
  static constexpr bool tripped() { return false; }
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  mutable std::uint64_t evaluations_ = 0;
};
inline std::unique_ptr<ShiftedSolver> counted(std::unique_ptr<ShiftedSolver> solver,
                                              const EvaluationCount&) {
  return solver;
}

/// What a method sees of the problem of a plain run, which has to outlive it: the same, counted,
/// and by differences what implicit methods need and the problem lacks, without an allocation. It
/// has room for states of its own: one for each thread.
template <Ode P>
class Plain : public Guarded<P, EvaluationCount> {
  using Base = Guarded<P, EvaluationCount>;

 public:
  using real = RealOf<P>;
  static constexpr bool in_double = std::same_as<real, double>;

  explicit Plain(const P& problem)
      : Base(problem, {}),
        f_(make_state(problem)),
        moved_(make_state(problem)),
        f_moved_(make_state(problem)) {}

  /// Differences weigh the components by the thresholds of that tolerance, which has to outlive
  /// this, where it has one for each.
  void weigh_by(const Tolerance& tolerance) {
    if (tolerance.thresholds.size() == this->size()) weights_ = tolerance.thresholds.data();
  }

  std::uint64_t evaluations() const { return this->watch().evaluations(); }
  /// Without a statement of the problem df/dt is formed by differences, not taken for zero.
  bool autonomous() const {
    if constexpr (requires { Base::autonomous(); }) return Base::autonomous();
    return false;
  }

  /// Dense and row-major; by forward differences where the problem has none.
  void jacobian(double t, const double* y, double* j) const requires in_double {
    if constexpr (WithJacobian<P>) {
      Base::jacobian(t, y, j);
    } else {
      const auto counted_rhs = [this](double time, const double* at, double* value) {
        this->rhs(time, at, value);
        return true;
      };
      difference_jacobian(counted_rhs, this->size(), t, y, j,
                          {f_.data(), moved_.data(), f_moved_.data()}, weights_);
    }
  }
  /// Uses central differences where the problem has no time derivative: a Rosenbrock method would
  /// lose its order on a problem that depends on t and is taken for autonomous.
  void time_derivative(double t, const double* y, double* dfdt) const requires in_double {
    const std::size_t n = this->size();
    if constexpr (NonAutonomous<P>) {
      Base::time_derivative(t, y, dfdt);
    } else if (autonomous()) {
      for (std::size_t i = 0; i < n; ++i) dfdt[i] = 0;
    } else {
      // Balances truncation against rounding for differences of second order.
      const double wanted =
          std::cbrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(t), 1e-3);
      const double later = t + wanted, earlier = t - wanted;
      this->rhs(later, y, f_.data());
      this->rhs(earlier, y, f_moved_.data());
      for (std::size_t i = 0; i < n; ++i) dfdt[i] = (f_[i] - f_moved_[i]) / (later - earlier);
    }
  }

 private:
  mutable State<P> f_, moved_, f_moved_;
  const double* weights_ = nullptr;
};

}  // namespace odeum
