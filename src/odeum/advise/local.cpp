// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/local.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/cases/spectrum.hpp"
#include "odeum/linear/eigenvalues.hpp"
#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shared.hpp"

namespace odeum::advise {
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

/// How f between the states differs from a straight line, at `parts` + 1 points of [from, to] of
/// the path between them.
class Path {
 public:
  Path(const Case& c, const Moment& from, const Moment& to)
      : c_(c),
        from_(from),
        to_(to),
        f_from_(slope(c, from.t, from.y)),
        f_to_(slope(c, to.t, to.y)) {}
  double time(double s) const { return from_.t + s * (to_.t - from_.t); }
  /// f at the cubic of Hermite, a smooth path near the solution.
  Vector operator()(double s) const {
    const double h = to_.t - from_.t, a = s * s * (3 - 2 * s), b = s * (1 - s) * (1 - s),
                 d = s * s * (s - 1);
    Vector y(from_.y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = from_.y[i] + a * (to_.y[i] - from_.y[i]) + h * (b * f_from_[i] + d * f_to_[i]);
    return slope(c_, time(s), y);
  }

 private:
  const Case& c_;
  const Moment &from_, &to_;
  Vector f_from_, f_to_;
};

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
    for (const std::complex<double>& value : report::outermost_eigenvalues(c, t, y))
      pairs.push_back({value, {}});
  }
  for (const auto& [value, vector] : pairs) {
    found.all.push_back(value);
    found.growth = std::max(found.growth, value.real());
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
    for (std::size_t i = 0; i < n; ++i) {
      const double middle = 0.5 * (above[i] + below[i]), entry = given[i * n + k];
      const double off = std::abs(entry - middle);
      // What the two sides differ by is not linear there, or a kink.
      const double doubt = 10 * std::abs(above[i] - below[i]) +
                           1e-3 * std::max(std::abs(entry), std::abs(middle)) +
                           100 * epsilon * std::abs(f[i]) / delta;
      if (!(off > doubt) || !(off * delta > most)) continue;
      most = off * delta;
      worst = WrongEntry{i, k, entry, middle};
    }
  }
  return worst;
}

namespace {

/// Of the second differences of one component: the largest, and by how much it stands out of those
/// that are not beside it.
struct Bend {
  double size = 0, stands_out = 0;
  std::size_t at = 1;
};
Bend bend_of(const std::vector<Vector>& values, std::size_t i) {
  Bend bend;
  const auto second = [&](std::size_t k) {
    return std::abs(values[k + 1][i] - 2 * values[k][i] + values[k - 1][i]);
  };
  for (std::size_t k = 1; k + 1 < values.size(); ++k)
    if (second(k) > bend.size) bend.size = second(k), bend.at = k;
  double other = 0;
  for (std::size_t k = 1; k + 1 < values.size(); ++k)
    if (k + 1 < bend.at || k > bend.at + 1) other = std::max(other, second(k));
  bend.stands_out = bend.size > 0 ? bend.size / std::max(other, 1e-300) : 0;
  return bend;
}

double size_of(const std::vector<Vector>& values, std::size_t i) {
  double size = 0;
  for (const Vector& value : values) size = std::max(size, std::abs(value[i]));
  return size;
}

}  // namespace

std::optional<Kink> kink_between(const Case& c, const Moment& from, const Moment& to) {
  constexpr std::size_t parts = 8;
  constexpr int most_zooms = 9, needed = 4;
  constexpr double clear = 5;
  const Path f(c, from, to);
  double low = 0, high = 1;
  std::optional<std::size_t> component;
  std::vector<Bend> bends;
  for (int zoom = 0; zoom < most_zooms; ++zoom) {
    std::vector<Vector> at;
    for (std::size_t k = 0; k <= parts; ++k)
      at.push_back(f(low + (high - low) * static_cast<double>(k) / parts));
    for (const Vector& value : at)
      if (!is_finite(value.data(), value.size())) return {};
    if (!component) {
      double most = 0;
      for (std::size_t i = 0; i < from.y.size(); ++i)
        if (const double relative = bend_of(at, i).size / std::max(size_of(at, i), 1e-300);
            relative > most)
          most = relative, component = i;
      if (!component) return {};
    }
    const Bend bend = bend_of(at, *component);
    // The rounding of f, whose terms may be larger than it.
    if (bend.size < 1e6 * epsilon * size_of(at, *component)) break;
    bends.push_back(bend);
    const double part = (high - low) / parts;
    low += part * static_cast<double>(bend.at - 1);
    high = low + 2 * part;
  }
  if (bends.size() < needed) return {};
  for (std::size_t k = bends.size() - 2; k < bends.size(); ++k)
    if (bends[k].stands_out < clear) return {};
  // The bend falls with the square of the width where f is smooth, with the width at a kink, and
  // not at all at a jump; the width falls by four.
  const double power = std::log(bends[bends.size() - 4].size / bends.back().size) / std::log(64.0);
  // A pole of f bends ever more.
  if (power > 1.35 || power < -0.2) return {};
  return Kink{f.time(0.5 * (low + high)), *component, power < 0.35, bends.back().size,
              f.time(high) - f.time(low)};
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
  for (std::size_t i = 0; i < error.size(); ++i)
    error[i] = std::abs(once.states[i] - exact.states[i]) /
               (tolerance.absolute(i) + tolerance.relative * std::abs(at.y[i]));
  return error;
}

}  // namespace odeum::advise
