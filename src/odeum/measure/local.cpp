// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/measure/local.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/cases/spectrum.hpp"
#include "odeum/linear/eigenvalues.hpp"
#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shared.hpp"

namespace odeum::measure {
namespace {

using Vector = std::vector<double>;

SharedOde shared(const Case& c) { return {c.problem.view, c.problem.keep_alive}; }

/// A column of the Jacobian from one side.
Vector column(const Case& c, double t, const Vector& y, std::size_t k, double delta,
              const Vector& f) {
  Vector moved = y;
  moved[k] += delta;
  const double by = moved[k] - y[k];
  Vector value = slope(c, t, moved);
  for (std::size_t i = 0; i < f.size(); ++i) value[i] = (value[i] - f[i]) / by;
  return value;
}

}  // namespace

Vector slope(const Case& c, double t, const Vector& y) {
  Vector f(y.size());
  c.problem.view.rhs(c.problem.view.problem, t, y.data(), f.data());
  return f;
}

Spectrum spectrum_at(const Case& c, double t, const Vector& y, const Vector& sizes,
                     bool trust_jacobian) {
  Spectrum found;
  const std::size_t n = y.size();
  std::vector<Eigenpair> pairs;
  if (n <= dense_dimension_limit) {
    Vector matrix(n * n);
    if (trust_jacobian)
      jacobian_or_differences(shared(c), t, y.data(), matrix.data());
    else
      difference_jacobian(shared(c), t, y.data(), matrix.data());
    if (is_finite(matrix.data(), matrix.size())) pairs = eigenpairs(matrix, n);
  } else {
    for (const std::complex<double>& value : cases::outermost_eigenvalues(c, t, y))
      pairs.push_back({value, {}});
  }
  for (const auto& [value, vector] : pairs) {
    found.all.push_back(value);
    // Rounding may put an imaginary one to the right.
    if (value.real() > 1e-6 * std::abs(value) || !(std::abs(value) > std::abs(found.fastest)))
      continue;
    found.fastest = value;
    found.component.reset();
    double largest = 0;
    for (std::size_t i = 0; i < vector.size(); ++i)
      if (const double part = vector[i] / (sizes[i] > 0 ? sizes[i] : 1); part > largest) {
        largest = part;
        found.component = i;
      }
  }
  return found;
}

std::optional<WrongEntry> wrong_jacobian(const Case& c, double t, const Vector& y) {
  const OdeView& view = c.problem.view;
  const std::size_t n = y.size();
  if (!view.jacobian || n > dense_dimension_limit) return {};
  Vector given(n * n);
  view.jacobian(view.problem, t, y.data(), given.data());
  const Vector f = slope(c, t, y);
  if (!is_finite(f.data(), n)) return {};
  const DifferenceIncrements increment(n, y.data(), f.data());
  std::optional<WrongEntry> worst;
  double most = 0;
  for (std::size_t k = 0; k < n; ++k) {
    // Some hundred times the increment of least error, so that rounding is below a part in 1e4.
    const double delta = 100 * increment(k);
    const Vector above = column(c, t, y, k, delta, f), below = column(c, t, y, k, -delta, f);
    // A jump in between gives other differences over another distance.
    const Vector near = column(c, t, y, k, 0.3 * delta, f),
                 beyond = column(c, t, y, k, -0.3 * delta, f);
    for (std::size_t i = 0; i < n; ++i) {
      const double middle = 0.5 * (above[i] + below[i]), entry = given[i * n + k];
      const double off = std::abs(entry - middle);
      // What the two sides differ by is not linear there, or a kink.
      const double doubt = 10 * std::abs(above[i] - below[i]) +
                           10 * std::abs(middle - 0.5 * (near[i] + beyond[i])) +
                           1e-3 * std::max(std::abs(entry), std::abs(middle)) +
                           100 * epsilon * std::abs(f[i]) / delta;
      if (!(off > doubt) || !(off * delta > most)) continue;
      most = off * delta;
      worst = WrongEntry{i, k, entry, middle};
    }
  }
  return worst;
}

Vector step_error(const Case& c, const std::string& solver, const Moment& at,
                  const Tolerance& tolerance, Mode mode) {
  if (!(at.h > 0)) return {};
  const Recording recording(c, at.t, at.y);
  const Entrant* const entrant = recording.solver(solver);
  if (!entrant || !entrant->solve || !entrant->unfit.empty()) return {};
  Request request;
  request.stops = {at.t + at.h};
  request.budget.evaluations = 1'000'000;
  Request finer = request;
  if (entrant->info.fixed) {
    request.steps = 1;
    finer.steps = 8;
  } else if (mode == Mode::adaptive) {
    request.mode = finer.mode = Mode::adaptive;
    request.tolerance = tolerance;
    finer.tolerance = tolerance.with_relative(std::max(1e-3 * tolerance.relative, 10 * epsilon));
  } else {
    return {};
  }
  const Outcome once = entrant->solve(request), exact = entrant->solve(finer);
  if (once.status != Status::ok || exact.status != Status::ok) return {};
  Vector error(at.y.size());
  // A run that an event ends has no state at its stop.
  if (once.states.size() != error.size() || exact.states.size() != error.size()) return {};
  for (std::size_t i = 0; i < error.size(); ++i)
    error[i] = std::abs(once.states[i] - exact.states[i]) /
               (tolerance.absolute(i) + tolerance.relative * std::abs(at.y[i]));
  return error;
}

}  // namespace odeum::measure
