// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/run_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "odeum/judge/errors.hpp"

namespace odeum::cli {
namespace {

struct LastError {
  bool known = false;
  double time = nan;
  judge::StopError error;
  judge::JudgedAnswer judged;
};

LastError last_error(const Case& c, const trajectories::CaseRun& run) {
  const Request& request = run.request;
  const judge::Judge judge(c, request.stops);
  std::vector<judge::StopError> errors = judge.errors(run.outcome);
  while (!errors.empty() && std::isnan(errors.back().error_max)) errors.pop_back();
  if (errors.empty()) return {};
  const std::vector<double> stops(
      request.stops.begin(), request.stops.begin() + static_cast<std::ptrdiff_t>(errors.size()));
  const bool fixed = request.mode == Mode::fixed;
  return {.known = true,
          .time = stops.back(),
          .error = errors.back(),
          .judged = fixed ? judge::judge_fixed_answer(errors, judge.scale())
                          : judge::judge_answer(
                                errors, judge::measure_amplification(c, stops, request.tolerance),
                                request.tolerance.relative,
                                static_cast<double>(run.outcome.counters.steps), c.truth.floor,
                                judge.scale())};
}

}  // namespace

std::string error_text(const Case& c, const trajectories::CaseRun& run) {
  const LastError last = last_error(c, run);
  const double end = run.request.stops.back();
  if (!last.known)
    return fmt::format("error   unknown: no truth at t = {}: {}\n", end, c.truth.source);
  std::string text =
      fmt::format("error   {:.6g} (rms {:.6g}) ", last.error.error_max, last.error.error_rms);
  if (last.time < end)
    text += fmt::format("at t = {}; no truth is known from there to t = {}; ", last.time, end);
  text += fmt::format("against {}\n", c.truth.source);
  const judge::JudgedAnswer& judged = last.judged;
  if (judged.answer == judge::Answer::not_applicable) return text;
  text += fmt::format("answer  {}", to_string(judged.answer));
  if (!judged.reason.empty())
    text += ": " + judged.reason;
  else
    text +=
        fmt::format(": tolerance, steps and amplification explain up to {:.2g}", judged.explained);
  return text + "\n";
}

RunRows rows_of(const Case& c, const std::vector<trajectories::CaseRun>& runs) {
  RunRows all;
  for (const trajectories::CaseRun& run : runs) {
    const bool fixed = run.request.mode == Mode::fixed, ok = run.outcome.status == Status::ok;
    const LastError last = ok ? last_error(c, run) : LastError{};
    const std::size_t reached = run.reached(c.y0.size());
    all.rows.push_back({.case_id = c.id,
                        .library = run.entrant->info.library,
                        .solver = run.entrant->info.method,
                        .mode = run.request.mode,
                        .step = fixed ? run.step(c.t0) : nan,
                        .tolerance = fixed ? nan : run.request.tolerance.relative,
                        .end = run.request.stops.back(),
                        .status = run.outcome.status,
                        .detail = run.outcome.detail,
                        .counters = run.outcome.counters,
                        .reached = reached > 0 ? run.request.stops[reached - 1] : c.t0,
                        .error_time = last.time,
                        .error_max = last.known ? last.error.error_max : nan,
                        .error_rms = last.known ? last.error.error_rms : nan,
                        .floor = c.truth.floor,
                        .judged = last.judged,
                        .truth = c.truth.source});
  }
  return all;
}

}  // namespace odeum::cli
