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

/// `lowest` and `largest`: of each component, by the run and by the solution, of which no component
/// is below zero where `all_above`.
std::string text_of_negative(const Case& c, const Request& request,
                             const std::vector<std::size_t>& some,
                             const std::vector<double>& lowest, std::vector<double> largest,
                             bool all_above) {
  const std::vector<std::string> names = component_names(c);
  std::vector<std::string> named;
  for (const std::size_t i : some) {
    named.push_back(fmt::format("{} ({:.2g})", names[i], lowest[i]));
    largest[i] = 0.01 * std::min(request.tolerance.absolute(i), largest[i]);
  }
  return fmt::format(
      "{} {} below zero where the solution is not; {} asks for more digits{}", joined(named),
      named.size() == 1 ? "falls" : "fall",
      request.mode == Mode::fixed ? "a shorter step" : own_tolerances(c, request, some, largest),
      request.mode == Mode::adaptive && all_above ? words_of_constraints(c) : "");
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

std::vector<std::string> remarks(const Case& c, const Request& request, const Outcome& outcome) {
  std::vector<std::string> all;
  const std::size_t n = c.y0.size(), reached = n == 0 ? 0 : outcome.states.size() / n;
  if (reached == 0) return all;
  const auto stops = std::min(reached, request.stops.size());
  std::vector<std::size_t> uncontrolled, below_zero;
  bool all_above = true;
  std::vector<double> largest(n), exact(n), lowest(n), lowest_exact(n);
  for (std::size_t i = 0; i < n; ++i) largest[i] = std::abs(c.y0[i]);
  // Sizes between the stops count, as far as they are known.
  if (!c.truth.largest.empty()) largest = c.truth.largest;
  if (!c.truth.lowest.empty()) lowest_exact = c.truth.lowest;
  const auto take_truth_at = [&](double stop) {
    if (!c.truth.at || !c.truth.at(stop, exact.data())) return false;
    for (std::size_t i = 0; i < n; ++i) {
      largest[i] = std::max(largest[i], std::abs(exact[i]));
      lowest_exact[i] = std::min(lowest_exact[i], exact[i]);
    }
    return true;
  };
  bool known = false;
  for (std::size_t k = 0; k < stops; ++k) {
    if (!take_truth_at(request.stops[k])) continue;
    known = true;
    const double* y = outcome.states.data() + k * n;
    for (std::size_t i = 0; i < n; ++i) lowest[i] = std::min(lowest[i], y[i]);
  }
  if (!known) return all;
  const double until = request.stops[stops - 1];
  for (const double stop : c.stops)  // and between those of the run
    if (stop <= until) take_truth_at(stop);
  if (c.truth.closed_form)
    for (int k = 1; k < samples; ++k) take_truth_at(c.t0 + (until - c.t0) * k / samples);
  for (std::size_t i = 0; i < n; ++i) {
    // One that is zero, or the rounding of others.
    if (!c.truth.largest.empty() && c.truth.largest[i] == 0) continue;
    // A component that is zero throughout has the value zero.
    if (request.mode == Mode::adaptive && largest[i] > 0 &&
        largest[i] < request.tolerance.absolute(i))
      uncontrolled.push_back(i);
    // Rounding and the truth's own error are not a fault.
    const double meant = 1e-12 * largest[i] + 10 * c.floor_of(i);
    const bool is_above = c.y0[i] >= 0 && lowest_exact[i] >= -meant;
    all_above = all_above && is_above;
    if (is_above && lowest[i] < -meant) below_zero.push_back(i);
  }
  if (!uncontrolled.empty()) all.push_back(text_of_uncontrolled(c, request, uncontrolled, largest));
  if (!below_zero.empty())
    all.push_back(text_of_negative(c, request, below_zero, lowest, largest, all_above));
  const double* end = outcome.states.data() + (stops - 1) * n;
  if (!take_truth_at(request.stops[stops - 1])) return all;
  std::ranges::move(broken_sums(c, request, end, exact, largest), std::back_inserter(all));
  return all;
}

}  // namespace odeum::judge
