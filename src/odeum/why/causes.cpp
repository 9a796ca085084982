// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

/// The time scale y_i / f_i at some of the last moments, where |y_i| is largest at the end.
struct Growing {
  std::size_t component = 0;
  std::vector<double> t, scale, size;
};
Growing growing(const Case& c, const Run& run) {
  Growing g;
  const Moment& end = run.moments.back();
  for (std::size_t i = 0; i < end.y.size(); ++i)
    if (std::abs(end.y[i]) > std::abs(end.y[g.component])) g.component = i;
  for (const Moment& at : run.moments) {
    const double y = at.y[g.component], f = slope(c, at.t, at.y)[g.component];
    if (!std::isfinite(f) || f == 0 || !std::isfinite(y)) continue;
    g.t.push_back(at.t);
    g.scale.push_back(y / f);
    g.size.push_back(std::abs(y));
  }
  return g;
}

/// A pole (t* - t)^-p has y / f = (t* - t) / p, a straight line in t. Returns t*, and where it was
/// looked at last.
struct Pole {
  double at;
  std::size_t last;
};
std::optional<Pole> pole_of(const Growing& g) {
  std::vector<std::size_t> late;  // over two decades of size, and short of the rounding of t
  for (std::size_t k = 0; k < g.t.size(); ++k)
    if (g.scale[k] > 1e-9 * std::abs(g.t[k]) && g.size[k] > 3 * g.size.front()) late.push_back(k);
  if (late.size() < 4) return {};
  const std::size_t first = late.front(), last = late.back(), half = late[late.size() / 2];
  if (!(g.size[last] > 30 * g.size[first])) return {};
  const double slope = (g.scale[last] - g.scale[half]) / (g.t[last] - g.t[half]);
  if (!(slope < -0.02) || !(g.scale[last] < 0.3 * g.scale[first])) return {};
  const double at = g.t[last] - g.scale[last] / slope;
  // The middle ones lie on the same line.
  const std::size_t between = late[late.size() * 3 / 4];
  const double expected = slope * (g.t[between] - at);
  if (std::abs(g.scale[between] - expected) > 0.3 * expected) return {};
  return Pole{at, last};
}

void look_for_domain(Inquiry& q, const Run& run) {
  const NotFinite& bad = run.trace.first_bad;
  if (std::isnan(bad.t) || bad.y.empty()) return;
  const Case& c = q.c;
  std::vector<double> size(c.y0.size()), least(c.y0.size(), infinity);
  const Moment* last = nullptr;
  for (const Moment& at : run.moments) {
    if (!is_finite(at.y.data(), at.y.size())) continue;
    for (std::size_t i = 0; i < size.size(); ++i) {
      size[i] = std::max(size[i], std::abs(at.y[i]));
      least[i] = std::min(least[i], at.y[i]);
    }
    if (at.t <= bad.t) last = &at;
  }
  if (!last) return;
  const auto finite = [&](double t, const std::vector<double>& y) {
    const std::vector<double> f = slope(c, t, y);
    return is_finite(f.data(), f.size());
  };
  const std::string value = fmt::format("{}'s right-hand side is {} at t = {:.6g}",
                                        q.names[bad.component], bad.value, bad.t);
  const double failed = run.ok() ? nan : std::min(run.ends.back(), bad.t);
  if (!finite(bad.t, last->y)) {
    if (finite(last->t, last->y) && bad.t != last->t)
      q.add(Cause::domain, nan, bad.t, value + ", whatever the state is near there");
    return;
  }
  for (std::size_t i = 0; i < size.size(); ++i) {
    if (!(std::abs(bad.y[i]) <= 100 * size[i] + 1)) continue;
    std::vector<double> y = bad.y;
    y[i] = last->y[i];
    if (!is_finite(y.data(), y.size()) || !finite(bad.t, y)) continue;
    const bool negative = bad.y[i] < 0 && c.y0[i] >= 0;
    q.add(Cause::domain, nan, std::isnan(failed) ? bad.t : failed,
          fmt::format("{} where {} = {:.3g}{}; with {} = {:.3g} it is finite", value, q.names[i],
                      bad.y[i],
                      negative && least[i] >= 0 ? ", below 0, where no step before ended" : "",
                      q.names[i], last->y[i]));
    return;
  }
}

