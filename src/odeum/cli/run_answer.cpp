// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/cli/run.hpp"
#include "odeum/judge/answer.hpp"
#include "odeum/judge/remarks.hpp"

namespace odeum::cli {
namespace {

std::string error_and_answer(const Case& c, const Request& request, const Outcome& outcome) {
  const judge::Judge judge(c, request.stops);
  std::vector<judge::StopError> errors = judge.errors(outcome);
  const double end = request.stops.back();
  while (!errors.empty() && std::isnan(errors.back().error_max)) errors.pop_back();
  if (errors.empty())
    return fmt::format("error   unknown: no truth at t = {}: {}\n", end, c.truth.source);
  const std::vector<double> stops(
      request.stops.begin(), request.stops.begin() + static_cast<std::ptrdiff_t>(errors.size()));
  const bool fixed = request.mode == Mode::fixed;
  const judge::JudgedAnswer judged =
      fixed ? judge::judge_fixed_answer(errors, judge.scale())
            : judge::judge_answer(errors, judge::measure_amplification(c, stops, request.tolerance),
                                  request.tolerance.relative,
                                  static_cast<double>(outcome.counters.steps), c.truth.floor,
                                  judge.scale());
  std::string text =
      fmt::format("error   {:.6g} (rms {:.6g}) ", errors.back().error_max, errors.back().error_rms);
  if (stops.back() < end)
    text += fmt::format("at t = {}; no truth is known from there to t = {}; ", stops.back(), end);
  if (!c.scale.empty()) text += "in the units of the scale, ";
  text += fmt::format("against {}\n", c.truth.source);
  if (judged.answer == judge::Answer::not_applicable) return text;
  text += fmt::format("answer  {}", to_string(judged.answer));
  if (!judged.reason.empty())
    text += ": " + judged.reason;
  else
    text +=
        fmt::format(": tolerance, steps and amplification explain up to {:.2g}", judged.explained);
  return text + "\n";
}

}  // namespace

std::string error_text(const Case& c, const Request& request, const Outcome& outcome) {
  std::string text = error_and_answer(c, request, outcome);
  for (const std::string& remark : judge::remarks(c, request, outcome))
    text += fmt::format("remark  {}\n", remark);
  return text;
}

}  // namespace odeum::cli
