// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "odeum/cli/session.hpp"
#include "odeum/harness/interrupt.hpp"
#include "odeum/report/csv.hpp"
#include "odeum/report/output_folder.hpp"
#include "odeum/study/judge.hpp"

namespace odeum::cli {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double most_steps = 1e9;

struct RunOptions {
  std::string case_id, solver, out;
  double step = nan, tolerance = nan;
  std::optional<double> until;
};

Request make_request(const RunOptions& options, const Case& c, const Entrant& entrant,
                     bool has_step) {
  Request request;
  const double end = options.until.value_or(c.stops.back());
  const double horizon = end - c.t0;
  if (!std::isfinite(horizon) || !(horizon > 0))
    throw UsageError(fmt::format("--until: got {}, expected a finite time after {}", end, c.t0));
  request.stops = {end};
  if (has_step) {
    const double h = options.step;
    if (!std::isfinite(h) || !(h > 0))
      throw UsageError(fmt::format("--step: got {}, expected a positive number", h));
    if (h > horizon)
      throw UsageError(fmt::format("--step: got {}, expected at most the horizon {}", h, horizon));
    if (horizon / h > most_steps)
      throw UsageError(fmt::format("--step: got {}, which takes more than {:g} steps to t = {}", h,
                                   most_steps, end));
    if (!entrant.info.fixed)
      throw UsageError(fmt::format("{} runs to a tolerance only: use --tol", entrant.info.id()));
    request.mode = Mode::fixed;
    // Steps are whole and equal: to the next divisor of the horizon, unless rounding is all that
    // differs.
    request.steps = static_cast<std::uint64_t>(std::ceil(horizon / h * (1 - 1e-12)));
    const double used = horizon / static_cast<double>(request.steps);
    if (std::abs(used - h) > 1e-9 * h)
      remark(fmt::format("the step is shrunk from {} to {}, so that {} of them reach t = {}", h,
                         used, request.steps, end));
  } else {
    const double smallest = std::numeric_limits<double>::epsilon();
    if (!std::isfinite(options.tolerance) || !(options.tolerance > smallest))
      throw UsageError(
          fmt::format("--tol: got {}, expected a number above machine precision, {:.2g}",
                      options.tolerance, smallest));
    if (!entrant.info.adaptive)
      throw UsageError(fmt::format("{} runs at a fixed step only: use --step", entrant.info.id()));
    request.mode = Mode::adaptive;
    request.tolerance = options.tolerance;
  }
  request.budget.evaluations =
      10'000'000'000;  // the user said what to do; the seconds still bound it
  request.budget.seconds = 600;
  return request;
}

// Time, component, value, exact value and error at the end; exact is nan where no truth is known.
std::string solution_csv(const Case& c, const Entrant& entrant, const Request& request,
                         const Outcome& outcome) {
  report::CsvTable table("case,library,solver,status,time,component,value,exact,error");
  const double t = request.stops.back();
  std::vector<double> exact(c.y0.size(), nan);
  if (!c.truth.at(t, exact.data())) exact.assign(exact.size(), nan);
  for (std::size_t i = 0; i < c.y0.size() && outcome.status == Status::ok; ++i)
    table.add(report::CsvRow()
                  .text(c.id)
                  .text(entrant.info.library)
                  .text(entrant.info.method)
                  .text(to_string(outcome.status))
                  .number(t)
                  .count(i)
                  .number(outcome.states[i])
                  .number(exact[i])
                  .number(outcome.states[i] - exact[i]));
  return table.text();
}

int run(const RunOptions& options, bool has_step) {
  const Case& c = find_case(options.case_id);
  const Entrant& entrant = find_entrant(c, options.solver);
  const Request request = make_request(options, c, entrant, has_step);
  const Outcome outcome = entrant.solve(request);
  if (interrupted) return interrupted_code;
  std::string text =
      fmt::format("case    {}: {}\nsolver  {}\n", c.id, c.equation, entrant.info.id());
  text += has_step ? fmt::format("step    {}, {} steps to t = {}\n",
                                 (request.stops.back() - c.t0) / static_cast<double>(request.steps),
                                 request.steps, request.stops.back())
                   : fmt::format("tol     {}, {} steps and {} rejected to t = {}\n",
                                 options.tolerance, outcome.counters.steps,
                                 outcome.counters.rejected_steps, request.stops.back());
  text += fmt::format("status  {}{}{}\n", to_string(outcome.status),
                      outcome.detail.empty() ? "" : ": ", outcome.detail);
  text += fmt::format("cost    {} evaluations, {} Jacobians\n", outcome.counters.rhs_evaluations,
                      outcome.counters.jacobian_evaluations);
  if (outcome.status == Status::ok) {
    if (c.y0.size() <= 8) {
      text += "state  ";
      for (std::size_t i = 0; i < c.y0.size(); ++i)
        text += " " + report::format_number(outcome.states[i]);
      text += "\n";
    }
    const study::StopError error = study::Judge(c, request.stops).errors(outcome).front();
    text += std::isnan(error.error_max)
                ? fmt::format("error   unknown: {} holds no truth at t = {}\n", c.truth.source,
                              request.stops.back())
                : fmt::format("error   {:.6g} (rms {:.6g}) against {}\n", error.error_max,
                              error.error_rms, c.truth.source);
  }
  if (!options.out.empty()) {
    const report::OutputFolder folder(options.out);
    folder.write("solution.csv", solution_csv(c, entrant, request, outcome));
    text += fmt::format("file    {}\n", (folder.path() / "solution.csv").string());
  }
  print(text);
  return outcome.status == Status::ok ? success : solver_failed;
}

}  // namespace

void add_run(CLI::App& app, int& result) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "one case with one solver");
  command->add_option("case", options->case_id, "a case; odeum list cases")
      ->required()
      ->type_name("CASE");
  command->add_option("--solver", options->solver, "a solver; odeum list solvers")
      ->required()
      ->type_name("ID");
  CLI::Option* step = command->add_option("--step", options->step, "fixed step")->type_name("H");
  CLI::Option* tolerance =
      command->add_option("--tol", options->tolerance, "relative and absolute tolerance")
          ->type_name("R");
  step->excludes(tolerance);
  command->add_option("--until", options->until, "end time; default: the case's horizon")
      ->type_name("T");
  command->add_option("--out", options->out, "folder for solution.csv")->type_name("DIR");
  command->callback([options, step, tolerance, &result] {
    if (step->empty() && tolerance->empty()) throw UsageError("run needs --step or --tol");
    result = run(*options, !step->empty());
  });
}

}  // namespace odeum::cli
