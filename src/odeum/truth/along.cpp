// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/along.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

namespace odeum::truth {
namespace {

constexpr Real rise = 10, low_part = 1e-3L;
/// A start that is smaller beside the largest is a rounding, as that of cos(pi/2).
constexpr Real least_start = 1e-12L;

/// A run and how it is made.
struct Look {
  Method method = verner_run;
  Real least_part = 0;  ///< see Effort: small components have no size but their own
  Real tolerance = 0, parts = 0;
  Watched seen{0};
  bool ends = false;               ///< the solution does, there
  std::vector<State> states = {};  ///< at the times that it reached
  double slides_from = std::numeric_limits<double>::infinity();
  std::vector<double> dips_before = {};  ///< those of a coarser run; empty: none was made
  std::size_t reached() const { return states.size(); }
};

/// `at_least`: see Effort.
Look look_by(const Look& how, const System& system, const std::vector<Real>& times, Real tolerance,
             Real parts, const State* at_least = nullptr) {
  // The budget in operations: some tenths of a second.
  const double budget = how.method == verner_run ? 3e7 : 1e8;
  Look look{how.method, how.least_part, tolerance, parts, Watched(system.states)};
  const Effort effort{.tolerance = tolerance,
                      .budget = budget,
                      .parts = parts,
                      .watched = &look.seen,
                      .least_part = how.least_part,
                      .at_least = at_least};
  Run run = run_across(how.method, system, times, effort, false);
  look.states = std::move(run.states);
  look.ends = std::isfinite(run.ends_at);
  look.slides_from = static_cast<double>(run.slides_from);
  return look;
}

/// Uses explicit steps; where these do not come to the end, implicit ones, with small components
/// measured by the largest where rounding forbids more.
Look farthest(const System& system, const std::vector<Real>& times, Real tolerance, Real parts) {
  Look best = look_by({}, system, times, tolerance, parts);
  if (!system.has_jacobian()) return best;
  for (const Real least_part : {0.L, 1e-6L}) {
    if (best.reached() == times.size()) break;
    Look implicit = look_by({radau_run, least_part}, system, times, tolerance, parts);
    if (implicit.reached() > best.reached()) best = std::move(implicit);
  }
  return best;
}

bool is_near(double a, double b) { return a == b || (a < 1.5 * b && b < 1.5 * a); }

/// Few digits are enough for a size, unless the equations amplify errors: then those of the run
/// grow to a size of their own, which falls with the tolerance and with the longest step.
Look settled(const System& system, const std::vector<Real>& times) {
  Real parts = 50;
  Look look = farthest(system, times, 1e-6L, parts);
  for (const Real tolerance : {1e-9L, 1e-12L, 1e-15L, 1e-18L}) {
    if (look.reached() == 0) break;
    parts *= 2;
    Look finer = look_by(look, system, times, tolerance, parts);
    // Coarse steps may pass a pole.
    if (finer.reached() == 0 || (finer.reached() < look.reached() && !finer.ends)) break;
    // Nothing was seen before beyond where the coarser run ended.
    const bool farther = finer.reached() > look.reached();
    const std::size_t mark = std::min(finer.reached(), look.reached()) - 1;
    const Along before = look.seen.at(mark), now = finer.seen.at(mark);
    look = std::move(finer);
    look.dips_before = before.dips;
    if (!farther && std::ranges::equal(before.largest, now.largest, is_near) &&
        std::ranges::equal(before.dips, now.dips, is_near))
      break;
  }
  return look;
}

/// Sets those that rounding makes to zero: they change with a rounding of the initial values.
void leave_out_rounding(const System& system, const std::vector<Real>& times, std::size_t mark,
                        Along& along) {
  constexpr double far_smaller = 1e-10;
  const double most = far_smaller * *std::ranges::max_element(along.largest);
  const auto in_doubt = [&](double size) { return size > 0 && size < most; };
  if (std::ranges::none_of(along.largest, in_doubt)) return;
  System moved = system;
  for (std::size_t i = 0; i < moved.y0.size(); ++i)
    moved.y0[i] *= 1 + static_cast<Real>(static_cast<int>(i % 5) - 2) * 0x1p-50L;
  const Look look = settled(moved, times);
  if (look.reached() <= mark) return;
  const Along other = look.seen.at(mark);
  for (std::size_t i = 0; i < along.largest.size(); ++i) {
    if (in_doubt(along.largest[i]) && !is_near(along.largest[i], other.largest[i]))
      along.largest[i] = along.dips[i] = 0;
  }
}

/// Sets the dips to zero that change with the tolerance to the last: what is left of a component
/// that has decayed is the noise of a run, which rises and falls as it may.
void leave_out_noise(const Look& look, Along& along) {
  for (std::size_t i = 0; i < look.dips_before.size(); ++i)
    if (!is_near(along.dips[i], look.dips_before[i])) along.dips[i] = 0;
}

/// Sets the dips to zero of which nothing is left later: a run that holds each such component at
/// ten times its dip has it where it was, once it has risen.
void leave_out_forgotten(const System& system, const std::vector<Real>& times, const Look& look,
                         std::size_t mark, Along& along) {
  constexpr Real by = 10, risen = 100, trace = 0.1L;
  if (std::ranges::none_of(along.dips, [](double dip) { return dip > 0; })) return;
  State at_least(along.dips.begin(), along.dips.end());
  for (Real& each : at_least) each *= by;
  const Look held = look_by(look, system, times, look.tolerance, look.parts, &at_least);
  for (std::size_t i = 0; i < along.dips.size(); ++i) {
    Real most = -1;
    for (std::size_t k = look.seen.risen_before(i, mark);
         k < std::min(look.reached(), held.reached()); ++k)
      if (const Real y = look.states[k][i]; std::abs(y) >= risen * along.dips[i])
        most = std::max(most, std::abs(held.states[k][i] / y - 1));
    if (most >= 0 && most < trace) along.dips[i] = 0;
  }
}

}  // namespace

void Watched::take(const State& y) {
  for (std::size_t i = 0; i < y.size(); ++i) {
    Seen& seen = all_[i];
    const Real size = std::abs(y[i]), before = std::abs(seen.last);
    if (!seen.begun) {
      seen.first = seen.lowest = y[i];
      seen.low = size;
    }
    seen.changed_sign = seen.changed_sign || y[i] * seen.last < 0 || (y[i] == 0 && before > 0);
    if (seen.low > 0)
      seen.low = std::min(seen.low, size);
    else if (size < before)
      seen.low = size;
    if (seen.low > 0 && size >= rise * seen.low) {
      if (seen.low != seen.risen_from) seen.risen_before = marks_.size();
      seen.risen_from = seen.low;
    }
    seen.largest = std::max(seen.largest, size);
    seen.lowest = std::min(seen.lowest, y[i]);
    seen.last = y[i];
    seen.begun = true;
  }
}

Along Watched::at(std::size_t mark) const {
  Along along;
  // Times after the end of a solution that stays as it is have no mark of their own.
  for (const Seen& seen : mark < marks_.size() ? marks_[mark] : all_) {
    const Real first = std::abs(seen.first), from = seen.risen_from;
    const bool rises = !seen.changed_sign && from > 0 && from < low_part * seen.largest &&
                       !(from == first && first < least_start * seen.largest);
    along.largest.push_back(static_cast<double>(seen.largest));
    along.lowest.push_back(static_cast<double>(seen.lowest));
    along.dips.push_back(rises ? static_cast<double>(from) : 0);
  }
  return along;
}

std::optional<Along> look_along(const System& system, const std::vector<double>& stops) {
  constexpr int parts = 16;
  const std::set<Real> asked(stops.begin(), stops.end());
  std::set<Real> all = asked;
  for (int k = 1; k < parts; ++k)
    all.insert(system.t0 + (Real(stops.back()) - system.t0) * k / parts);
  const std::vector<Real> times(all.begin(), all.end());
  Look look = settled(system, times);
  if (look.reached() == 0 && system.mode_at) {
    // A start at which conditions are in doubt, as of bodies that touch, has sizes nevertheless.
    System without_modes = system;
    without_modes.mode_at = nullptr;
    look = settled(without_modes, times);
  }
  if (look.reached() == 0) return std::nullopt;
  std::size_t mark = look.reached() - 1;
  for (std::size_t k = look.reached(); k-- > 0;)
    if (asked.contains(times[k])) {
      mark = k;
      break;
    }
  Along along = look.seen.at(mark);
  along.slides_from = look.slides_from;
  along.whole = times[mark] == times.back();
  leave_out_noise(look, along);
  leave_out_forgotten(system, times, look, mark, along);
  leave_out_rounding(system, times, mark, along);
  return along;
}

std::string to_text(const Along& along) {
  std::string text = fmt::format("{} {}\n", along.slides_from, along.whole ? 1 : 0);
  for (std::size_t i = 0; i < along.largest.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", along.largest[i], along.lowest[i],
                   along.dips[i]);
  return text;
}

std::optional<Along> along_from(const std::string& text, std::size_t states) {
  std::istringstream in(text);
  Along along;
  if (std::string from; in >> from >> along.whole)
    along.slides_from = std::strtod(from.c_str(), nullptr);
  for (std::string largest, lowest, dip; in >> largest >> lowest >> dip;) {
    along.largest.push_back(std::strtod(largest.c_str(), nullptr));
    along.lowest.push_back(std::strtod(lowest.c_str(), nullptr));
    along.dips.push_back(std::strtod(dip.c_str(), nullptr));
  }
  if (along.largest.size() != states) return std::nullopt;
  return along;
}

}  // namespace odeum::truth
