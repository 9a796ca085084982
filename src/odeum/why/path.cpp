// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/why/path.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/measure/local.hpp"

namespace odeum::why {
namespace {

using cases::Conditions;

std::vector<double> conditions_at(const Conditions& all, double t, const std::vector<double>& y) {
  std::vector<double> values(all.count);
  if (!values.empty()) all.at(t, y.data(), values.data());
  return values;
}

}  // namespace

Path::Path(const Case& c, const std::vector<Moment>& moments) : c_(c), moments_(moments) {
  for (const Moment& at : moments) slopes_.push_back(measure::slope(c, at.t, at.y));
}

std::vector<double> Path::state(double t) const {
  const auto above = std::ranges::upper_bound(moments_, t, {}, &Moment::t);
  if (above == moments_.begin()) return moments_.front().y;
  if (above == moments_.end()) return moments_.back().y;
  const Moment &from = *(above - 1), &to = *above;
  const std::vector<double>&f = slopes_[static_cast<std::size_t>(above - moments_.begin()) - 1],
        &g = slopes_[static_cast<std::size_t>(above - moments_.begin())];
  const double h = to.t - from.t, s = (t - from.t) / h, a = s * s * (3 - 2 * s),
               b = s * (1 - s) * (1 - s), d = s * s * (s - 1);
  std::vector<double> y(from.y.size());
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = from.y[i] + a * (to.y[i] - from.y[i]) + h * (b * f[i] + d * g[i]);
  return y;
}

std::vector<double> Path::slope(double t) const { return measure::slope(c_, t, state(t)); }

std::vector<Change> changes_along(const Path& path, const Conditions& conditions,
                                  const std::vector<double>& times) {
  std::vector<Change> changes;
  if (conditions.count == 0 || times.empty()) return changes;
  const auto sides = [&](double t) { return conditions_at(conditions, t, path.state(t)); };
  const auto differ = [](double a, double b) { return (a > 0) != (b > 0); };
  std::vector<double> before = sides(times.front());
  for (std::size_t k = 1; k < times.size(); ++k) {
    std::vector<double> after = sides(times[k]);
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (!differ(before[i], after[i])) continue;
      double low = times[k - 1], high = times[k];
      constexpr int halvings = 60;
      for (int n = 0; n < halvings; ++n) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        (differ(before[i], sides(middle)[i]) ? high : low) = middle;
      }
      changes.push_back({i, low, high});
    }
    before = std::move(after);
  }
  std::ranges::stable_sort(changes, {}, &Change::before);
  return changes;
}

std::vector<double> times_along(const Path& path, const std::vector<Moment>& moments) {
  constexpr int parts = 8, evenly = 2000;
  std::vector<double> times;
  for (std::size_t k = 0; k + 1 < moments.size(); ++k)
    for (int part = 0; part < parts; ++part)
      times.push_back(moments[k].t + (moments[k + 1].t - moments[k].t) * part / parts);
  for (int k = 0; k <= evenly; ++k)
    times.push_back(path.start() + (path.end() - path.start()) * k / evenly);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

bool holds_the_solution(const Case& c, const Conditions& conditions, double t,
                        const std::vector<double>& y, std::size_t condition,
                        const std::vector<double>& sizes) {
  constexpr double part = 1e-6;  // of the sizes
  const std::size_t n = y.size();
  const auto value = [&](double at, const std::vector<double>& state) {
    return conditions_at(conditions, at, state)[condition];
  };
  const auto unit = [&](std::size_t i) { return i < sizes.size() && sizes[i] > 0 ? sizes[i] : 1; };
  std::vector<double> gradient(n);
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> up = y, down = y;
    up[i] += part * unit(i);
    down[i] -= part * unit(i);
    gradient[i] = (value(t, up) - value(t, down)) / (up[i] - down[i]);
    squares += std::pow(gradient[i] * unit(i), 2);
  }
  if (!(squares > 0) || !std::isfinite(squares)) return false;  // of the time alone
  const double by = part * std::max(1.0, std::abs(t));
  const double of_time = (value(t + by, y) - value(t - by, y)) / (2 * by);
  const double now = value(t, y);
  // How the condition changes on the side where it is positive, and where it is negative.
  const auto rate = [&](double side) {
    std::vector<double> there = y;
    for (std::size_t i = 0; i < n; ++i)
      there[i] +=
          (side * part * std::sqrt(squares) - now) * gradient[i] * unit(i) * unit(i) / squares;
    const std::vector<double> f = slope(c, t, there);
    double sum = of_time;
    for (std::size_t i = 0; i < n; ++i) sum += gradient[i] * f[i];
    return sum;
  };
  return rate(1) < 0 && rate(-1) > 0;
}

}  // namespace odeum::why
