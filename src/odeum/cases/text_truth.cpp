// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_truth.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "odeum/cases/case_text.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/core/build_info.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/formula/text_ode.hpp"
#include "odeum/truth/certificate.hpp"
#include "odeum/truth/inspector.hpp"
#include "odeum/truth/text_system.hpp"

namespace odeum::cases {
namespace {

using formula::TextOde;
using truth::Real;

/// What the solution depends on, as text.
std::string content_of(const formula::Problem& problem, const formula::Analysis& analysis) {
  std::string content = formula::print_c(problem, analysis);
  content += fmt::format("\n{}", problem.t0);
  for (const Real y : problem.y0) content += fmt::format(" {:.21Lg}", y);
  return content + problem.events_text;
}

/// The place of a time in a reference, which was computed from the same problem: a time that
/// differs by rounding alone is the same.
std::size_t place_of(const truth::Reference& reference, double t) {
  for (std::size_t k = 0; k < reference.times.size(); ++k)
    if (std::abs(reference.times[k] - t) <= 4e-16 * std::abs(t)) return k;
  return reference.times.size();
}

}  // namespace

TextTruth closed_form(const formula::Problem& problem, const ErrorUnits& units) {
  const auto in_double =
      std::make_shared<const formula::Evaluator<double>>(problem.graph, problem.exact);
  const auto extended =
      std::make_shared<const formula::Evaluator<long double>>(problem.graph, problem.exact);
  TextTruth result;
  result.extended = [extended](double t, long double* y) {
    (*extended)(t, nullptr, y);
    return true;
  };
  result.truth.at = [extended, n = problem.states.size()](double t, double* y) {
    std::vector<long double> values(n);
    (*extended)(t, nullptr, values.data());
    std::ranges::copy(values, y);
    return true;
  };
  // What rounding does to the formula in double tells what it does in extended precision.
  Real amplified = 0, largest = 0;
  std::vector<double> low(problem.states.size());
  std::vector<Real> high(problem.states.size());
  for (int k = 0; k <= 80; ++k) {
    const Real t = problem.t0 + (problem.stops.back() - problem.t0) * k / 80;
    const auto rounded = static_cast<double>(t);
    (*in_double)(rounded, nullptr, low.data());
    (*extended)(rounded, nullptr, high.data());
    for (std::size_t i = 0; i < low.size(); ++i) {
      const Real unit = units.of(i, static_cast<double>(high[i]));
      largest = std::max(largest, std::abs(high[i]) / unit);
      if (std::isfinite(low[i])) amplified = std::max(amplified, std::abs(low[i] - high[i]) / unit);
    }
  }
  result.extended_floor =
      static_cast<double>(10 * 0x1p-11L * std::max(amplified, 0x1p-53L * largest));
  result.truth.floor = result.extended_floor + static_cast<double>(0x1p-53L * largest);
  result.truth.source = "the closed form of " + problem.file;
  result.truth.closed_form = true;
  result.stops = problem.stops;
  result.known_until = problem.stops.back();
  result.words =
      fmt::format("closed form, which fulfils the equations; known to {:.1e}", result.truth.floor);
  return result;
}

TextTruth truth_from(truth::Reference computed, const std::vector<double>& stops,
                     const ErrorUnits& units, const std::string& what) {
  const auto reference = std::make_shared<const truth::Reference>(std::move(computed));
  const std::size_t n = reference->states.empty() ? 0 : reference->states.front().size();
  TextTruth result;
  result.known_until = reference->known_until;
  for (const double stop : stops)
    if (place_of(*reference, stop) < reference->times.size()) result.stops.push_back(stop);
  if (result.stops.empty() && !reference->times.empty())
    result.stops.push_back(reference->times.back());
  result.truth.floors.assign(n, 0);
  for (std::size_t k = 0; k < reference->times.size(); ++k) {
    if (!result.stops.empty() && reference->times[k] > result.stops.back()) break;
    for (std::size_t i = 0; i < n; ++i) {
      const auto size = static_cast<double>(std::abs(reference->states[k][i]));
      const double floor = reference->floors[k][i], rounded = floor + 0x1p-53 * size,
                   unit = units.of(i, size);
      result.extended_floor = std::max(result.extended_floor, floor / unit);
      result.truth.floors[i] = std::max(result.truth.floors[i], rounded);
      result.truth.floor = std::max(result.truth.floor, rounded / unit);
    }
  }
  result.extended = [reference](double t, long double* y) {
    const std::size_t k = place_of(*reference, t);
    if (k == reference->times.size()) return false;
    std::ranges::copy(reference->states[k], y);
    return true;
  };
  result.truth.at = [at = result.extended, n, ends_at = reference->ends_at](double t, double* y) {
    if (t > ends_at) {
      std::fill_n(y, n, std::numeric_limits<double>::infinity());
      return true;
    }
    std::vector<long double> state(n);
    if (!at(t, state.data())) return false;
    std::ranges::copy(state, y);
    return true;
  };
  result.truth.source = "computed from " + what + " by " + reference->methods;
  if (reference->times.empty())
    result.words = fmt::format("none is known, at no time after the start: of {}, {}",
                               reference->methods, reference->end);
  else
    result.words = fmt::format("computed by {}, which agree to {:.1e}; known to {:.1e}",
                               reference->methods, reference->disagreement, result.truth.floor);
  if (!reference->times.empty() && !reference->end.empty())
    result.words += fmt::format(" up to t = {:.6g}, and no verdict is given beyond: {}",
                                result.known_until, reference->end);
  if (std::isfinite(reference->ends_at))
    result.words += fmt::format("; its slope is unbounded: a state after t = {:.6g} is wrong",
                                reference->ends_at);
  return result;
}

void cut_stops(Case& c, std::vector<double> known) {
  std::erase_if(known, [&](double stop) { return stop > c.stops.back(); });
  if (known.empty()) return;
  if (known.back() < c.stops.back()) c.asked_end = c.stops.back();
  c.stops = std::move(known);
}

std::shared_ptr<const truth::Along> along_of(const std::shared_ptr<const TextOde>& ode) {
  const formula::Problem& problem = ode->problem();
  const std::string name =
      formula::content_key(fmt::format("{}\n{}\n{}", content_of(problem, ode->analysis()),
                                       build::truth_code, fmt::join(problem.stops, " "))) +
      ".along";
  std::optional<truth::Along> along;
  if (const auto text = formula::kept_text(name)) along = truth::along_from(*text, ode->size());
  if (!along) {
    along = truth::look_along(truth::system_of(ode), problem.stops);
    if (along) formula::keep_text(name, to_text(*along));
  }
  return along ? std::make_shared<const truth::Along>(*std::move(along)) : nullptr;
}

void take_sizes(const truth::Along& along, Truth& truth) {
  truth.largest = along.largest;
  truth.lowest = along.lowest;
}

TextTruth truth_of(const std::shared_ptr<const TextOde>& ode, const ErrorUnits& units,
                   const std::shared_ptr<const truth::Along>& along, const TruthBounds& bounds,
                   const std::function<void(truth::Reference&)>& foresee) {
  const formula::Problem& problem = ode->problem();
  const auto compute = [&] {
    truth::System system = truth::system_of(ode);
    system.along = along;
    truth::Reference reference = truth::compute_reference(system, problem.stops, units, bounds);
    if (foresee) foresee(reference);
    return reference;
  };
  TextTruth result =
      truth_from(*truth::kept_or_computed(content_of(problem, ode->analysis()), ode->size(),
                                          problem.stops, units, bounds, compute),
                 problem.stops, units, problem.file);
  if (along) take_sizes(*along, result.truth);
  result.words += fmt::format(
      "; steps are looked into down to a width of {:.1g}",
      static_cast<double>((problem.stops.back() - problem.t0) * truth::shortest_inspected));
  return result;
}

std::string proof_of(const formula::Problem& problem, const formula::Analysis& analysis,
                     const Case& c) {
  if (!problem.events.empty()) return "";  // an enclosure goes along the equations alone
  truth::Claim claim{.times = c.stops, .at = c.truth.at, .floors = {}, .units = c.units};
  for (std::size_t i = 0; i < problem.states.size(); ++i) claim.floors.push_back(c.floor_of(i));
  std::string content = content_of(problem, analysis);
  std::vector<double> y(problem.states.size());
  fmt::format_to(std::back_inserter(content), "\n{}\n{} {} {}", build::truth_code,
                 fmt::join(claim.floors, " "), fmt::join(c.units.scale, " "),
                 fmt::join(c.units.relative_from, " "));
  for (const double stop : claim.times)
    if (claim.at(stop, y.data()))
      fmt::format_to(std::back_inserter(content), "\n{} {}", stop, fmt::join(y, " "));
  const std::string name = formula::content_key(content) + ".proof";
  if (const auto kept = formula::kept_text(name)) return *kept;
  const auto certificate = truth::certify(problem, claim);
  if (!certificate) return "";
  std::string text = to_text(*certificate);
  formula::keep_text(name, text);
  return text;
}

void prove(const formula::Problem& problem, const formula::Analysis& analysis, Case& c,
           TextTruth& truth) {
  constexpr double larger = 30, most = 1e6;
  const bool is_computed = !truth.words.empty() && !truth.truth.closed_form;
  std::string proof = proof_of(problem, analysis, c);
  const auto is_refuted = [&] { return is_computed && proof.starts_with("refuted"); };
  for (double by = larger; is_refuted() && by <= most; by *= larger) {
    c.truth.floor *= larger;
    for (double& floor : c.truth.floors) floor *= larger;
    truth.extended_floor *= larger;
    proof = proof_of(problem, analysis, c);
    if (!is_refuted())
      proof += fmt::format("; an enclosure refuted that error, and {:.1e} is taken for it",
                           c.truth.floor);
  }
  if (is_refuted()) {
    c.truth.at = unknown_truth().at;
    proof = "none is known: an enclosure of the solution refutes what two methods agree on";
  }
  if (proof.empty()) return;
  c.truth.source += "; " + proof;
  if (!truth.words.empty()) truth.words += "; " + proof;
}

std::string with_proof(const Case& c) {
  const BuiltInText* const text = built_in_text_of(c.id);
  if (!text) return c.truth.source;
  TextSource source = source_of(*text, c.id);
  const auto usual = CaseText(source).problem().parameters;
  for (const auto& [name, value, meaning] : c.parameters)
    if (static_cast<double>(usual.at(name)) != value)
      source.set[name] = fmt::format("{:.21g}", value);
  CaseText now(source);
  const std::string proof = proof_of(now.problem(), formula::analyse(now.problem()), c);
  return c.truth.source + (proof.empty() ? "" : "; ") + proof;
}

}  // namespace odeum::cases
