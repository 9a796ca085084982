// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/remarks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace odeum::judge {
namespace {

constexpr std::size_t most_unknowns = 64, most_named = 5;
constexpr int samples = 200;  // of a closed form

/// Slopes at random states in units of the scale, one a row, its largest 1; fewer rows where slopes
/// are zero or not finite.
Eigen::MatrixXd sampled_slopes(const Case& c) {
  const std::size_t n = c.y0.size();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> near(0.5, 2);
  Eigen::MatrixXd rows(3 * n + 8, n);
  Eigen::Index found = 0;
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    std::vector<double> y(n), f(n);
    for (std::size_t i = 0; i < n; ++i)
      // A start that rounding alone sets apart from zero has no size.
      y[i] = near(random) *
             (std::abs(c.y0[i]) > 1e-9 * c.scale_of(i) ? std::abs(c.y0[i]) : c.scale_of(i));
    c.problem.view.rhs(c.problem.view.problem, c.t0 + near(random) - 1, y.data(), f.data());
    for (std::size_t i = 0; i < n; ++i) f[i] /= c.scale_of(i);
    const Eigen::Map<const Eigen::RowVectorXd> slopes(f.data(), static_cast<Eigen::Index>(n));
    const double largest = slopes.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    if (largest > 0 && std::isfinite(largest)) rows.row(found++) = slopes / largest;
  }
  return rows.topRows(found);
}

std::string sum_text(const std::vector<double>& weights, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double w = weights[i];
    if (w == 0) continue;
    text += text.empty() ? (w < 0 ? "-" : "") : w < 0 ? " - " : " + ";
    if (std::abs(std::abs(w) - 1) > 1e-9) text += fmt::format("{:.4g} ", std::abs(w));
    text += names[i];
  }
  return text;
}