/// The time at which component i is infinite as the logarithm of the time that is left, where one
/// over its slope falls on a straight line in t, over a decade and more.
std::optional<double> grows_as_logarithm(const Case& c, const Run& run, std::size_t i) {
  constexpr double rounding = 1e-9, decades = 1e4, least_range = 10, near = 0.3;
  constexpr std::size_t least = 4;
  std::vector<double> t, inverse;  // from the last one on
  for (std::size_t k = run.moments.size(); k-- > 0;) {
    const Moment& at = run.moments[k];
    const double each = 1 / slope(c, at.t, at.y)[i];
    if (!(std::abs(each) > rounding * std::abs(at.t))) continue;
    if (!inverse.empty() && !(each / inverse.back() > 1 && each / inverse.front() < decades)) break;
    t.push_back(at.t);
    inverse.push_back(each);
  }
  if (t.size() < least || !(inverse.back() > least_range * inverse.front())) return {};
  const double slope_of_line = (inverse.front() - inverse.back()) / (t.front() - t.back()),
               at = t.front() - inverse.front() / slope_of_line;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double expected = slope_of_line * (t[k] - at);
    if (!(std::abs(inverse[k] - expected) < near * std::abs(expected))) return {};
  }
  return at;
}

void look_for_singular_slope(Inquiry& q, const Run& run) {
  const Moment &end = run.moments.back(), &start = run.moments.front();
  const std::vector<double> now = slope(q.c, end.t, end.y), then = slope(q.c, start.t, start.y);
  for (std::size_t i = 0; i < now.size(); ++i) {
    double size = 0, usual = std::abs(then[i]);
    for (const Moment& at : run.moments) {
      size = std::max(size, std::abs(at.y[i]));
      if (at.t < start.t + 0.9 * (end.t - start.t))
        usual = std::max(usual, std::abs(slope(q.c, at.t, at.y)[i]));
    }
    const double left = q.run.request.stops.back() - end.t;
    // It would leave its size many times in what is left.
    if (std::isfinite(now[i]) && std::abs(now[i]) > 1e3 * usual &&
        std::abs(now[i]) * left > 100 * size) {
      if (const auto at = grows_as_logarithm(q.c, run, i)) {
        q.add(Cause::pole, nan, *at,
              fmt::format("{} grows beyond all bounds at t = {:.6g}, as a logarithm: it is {:.3g} "
                          "at t = {:.8g}, and one over its slope falls in proportion to the time "
                          "that is left",
                          q.names[i], *at, end.y[i], end.t));
        return;
      }
      q.add(Cause::singular, nan, end.t,
            fmt::format("the slope of {} grows beyond all bounds at t = {:.8g}, where it is {:.2g} "
                        "and {} = {:.3g}: the solution ends there",
                        q.names[i], end.t, now[i], q.names[i], end.y[i]));
      return;
    }
  }
}

}  // namespace

void look_at_jacobian(Inquiry& q) {
  const std::size_t count = q.run.moments.size();
  std::optional<WrongEntry> wrong;
  std::size_t k = 0;
  for (; k < count && !wrong; k += 1 + count / 8)
    wrong = wrong_jacobian(q.c, q.run.moments[k].t, q.run.moments[k].y);
  if (!wrong) return;
  q.trust_jacobian = false;
  if (q.run.outcome.counters.jacobian_evaluations == 0) return;  // this run does not ask for it
  Case without = q.c;
  OdeView& view = without.problem.view;
  view.jacobian = nullptr;
  view.jacobian_entries = nullptr;
  view.jacobian_times = nullptr;
  view.shifted_solver = nullptr;
  const Outcome other = q.make(without, q.why.solver, q.run.request, 0, 0.3).outcome;
  std::string text = fmt::format(
      "the Jacobian given is wrong: the derivative of {}' by {} is {:.6g}, where differences of "
      "the right-hand side give {:.6g}",
      q.names[wrong->row], q.names[wrong->column], wrong->given, wrong->differenced);
  double share = nan;
  if (other.status == Status::ok) {
    const auto before = static_cast<double>(q.run.outcome.counters.rhs_evaluations),
               after = static_cast<double>(other.counters.rhs_evaluations);
    if (q.run.ok()) share = std::max(0.0, 1 - after / before);
    text += fmt::format("; with differences the run takes {} steps", other.counters.steps);
  }
  q.add(Cause::wrong_jacobian, share, q.c.t0, text);
}

void look_at_start(Inquiry& q) {
  if (q.run.outcome.status != Status::step_too_small || q.run.ends.back() != q.c.t0) return;
  const std::vector<double> f = slope(q.c, q.c.t0, q.c.y0);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double time = std::abs(q.c.y0[i] / f[i]);
    if (!(time > 0 && time < 4 * epsilon * std::abs(q.c.t0))) continue;
    q.add(Cause::rounding, nan, q.c.t0,
          fmt::format("{} changes by its size within {:.2g} from the start on, and times near {:g} "
                      "are {:.2g} apart: no step is that short, but with a time that starts at 0",
                      q.names[i], time, q.c.t0, epsilon * std::abs(q.c.t0)));
    return;
  }
}

