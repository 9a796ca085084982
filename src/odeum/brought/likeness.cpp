// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/likeness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/brought/comparison.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"

namespace odeum::brought {
namespace {

constexpr std::size_t most_components = 40;

Likeness likeness(const Candidate& candidate, const Comparison& comparison) {
  return {candidate.method,        candidate.mistake,
          candidate.order,         static_cast<double>(comparison.rows()),
          comparison.mechanical(), {}};
}

std::optional<Likeness> among_methods(const Comparison& comparison,
                                      const std::vector<Candidate>& methods,
                                      const std::string& claimed) {
  std::vector<const Candidate*> fitting;
  for (const Candidate& candidate : methods) {
    if (interrupted) throw Interrupted();
    if (comparison.fits(candidate)) fitting.push_back(&candidate);
  }
  if (fitting.empty()) return {};
  // Variants of a method have longer names.
  const auto best = std::ranges::min_element(fitting, {}, [&](const Candidate* candidate) {
    return candidate->method == claimed ? 0 : candidate->method.size();
  });
  Likeness found = likeness(**best, comparison);
  for (const Candidate* other : fitting) {
    if (other == *best) continue;
    found.also.push_back(other->method);
    // The claim is held by as much as can be seen; without one the digits tell nothing.
    if (other->order != found.order && found.method != claimed) found.method.clear();
  }
  return found;
}

std::optional<Likeness> among_mistakes(const Comparison& comparison, const std::string& claimed) {
  std::optional<Likeness> found;
  for (const Candidate& candidate : known_mistakes(claimed)) {
    if (interrupted) throw Interrupted();
    if (!comparison.fits(candidate)) continue;
    if (!found)
      found = likeness(candidate, comparison);
    else if (candidate.method == found->method)
      found->also.push_back(candidate.mistake);
  }
  return found;
}

std::optional<Likeness> with_another_step(const Comparison& comparison,
                                          const std::vector<Candidate>& methods,
                                          const std::string& claimed) {
  for (const Candidate& candidate : methods) {
    if (interrupted) throw Interrupted();
    if (!claimed.empty() ? candidate.method != claimed : candidate.order > 4) continue;
    if (const std::optional<double> factor = comparison.other_step(candidate)) {
      Likeness found = likeness(candidate, comparison);
      found.mistake =
          fmt::format("its steps are {:.6g} times as long as the times in the file say", *factor);
      return found;
    }
  }
  return {};
}

/// The value of a parameter with which rows are the candidate's: by the secant method, and then
/// rounded as people type it.
std::optional<double> value_of(const Case& c, const Trajectory& run, const Candidate& candidate,
                               std::size_t parameter) {
  constexpr int most_tries = 4;
  std::vector<double> values;
  for (const Parameter& each : c.parameters) values.push_back(each.value);
  const auto with = [&](double value) {
    values[parameter] = value;
    return c.with_values(values, {});
  };
  const double given = values[parameter];
  double x = given, other = given == 0 ? 0.01 : 1.01 * given;
  std::vector<double> at = Comparison(c, run).defect(candidate), next;
  for (int k = 0; k < most_tries && !at.empty(); ++k) {
    next = Comparison(with(other), run).defect(candidate);
    if (next.empty()) return {};
    const std::size_t i = most_moved(at, next);
    const double slope = (next[i] - at[i]) / (other - x);
    if (slope == 0 || !std::isfinite(slope)) return {};
    x = other, at = next, other -= next[i] / slope;
    if (std::abs(other - x) <= 1e-9 * std::abs(x)) break;
  }
  for (const int digits : {2, 3, 4, 6}) {
    const double typed = std::stod(fmt::format("{:.{}g}", other, digits));
    if (typed != given && std::abs(typed - other) <= 1e-6 * std::max(std::abs(other), 1e-3) &&
        Comparison(with(typed), run).fits(candidate))
      return typed;
  }
  return {};
}

std::optional<Likeness> with_another_parameter(const Case& c, const Trajectory& run,
                                               const std::vector<Candidate>& methods,
                                               const std::string& claimed) {
  constexpr std::size_t most_parameters = 12;
  if (claimed.empty() || !c.with_values || c.parameters.size() > most_parameters) return {};
  for (const Candidate& candidate : methods) {
    if (candidate.method != claimed) continue;
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
      if (interrupted) throw Interrupted();
      try {
        const std::optional<double> value = value_of(c, run, candidate, k);
        if (!value) continue;
        Likeness found = likeness(candidate, Comparison(c, run));
        found.mistake = fmt::format("{} is {:.6g} in place of {:.6g}", c.parameters[k].name, *value,
                                    c.parameters[k].value);
        return found;
      } catch (const std::invalid_argument&) {
        // No problem has that value.
      }
    }
  }
  return {};
}

}  // namespace

std::string Likeness::text() const {
  constexpr std::size_t most = 3;
  if (!mistake.empty()) {
    std::string text =
        fmt::format("the numbers are those of {} with a mistake: {}", method, mistake);
    for (std::size_t k = 0; k < std::min(also.size(), most); ++k) text += "; or " + also[k];
    if (also.size() > most) text += fmt::format("; or {} others", also.size() - most);
    return text + (also.empty() ? "" : ", which come to the same on this problem");
  }
  std::string text = fmt::format("the numbers are those of {}", method);
  if (mechanical && method == "explicit_euler") text += " (positions use the old velocities)";
  if (mechanical && method == "symplectic_euler") text += " (positions use the new velocities)";
  if (mechanical && method == "symplectic_euler_position_first")
    text += " (velocities use the new positions)";
  text += " to all digits that are written";
  if (!also.empty())
    text += fmt::format(" (and of {}, which {} the same here)", fmt::join(also, ", "),
                        also.size() == 1 ? "does" : "do");
  return text;
}

std::optional<Likeness> likeness_of(const Case& c, const Trajectory& run,
                                    const std::string& claimed) {
  if (!run.is_whole(c) || c.y0.size() > most_components || run.rows() < 3) return {};
  const Comparison comparison(c, run);
  const std::vector<Candidate> methods = known_methods();
  std::optional<Likeness> found = among_methods(comparison, methods, claimed);
  if (!found) found = among_mistakes(comparison, claimed);
  if (!found) found = with_another_step(comparison, methods, claimed);
  if (!found) found = with_another_parameter(c, run, methods, claimed);
  if (!found && !claimed.empty()) found = among_mistakes(comparison, "");
  if (!found && !claimed.empty()) found = with_another_step(comparison, methods, "");
  if (found && found->method.empty()) return {};
  return found;
}

}  // namespace odeum::brought
