// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#ifdef ODEUM_HAS_ARB
#include "odeum/truth/enclosed_flow.hpp"
#endif

namespace odeum::truth {
#ifdef ODEUM_HAS_ARB
namespace {

constexpr std::size_t most_states = 8;

bool has_kinks(const formula::Problem& problem) {
  const std::vector<formula::Id> nodes = problem.graph.needed(problem.equations);
  return std::ranges::any_of(
      nodes, [&](formula::Id id) { return formula::has_kinks(problem.graph[id].op); });
}

/// Compares the enclosure at a time with what is claimed there; false: nothing more is to be done.
bool compare(const Claim& claim, const std::vector<Ball>& box, double time, Certificate& result) {
  std::vector<double> y(box.size());
  if (!claim.at(time, y.data())) return true;
  double width = 0, claimed = 0;
  bool within = true, outside = false;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double unit = claim.units.of(i, y[i]);
    const double allowed = claim.floors[i] + 0x1p-53 * std::abs(y[i]);
    const Ball apart = box[i] - Ball(y[i]);
    within = within && apart.largest() <= allowed;
    outside = outside || apart.least() > allowed;
    width = std::max(width, box[i].radius() / unit);
    claimed = std::max(claimed, claim.floors[i] / unit);
  }
  if (within) {
    result.time = time;
    result.width = std::max(result.width, width);
    ++result.proved;
    return true;
  }
  result.said = outside ? Certificate::Said::refuted : Certificate::Said::agreed;
  if (outside) result.time = time;
  result.why = outside ? fmt::format(
                             "at t = {:.6g} it is outside of the enclosure, of radius {:.1e}, and "
                             "its own error",
                             time, width)
                       : fmt::format(
                             "at t = {:.6g} the enclosure, of radius {:.1e}, is no narrower than "
                             "the error that is claimed, {:.1e}",
                             time, width, claimed);
  return false;
}
}  // namespace
#endif

std::string to_text(const Certificate& c) {
  if (c.said == Certificate::Said::proved)
    return fmt::format("proved: an enclosure of radius {:.1e} holds the solution up to t = {:.6g}",
                       c.width, c.time);
  if (c.said == Certificate::Said::refuted) return "refuted: " + c.why;
  return c.proved == 0 ? "agreed, not proved: " + c.why
                       : fmt::format("proved up to t = {:.6g}, agreed beyond: {}", c.time, c.why);
}

std::optional<Certificate> certify([[maybe_unused]] const formula::Problem& problem,
                                   [[maybe_unused]] const Claim& claim) {
#ifdef ODEUM_HAS_ARB
  if (problem.states.size() > most_states)
    return Certificate{.why = fmt::format("it has {} states, and proofs take {} at most",
                                          problem.states.size(), most_states)};
  if (has_kinks(problem)) return Certificate{.why = "it has kinks"};
  Certificate result;
  EnclosedFlow flow(problem);
  for (const double time : claim.times) {
    result.why = flow.run_to(time);
    if (!result.why.empty() || !compare(claim, flow.box(), time, result)) return result;
  }
  result.said = result.proved > 0 ? Certificate::Said::proved : Certificate::Said::agreed;
  if (result.proved == 0) result.why = "nothing is claimed";
  return result;
#else
  return std::nullopt;
#endif
}

}  // namespace odeum::truth