void look_at_tolerances(Inquiry& q) {
  const Tolerance& tolerance = q.run.request.tolerance;
  const Outcome& outcome = q.run.outcome;
  double tightest = infinity;
  std::size_t who = 0;
  for (std::size_t i = 0; i < q.sizes.size(); ++i) {
    if (!(q.sizes[i] > 0) || !std::isfinite(q.sizes[i])) continue;
    const double in_roundings =
        (tolerance.absolute(i) + tolerance.relative * q.sizes[i]) / (epsilon * q.sizes[i]);
    if (in_roundings < tightest) tightest = in_roundings, who = i;
  }
  constexpr double few = 20;
  const bool struggles =
      !q.run.ok() || outcome.counters.rejected_steps * 10 > outcome.counters.steps;
  // Or the same digits under a looser tolerance, but for the rounding of the steps.
  const auto no_better = [&] {
    if (!q.run.ok()) return false;
    Request looser = q.run.request;
    looser.tolerance = tolerance.with_relative(tolerance.relative * 3 * few / tightest);
    const Run other = q.make(q.c, q.why.solver, looser, 0, 0.2);
    const double rounding =
        few * epsilon * q.sizes[who] * std::sqrt(static_cast<double>(outcome.counters.steps));
    return other.ok() && std::abs(other.outcome.states[who] - outcome.states[who]) <= rounding;
  };
  if (tightest < few && (struggles || no_better()))
    q.add(Cause::rounding, nan, nan,
          fmt::format("the tolerance asks for {:.2g} roundings of {}, and each operation makes one",
                      tightest, q.names[who]));
}

namespace {

/// Runs to tighter tolerances, until one ends near the solution.
void try_tighter_tolerances(Inquiry& q) {
  Request tighter = q.run.request;
  tighter.record_steps = false;
  constexpr double tightest = 1e-13;
  constexpr int most = 3;
  for (int k = 0; k < most && q.left() > 0.2 * q.seconds; ++k) {
    const double relative = of_two_digits(0.01 * tighter.tolerance.relative);
    if (relative < tightest) break;
    tighter.tolerance = tighter.tolerance.with_relative(relative);
    if (q.difference(q.others[q.also(q.why.solver, tighter, 0.2)]) <= far_off) return;
  }
}

}  // namespace

void look_for_leaving(Inquiry& q) {
  try_tighter_tolerances(q);
  // The solution at the run's own states.
  Request request = q.trusted->request;
  request.stops.clear();
  std::vector<const Moment*> moments;
  for (const Moment& at : q.run.moments)
    if (at.t > (moments.empty() ? q.c.t0 : moments.back()->t)) {
      moments.push_back(&at);
      request.stops.push_back(at.t);
    }
  if (moments.empty()) return;  // it has not left its start
  const Outcome known = q.make(q.c, q.trusted->solver, request, 0, 0.2).outcome;
  constexpr double left = 0.1;  // of the size of a component
  const std::size_t n = q.c.y0.size();
  for (std::size_t k = 0; known.status == Status::ok && k < moments.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const double here = moments[k]->y[i], there = known.states[k * n + i];
      if (!(q.sizes[i] > 0) || std::abs(here - there) <= left * q.sizes[i]) continue;
      q.add(Cause::astray, nan, moments[k]->t,
            fmt::format(
                "the run leaves the solution: at t = {:.6g} its {} is {:.3g}, where {} has {:.3g}",
                moments[k]->t, q.names[i], here, q.trusted->solver, there));
      return;
    }
  if (!q.run.ok()) look_for_domain(q, q.run);
}

void look_at_end(Inquiry& q, const Run& run) {
  if (run.moments.size() < 4) {
    look_for_domain(q, run);
    return;
  }
  const Growing g = growing(q.c, run);
  if (const auto pole = pole_of(g)) {
    q.add(Cause::pole, nan, pole->at,
          fmt::format("{} grows beyond all bounds at t = {:.6g}: it is {:.3g} at t = {:.8g}, and "
                      "the time in which it doubles falls in proportion to what is left",
                      q.names[g.component], pole->at, g.size[pole->last], g.t[pole->last]));
    return;
  }
  // Far beyond what it began with, and ever at the same rate.
  if (g.t.size() > 4 && g.size.back() > 1e100) {
    q.add(Cause::growth, nan, g.t.back(),
          fmt::format("{} itself grows without end, by a factor of e in {:.3g}, and is {:.2g} at t "
                      "= {:.4g}",
                      q.names[g.component], g.scale.back(), g.size.back(), g.t.back()));
    return;
  }
  look_for_domain(q, run);
  if (!q.found(Cause::domain)) look_for_singular_slope(q, run);
}

}  // namespace odeum::why
