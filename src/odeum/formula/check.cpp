// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/formula/exact.hpp"
#include "odeum/formula/reader.hpp"

namespace odeum::formula {
namespace {

using Real = long double;

/// sum_j g_j f_j along the equations, and the sum of the sizes of its terms, for the gradient g of
/// an invariant.
struct Change {
  Real rate = 0, size = 0;
};

Change change_of(Problem& problem, Id value, Real t, const Real* y) {
  const auto n = static_cast<std::uint32_t>(problem.states.size());
  const std::vector<Entry> gradient = gradients(problem.graph, {value}, n).front();
  std::vector<Id> roots = problem.equations;
  for (const Entry& entry : gradient) roots.push_back(entry.value);
  const Evaluator<Real> evaluate(problem.graph, roots);
  std::vector<Real> values(roots.size());
  evaluate(t, y, values.data());
  Change change;
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    const Real term = values[n + k] * values[gradient[k].by];
    change.rate += term;
    change.size += std::abs(term);
  }
  return change;
}

}  // namespace

void require_invariants(Problem& problem, long double t, const long double* y) {
  for (const Invariant& invariant : problem.invariants) {
    if (invariant.is_found)
      continue;  // a rate that is a difference of large ones would be rounding
    const Change change = change_of(problem, invariant.value, t, y);
    if (std::abs(change.rate) <= agreement * change.size) continue;
    throw InputError(
        problem.file, invariant.place,
        fmt::format("invariants: {}: changes along the equations at t = {:.6Lg}; got the "
                    "rate {:.3Lg}, expected 0",
                    invariant.name, t, change.rate));
  }
}

namespace reading {

void Reader::require_start() {
  const Evaluator<Real> evaluate(problem_.graph, problem_.equations);
  std::vector<Real> f(problem_.states.size());
  evaluate(problem_.t0, problem_.y0.data(), f.data());
  for (std::size_t k = 0; k < f.size(); ++k)
    if (!std::isfinite(static_cast<double>(f[k])))
      fail(problem_.places[k],
           "equations: {}: not finite at the start, t = {}; got {}, expected a finite number (a "
           "division by zero, or the root or logarithm of a negative number)",
           problem_.states[k], static_cast<double>(problem_.t0), static_cast<double>(f[k]));
  require_invariants(problem_, problem_.t0, problem_.y0.data());
}

void Reader::require_exact() {
  Problem& problem = problem_;
  if (problem.exact.empty()) return;
  Exact exact(problem);
  constexpr int points = 64;
  const Real end = problem.stops.back();
  for (int point = 0; point <= points; ++point) {
    const Real t = problem.t0 + (end - problem.t0) * point / points;
    const std::optional<Exact::Flaw> flaw = exact.flaw_at(t, problem.t0, end);
    if (!flaw) continue;
    fail(problem.exact_places[flaw->state], "exact: {}: {}; got {:.12Lg}, expected {:.12Lg}",
         problem.states[flaw->state],
         flaw->initial
             ? "is not the initial value"
             : fmt::format("does not fulfil its equation at t = {:.6Lg}: the derivative", t),
         flaw->got, flaw->expected);
  }
}

}  // namespace reading
}  // namespace odeum::formula
