// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/iterative_solvers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "odeum/core/enum_names.hpp"
#include "odeum/linear/conjugate_gradients.hpp"

namespace odeum::linear {
namespace {

constexpr double diverged_at = 1e6;  // the residual against that of the guess

double norm(const std::vector<double>& v) {
  double sum = 0;
  for (const double each : v) sum += each * each;
  return std::sqrt(sum);
}

bool finite(const SparseMatrix& a) {
  return std::all_of(a.value.begin(), a.value.end(), [](double v) { return std::isfinite(v); });
}

/// What an outcome is at a residual: `over_budget` where it may go on.
IterationStatus state_at(double residual, const StopRule& rule) {
  if (!std::isfinite(residual)) return IterationStatus::non_finite;
  if (residual <= rule.relative_residual) return IterationStatus::converged;
  return residual > diverged_at ? IterationStatus::diverged : IterationStatus::over_budget;
}

/// An iteration whose `step(x, r)` changes x for the residual r = b - A x.
template <class Step>
IterativeOutcome iterate(const SparseMatrix& a, const std::vector<double>& b, const StopRule& rule,
                         const Watch& watch, Step&& step) {
  IterativeOutcome outcome;
  outcome.x.assign(b.size(), 0);
  const double size = norm(b);
  if (!std::isfinite(size) || !finite(a)) return outcome;
  outcome.residuals.push_back(size > 0 ? 1 : 0);
  outcome.status = state_at(outcome.residuals[0], rule);
  std::vector<double> r = b;
  while (outcome.status == IterationStatus::over_budget &&
         outcome.iterations < rule.most_iterations) {
    if (!step(outcome.x, r)) {
      outcome.status = IterationStatus::indefinite;
      break;
    }
    a.multiply(outcome.x.data(), r.data());
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = b[i] - r[i];
    ++outcome.iterations;
    outcome.residuals.push_back(norm(r) / size);
    outcome.status = state_at(outcome.residuals.back(), rule);
    if (watch && !watch(outcome.iterations, outcome.x.data()) &&
        outcome.status == IterationStatus::over_budget)
      outcome.status = IterationStatus::stopped;
  }
  return outcome;
}

/// How many eigenvalues lie below x.
std::size_t below(const std::vector<double>& diagonal, const std::vector<double>& off, double x) {
  std::size_t count = 0;
  double q = 1;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    q = diagonal[i] - x - (i > 0 ? off[i - 1] * off[i - 1] / q : 0);
    if (q == 0) q = std::numeric_limits<double>::min();
    count += q < 0;
  }
  return count;
}

}  // namespace

const char* to_string(IterationStatus status) {
  return text_of_enumerator<IterationStatus::non_finite>(
      status, {"ok", "diverged", "over_budget", "stopped", "indefinite", "non_finite"});
}

IterativeOutcome stationary(const SparseMatrix& a, const Preconditioner& m,
                            const std::vector<double>& b, const StopRule& rule,
                            const Watch& watch) {
  std::vector<double> z(b.size());
  return iterate(a, b, rule, watch, [&](std::vector<double>& x, const std::vector<double>& r) {
    m.apply(r.data(), z.data());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += z[i];
    return true;
  });
}

IterativeOutcome gauss_seidel(const SparseMatrix& a, const std::vector<double>& b,
                              const StopRule& rule, const Watch& watch) {
  const std::vector<double> diagonal = a.diagonal();
  if (std::find(diagonal.begin(), diagonal.end(), 0.0) != diagonal.end())
    throw std::invalid_argument("a diagonal entry is 0");
  return iterate(a, b, rule, watch, [&](std::vector<double>& x, const std::vector<double>&) {
    for (int i = 0; i < a.rows; ++i) {
      double sum = b[i];
      for (int k = a.start[i]; k < a.start[i + 1]; ++k) sum -= a.value[k] * x[a.column[k]];
      x[i] += sum / diagonal[i];
    }
    return true;
  });
}

IterativeOutcome steepest_descent(const SparseMatrix& a, const std::vector<double>& b,
                                  const StopRule& rule, const Watch& watch) {
  std::vector<double> ar(b.size());
  return iterate(a, b, rule, watch, [&](std::vector<double>& x, const std::vector<double>& r) {
    a.multiply(r.data(), ar.data());
    double rr = 0, curvature = 0;
    for (std::size_t i = 0; i < r.size(); ++i) rr += r[i] * r[i], curvature += r[i] * ar[i];
    if (curvature <= 0) return false;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += rr / curvature * r[i];
    return true;
  });
}

std::pair<double, double> extreme_eigenvalues(const std::vector<double>& diagonal,
                                              const std::vector<double>& off) {
  // All lie within Gershgorin's discs.
  double low = diagonal[0], high = diagonal[0];
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double radius =
        (i > 0 ? std::abs(off[i - 1]) : 0) + (i < off.size() ? std::abs(off[i]) : 0);
    low = std::min(low, diagonal[i] - radius), high = std::max(high, diagonal[i] + radius);
  }
  const auto bisect = [&](std::size_t at_most_below) {
    double a = low, b = high;
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = a + (b - a) / 2;
      (below(diagonal, off, middle) <= at_most_below ? a : b) = middle;
    }
    return a + (b - a) / 2;
  };
  return {bisect(0), bisect(diagonal.size() - 1)};
}

CgOutcome preconditioned_cg(const SparseMatrix& a, const Preconditioner& m,
                            const std::vector<double>& b, const StopRule& rule, const Watch& watch,
                            std::size_t threads) {
  CgOutcome outcome;
  outcome.x.assign(b.size(), 0);
  const double size = norm(b);
  if (!std::isfinite(size) || !finite(a)) return outcome;
  outcome.residuals.push_back(size > 0 ? 1 : 0);
  // The tridiagonal matrix of Lanczos' process from the coefficients (Saad, section 6.7.3).
  std::vector<double> diagonal, off;
  double alpha_before = 0, rz_before = 0;
  outcome.status = IterationStatus::indefinite;
  Team team(threads);
  ConjugateGradients cg(b.size(), &team);
  const bool done = cg.solve(
      [&](const double* x, double* ax) { a.multiply(x, ax, &team); },
      [&](const double* r, double* z) { m.apply(r, z); }, b.data(), outcome.x.data(),
      rule.relative_residual,
      [&](const ConjugateGradients::Iteration& now) {
        const double beta = diagonal.empty() ? 0 : now.rz / rz_before;
        if (!diagonal.empty()) off.push_back(std::sqrt(beta) / alpha_before);
        diagonal.push_back(1 / now.alpha + (off.empty() ? 0 : beta / alpha_before));
        alpha_before = now.alpha, rz_before = now.rz;
        const double residual = std::sqrt(now.residual_squared) / size;
        outcome.residuals.push_back(residual);
        outcome.iterations = diagonal.size();
        outcome.status = !std::isfinite(residual)                     ? IterationStatus::non_finite
                         : watch && !watch(outcome.iterations, now.x) ? IterationStatus::stopped
                         : outcome.iterations >= std::min(rule.most_iterations, b.size() + 50)
                             ? IterationStatus::over_budget
                             : IterationStatus::indefinite;  // if it ends without another one
        return outcome.status == IterationStatus::indefinite;
      });
  if (!diagonal.empty() && outcome.status != IterationStatus::non_finite)
    std::tie(outcome.lowest, outcome.highest) = extreme_eigenvalues(diagonal, off);
  if (done) outcome.status = IterationStatus::converged;
  return outcome;
}

}  // namespace odeum::linear