std::string joined(std::vector<std::string> names) {
  const std::size_t more = names.size() > most_named ? names.size() - most_named : 0;
  names.resize(names.size() - more);
  return fmt::format("{}{}", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

/// The sums that the equations and the solution keep and the run broke; a solution may break one at
/// a contact. `largest` has the size of each component.
std::vector<std::string> broken_sums(const Case& c, const Request& request, const double* end,
                                     const std::vector<double>& exact,
                                     const std::vector<double>& largest) {
  const double relative = request.mode == Mode::adaptive ? request.tolerance.relative : 1e-9;
  std::vector<std::string> broken;
  for (const std::vector<double>& weights : linear_invariants(c)) {
    const auto of = [&](const double* y) {
      return std::inner_product(weights.begin(), weights.end(), y, 0.0);
    };
    double size = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      size = std::max(size, std::abs(weights[i]) * std::max(largest[i], std::abs(end[i])));
    const double before = of(c.y0.data()), allowed = std::max(relative, 1e-12) * size;
    if (std::abs(of(end) - before) > allowed && std::abs(of(exact.data()) - before) <= allowed)
      broken.push_back(fmt::format("the equations keep {}, which went from {:.6g} to {:.6g}",
                                   sum_text(weights, component_names(c)), before, of(end)));
  }
  return broken;
}

/// An absolute tolerance of their own for some components: options of `odeum run`, which leave
/// those of the others. `values`: by component.
std::string own_tolerances(const Case& c, const Request& request,
                           const std::vector<std::size_t>& some,
                           const std::vector<double>& values) {
  const std::vector<std::string> names = component_names(c);
  const double relative = request.tolerance.relative;
  const std::vector<double>& asked = request.tolerance.absolutes();
  std::vector<std::string> words;
  if (asked != c.tolerance.requested(relative).absolutes() && !request.tolerance.by_component())
    words.push_back(fmt::format("{:g}", request.tolerance.absolute(0)));
  for (const std::size_t i : some)
    if (words.size() <= most_named) words.push_back(fmt::format("{}={:.1g}", names[i], values[i]));
  return fmt::format("--rtol {:g} --atol {}{}", relative, fmt::join(words, ","),
                     some.size() > most_named ? ",..." : "");
}

/// `largest`: the size of each component.
std::string text_of_uncontrolled(const Case& c, const Request& request,
                                 const std::vector<std::size_t>& some,
                                 std::vector<double> largest) {
  const std::vector<std::string> names = component_names(c);
  std::vector<std::string> named;
  for (const std::size_t i : some) {
    named.push_back(names[i]);
    largest[i] *= request.tolerance.relative;
  }
  return fmt::format(
      "{} never exceed{} the absolute tolerance, which leaves the error uncontrolled there; {} "
      "controls it",
      joined(named), named.size() == 1 ? "s" : "", own_tolerances(c, request, some, largest));
}

/// Names a library's solver that takes no step below zero, where one is there.
std::string words_of_constraints(const Case& c) {
  std::string solver;
  for (std::size_t k = 0; k < c.entrants.size(); ++k)
    if (c.entrants.info(k).options.contains("constraints")) solver = c.entrants.info(k).id();
  if (solver.empty()) return {};
  return fmt::format(", and --solver {} --option constraints=1 takes no step below zero", solver);
}

/// `largest`: the size of each component; `all_above`: the solution has none below zero.
std::string text_of_negative(const Case& c, const Request& request,
                             const std::vector<BelowZero>& all, std::vector<double> largest,
                             bool all_above) {
  const std::vector<std::string> names = component_names(c);
  std::vector<std::string> named;
  std::vector<std::size_t> some;
  for (const BelowZero& each : all) {
    const std::size_t i = each.component;
    named.push_back(fmt::format("{} ({:.2g} at t = {:.4g})", names[i], each.value, each.time));
    some.push_back(i);
    largest[i] = 0.01 * std::min(request.tolerance.absolute(i), largest[i]);
  }
  return fmt::format(
      "{} {} below zero where the solution is not; {} asks for more digits{}", joined(named),
      named.size() == 1 ? "falls" : "fall",
      request.mode == Mode::fixed ? "a shorter step" : own_tolerances(c, request, some, largest),
      request.mode == Mode::adaptive && all_above ? words_of_constraints(c) : "");
}

std::size_t stops_reached(const Case& c, const Request& request, const Outcome& outcome) {
  return c.y0.empty() ? 0 : std::min(outcome.states.size() / c.y0.size(), request.stops.size());
}

/// What is known of the solution up to the last of the first `count` stops of a run.
struct Extent {
  std::vector<double> largest, lowest;  ///< magnitudes and values of each component
  std::vector<double> last;             ///< the state at that stop; empty: not known
  bool known = false;                   ///< at one of the stops
  double until = 0;                     ///< the last stop at which anything is known

  Extent(const Case& c, const Request& request, std::size_t count)
      : largest(c.truth.largest), lowest(c.truth.lowest) {
    const std::size_t n = c.y0.size();
    lowest.resize(n);
    // Sizes between the stops count, as far as they are known.
    if (largest.empty())
      for (const double start : c.y0) largest.push_back(std::abs(start));
    std::vector<double> exact(n);
    const auto take = [&](double stop) {
      if (!c.truth.at || !c.truth.at(stop, exact.data())) return false;
      for (std::size_t i = 0; i < n; ++i) {
        largest[i] = std::max(largest[i], std::abs(exact[i]));
        lowest[i] = std::min(lowest[i], exact[i]);
      }
      return true;
    };
    until = request.stops[count - 1];
    for (std::size_t k = 0; k < count; ++k)
      if (take(request.stops[k])) known = true, until = request.stops[k];
    for (const double stop : c.stops)  // and between those of the run
      if (stop <= until) take(stop);
    for (int k = 1; c.truth.closed_form && k < samples; ++k)
      take(c.t0 + (until - c.t0) * k / samples);
    if (until == request.stops[count - 1] && take(until)) last = exact;
  }

  /// Rounding and the truth's own error are not a fault.
  double meant(const Case& c, std::size_t i) const {
    return 1e-12 * largest[i] + 10 * c.floor_of(i);
  }
  bool is_above(const Case& c, std::size_t i) const {
    return c.y0[i] >= 0 && lowest[i] >= -meant(c, i);
  }
  /// A component that is zero, or the rounding of others.
  static bool is_nothing(const Case& c, std::size_t i) {
    return !c.truth.largest.empty() && c.truth.largest[i] == 0;
  }
};

std::vector<BelowZero> below(const Extent& solution, const Case& c, const Request& request,
                             const Outcome& outcome) {
  std::vector<BelowZero> all;
  if (!solution.known && c.truth.lowest.empty()) return all;
  const std::size_t n = c.y0.size(), count = stops_reached(c, request, outcome);
  for (std::size_t i = 0; i < n; ++i) {
    if (Extent::is_nothing(c, i) || !solution.is_above(c, i)) continue;
    BelowZero least{.component = i};
    for (std::size_t k = 0; k < count && request.stops[k] <= solution.until; ++k)
      if (const double y = outcome.states[k * n + i]; y < least.value)
        least.value = y, least.time = request.stops[k];
    if (least.value < -solution.meant(c, i)) all.push_back(least);
  }
  std::ranges::stable_sort(all, {}, [&](const BelowZero& each) {
    const double size = solution.largest[each.component];
    return each.value / (size > 0 ? size : 1);
  });
  return all;
}

}  // namespace

std::vector<std::vector<double>> linear_invariants(const Case& c) {
  const std::size_t n = c.y0.size();
  if (n < 2 || n > most_unknowns || !c.problem.view.rhs || c.problem.events) return {};
  const Eigen::MatrixXd slopes = sampled_slopes(c);
  if (slopes.rows() < 2 * slopes.cols()) return {};
  Eigen::FullPivLU<Eigen::MatrixXd> lu(slopes);
  lu.setThreshold(1e-11);  // rounding of slopes of 1, after as many eliminations as unknowns
  const Eigen::MatrixXd kernel = lu.kernel();
  // The sums are in the order of the components whose weights are free.
  std::map<int, std::vector<double>> kept;
  for (Eigen::Index k = 0; k < lu.dimensionOfKernel(); ++k) {
    std::vector<double> weights(kernel.col(k).begin(), kernel.col(k).end());
    double first = 0;
    for (std::size_t i = 0; i < n; ++i) {
      weights[i] = std::abs(weights[i]) > 1e-9 ? weights[i] / c.scale_of(i) : 0;
      if (first == 0) first = weights[i];
    }
    for (double& w : weights) {
      w /= first;
      if (std::abs(w - std::round(w)) < 1e-7) w = std::round(w);
    }
    kept[lu.permutationQ().indices()(lu.rank() + k)] = std::move(weights);
  }
  std::vector<std::vector<double>> all;
  for (auto& [place, weights] : kept) all.push_back(std::move(weights));
  return all;
}

std::vector<BelowZero> below_zero(const Case& c, const Request& request, const Outcome& outcome) {
  const std::size_t count = stops_reached(c, request, outcome);
  if (count == 0) return {};
  return below(Extent(c, request, count), c, request, outcome);
}

std::vector<std::string> remarks(const Case& c, const Request& request, const Outcome& outcome) {
  std::vector<std::string> all;
  const std::size_t n = c.y0.size(), count = stops_reached(c, request, outcome);
  if (count == 0) return all;
  const Extent solution(c, request, count);
  const std::vector<double>& largest = solution.largest;
  std::vector<std::size_t> uncontrolled;
  bool all_above = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (Extent::is_nothing(c, i)) continue;
    // A component that is zero throughout has the value zero.
    if (solution.known && request.mode == Mode::adaptive && largest[i] > 0 &&
        largest[i] < request.tolerance.absolute(i))
      uncontrolled.push_back(i);
    all_above = all_above && solution.is_above(c, i);
  }
  if (!uncontrolled.empty()) all.push_back(text_of_uncontrolled(c, request, uncontrolled, largest));
  if (const auto negative = below(solution, c, request, outcome); !negative.empty())
    all.push_back(text_of_negative(c, request, negative, largest, all_above));
  if (!solution.last.empty())
    std::ranges::move(
        broken_sums(c, request, outcome.states.data() + (count - 1) * n, solution.last, largest),
        std::back_inserter(all));
  return all;
}

}  // namespace odeum::judge
