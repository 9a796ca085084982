// SPDX-License-Identifier: BSD-3-Clause
// Own methods on R(t, y, y') = 0 as it is stated.
#include <cmath>
#include <concepts>
#include <utility>
#include <vector>

#include "odeum/kernel/backward_differences.hpp"
#include "odeum/kernel/residual_newton.hpp"
#include "odeum/kernel/residual_rosenbrock.hpp"
#include "odeum/kernel/residual_stages.hpp"
#include "odeum/methods/bdf_variable.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/radau_iia9.hpp"
#include "odeum/methods/rodas4.hpp"
#include "odeum/solvers/enroll_method.hpp"

namespace odeum {
namespace {

/// The residuals of a contest under a guard. An evaluation of them counts like one of the rates.
class GuardedResiduals {
 public:
  static constexpr std::size_t dimension = dynamic;

  GuardedResiduals(const ErasedContest& contest, Guard& guard, Mode mode)
      : form_(*contest.implicit), ordinary_(contest.view), guard_(guard), mode_(mode) {}

  std::size_t size() const { return form_.dimension; }
  void rhs(double t, const double* y, double* rates) const {
    evaluate(t, rates, [&] { ordinary_.rhs(ordinary_.problem, t, y, rates); });
  }
  void residual(double t, const double* y, const double* rates, double* r) const {
    evaluate(t, r, [&] { form_.residual(t, y, rates, r); });
  }
  void matrix(double t, const double* y, const double* rates, double alpha, double* j) const {
    if (alpha == 0) guard_.count_jacobian();  // the other is of the same point
    form_.matrix(t, y, rates, alpha, j);
  }
  int index_of(std::size_t n) const { return form_.indices.empty() ? 1 : form_.indices[n]; }
  bool tripped() const { return guard_.tripped(); }
  /// Whether the kernels iterate as far as rounding allows.
  bool to_rounding() const { return mode_ == Mode::fixed; }

 private:
  template <class Call>
  void evaluate(double t, double* values, Call&& call) const {
    guard_.evaluate(
        t, values, [&] { return size(); }, false, std::forward<Call>(call));
  }

  const ImplicitForm& form_;
  const OdeView& ordinary_;
  Guard& guard_;
  Mode mode_;
};

/// Backward differences at a fixed step, whose start is of residuals too.
struct Bdf4 : BackwardDifferenceMethod<4, methods::radau_iia5> {
  static constexpr MethodInfo info = named("bdf4");
};

template <class M>
inline constexpr bool needs_constant_factors = requires {
  M::rosenbrock_tableau;
};

/// Whether dR/dy' is the same at states and rates apart from each other.
bool has_constant_factors(const ErasedContest& contest) {
  const ImplicitForm& form = *contest.implicit;
  const std::size_t n = form.dimension;
  const auto factors = [&](double t, const std::vector<double>& y, const std::vector<double>& v) {
    std::vector<double> with(n * n), without(n * n);
    form.matrix(t, y.data(), v.data(), 1, with.data());
    form.matrix(t, y.data(), v.data(), 0, without.data());
    for (std::size_t i = 0; i < n * n; ++i) with[i] -= without[i];
    return with;
  };
  std::vector<double> y = *contest.y0, rates(n, 0);
  const std::vector<double> first = factors(contest.t0, y, rates);
  for (std::size_t i = 0; i < n; ++i) {
    y[i] += 1e-3 * (1 + std::abs(y[i]));
    rates[i] = 1;
    const std::vector<double> other = factors(contest.t0 + 0.37, y, rates);
    for (std::size_t k = 0; k < n * n; ++k)
      if (!(std::abs(other[k] - first[k]) <= 1e-9 * std::abs(first[k]))) return false;
  }
  return true;
}

/// Radau's methods know how errors of a state grow with its index. Others leave out of their error
/// test the states of an index above 1, as IDA does.
template <class M>
inline constexpr bool tests_by_index = requires {
  requires std::derived_from<M, FullyImplicitMethod<M::tableau>>;
};
Request without_high_indices(const ImplicitForm& form, Request request) {
  constexpr double beyond = 1e12;
  std::vector<double> thresholds(form.dimension);
  for (std::size_t i = 0; i < form.dimension; ++i)
    thresholds[i] = request.tolerance.threshold(i) * (form.indices[i] > 1 ? beyond : 1);
  request.tolerance = Tolerance::of_thresholds(request.tolerance.relative, thresholds);
  return request;
}

template <class M>
Outcome solve_residuals(const ErasedContest& contest, const Request& asked) {
  const bool leaves_out =
      !tests_by_index<M> && contest.implicit->index > 1 && asked.mode == Mode::adaptive;
  const Request request = leaves_out ? without_high_indices(*contest.implicit, asked) : asked;
  if (needs_constant_factors<M> && !has_constant_factors(contest))
    return refused(
        "needs rates with constant factors, M y' = f(t, y): here dR/dy' changes with the state, "
        "the time or the rates");
  constexpr int highest = 2;  // a smaller tolerance gave larger errors on a pendulum of index 3
  if (needs_constant_factors<M> && contest.implicit->index > highest)
    return refused("takes constraints of an index of at most 2, got 3: its steps do not converge");
  Guard guard(contest.implicit->dimension, request.budget, &request.tolerance);
  const GuardedResiduals problem(contest, guard, request.mode);
  Outcome outcome = run_method<M>(problem, contest.t0, *contest.y0, request);
  guard.conclude(request, outcome);
  return outcome;
}

/// The same method as on y' = f(t, y), under an id of its own.
template <class M>
Solver residual_method(const char* id, const char* source) {
  SolverInfo info = info_of_own<M>();
  info.method = id;
  info.source += source;
  return on_residuals(info, solve_residuals<M>);
}

}  // namespace

Solver on_residuals(SolverInfo info, Outcome (*solve)(const ErasedContest&, const Request&)) {
  info.needs = "residuals that are not solved for all rates, R(t, y, y') = 0";
  return {info, [solve](const ErasedContest& contest, Entrant& entrant) {
            if (!contest.implicit)
              entrant.unfit = "needs " + entrant.info.needs;
            else if (contest.implicit->dimension > dense_dimension_limit)
              entrant.unfit = "takes dense matrices here, of 128 unknowns at most";
            else
              entrant.solve = [contest, solve](const Request& request) {
                return solve(contest, request);
              };
          }};
}

void add_residual_methods(std::vector<Solver>& all) {
  const char* const stages = "; on residuals, VI.1";
  all.push_back(residual_method<methods::radau_iia5>("radau_iia5_residual", stages));
  all.push_back(residual_method<methods::radau_iia9>("radau_iia9_residual", stages));
  const char* const differences = "; on residuals: Hairer, Wanner, Solving ODEs II, VI.2";
  all.push_back(residual_method<Bdf4>("bdf4_residual", differences));
  all.push_back(residual_method<methods::bdf_variable>("bdf_variable_residual", differences));
  all.push_back(
      residual_method<methods::rodas4>("rodas4_residual", "; on M y' = f(t, y), (VI.4.18)"));
}

}  // namespace odeum
