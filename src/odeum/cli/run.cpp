// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "odeum/cli/run.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::cli {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Time, component, value, exact value and error at the end; exact is nan where the truth is not
// known.
std::string solution_csv(const Case& c, const Entrant& entrant, const Request& request,
                         const Outcome& outcome) {
  record::CsvTable table("case,library,solver,status,time,component,value,exact,error");
  const double t = request.stops.back();
  std::vector<double> exact(c.y0.size(), nan);
  if (!c.truth.at(t, exact.data())) exact.assign(exact.size(), nan);
  for (std::size_t i = 0; i < c.y0.size() && outcome.status == Status::ok; ++i)
    table.add(record::CsvRow()
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

int run(const RunOptions& options) {
  const Case& c = find_case(options.what);
  if (options.solver.empty()) throw UsageError("--solver is required for a case");
  const bool has_step = options.settings.step.has_value();
  if (!has_step && !options.settings.tolerance) throw UsageError("run needs --step or --tol");
  const Entrant& entrant = find_entrant(c, options.solver);
  const Request request = make_request(options.settings, c.t0, c.stops.back(), entrant.info);
  const Outcome outcome = entrant.solve(request);
  if (interrupted) return interrupted_code;
  std::string text =
      fmt::format("case    {}: {}\nsolver  {}\n", c.id, c.equation, entrant.info.id());
  text += has_step ? fmt::format("step    {}, {} steps to t = {}\n",
                                 (request.stops.back() - c.t0) / static_cast<double>(request.steps),
                                 request.steps, request.stops.back())
                   : fmt::format("tol     {}, {} steps and {} rejected to t = {}\n",
                                 *options.settings.tolerance, outcome.counters.steps,
                                 outcome.counters.rejected_steps, request.stops.back());
  text += fmt::format("status  {}{}{}\n", to_string(outcome.status),
                      outcome.detail.empty() ? "" : ": ", outcome.detail);
  text += fmt::format("cost    {} evaluations, {} Jacobians\n", outcome.counters.rhs_evaluations,
                      outcome.counters.jacobian_evaluations);
  if (outcome.status == Status::ok) {
    if (c.y0.size() <= 8) {
      text += "state  ";
      for (std::size_t i = 0; i < c.y0.size(); ++i)
        text += " " + record::format_number(outcome.states[i]);
      text += "\n";
    }
    const judge::StopError error = judge::Judge(c, request.stops).errors(outcome).front();
    text += std::isnan(error.error_max)
                ? fmt::format("error   unknown: {} has no truth at t = {}\n", c.truth.source,
                              request.stops.back())
                : fmt::format("error   {:.6g} (rms {:.6g}) against {}\n", error.error_max,
                              error.error_rms, c.truth.source);
  }
  if (!options.out.empty()) {
    const record::OutputFolder folder(options.out);
    folder.write("solution.csv", solution_csv(c, entrant, request, outcome));
    text += fmt::format("file    {}\n", (folder.path() / "solution.csv").string());
  }
  print(text);
  return outcome.status == Status::ok ? success : solver_failed;
}

}  // namespace

void add_run(CLI::App& app, int& result) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "one case or one scene with one solver");
  command
      ->add_option("case", options->what, "a case, or a scene: its file, or a name of odeum list")
      ->required()
      ->type_name("CASE|SCENE.yaml");
  command->add_option("--solver", options->solver, "a solver; default: the scene's own")
      ->type_name("ID");
  CLI::Option* step =
      command->add_option("--step", options->settings.step, "fixed step")->type_name("H");
  command->add_option("--tol", options->settings.tolerance, "relative and absolute tolerance")
      ->type_name("R")
      ->excludes(step);
  command->add_option("--until", options->settings.until, "end time; default: the horizon")
      ->type_name("T");
  command->add_option("--out", options->out, "folder for the files")->type_name("DIR");
  command->add_option("--max-particles", options->limits.most_particles, "of a scene")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--max-megabytes", options->megabytes, "of a scene's file")
      ->type_name("N")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command->callback([options, &result] {
    options->limits.most_bytes = options->megabytes * 1'000'000;
    const auto scene = find_scene(options->what);
    result = scene ? run_scene(*scene, *options) : run(*options);
  });
}

}  // namespace odeum::cli
