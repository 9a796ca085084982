// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/material/material.hpp"

#include <fmt/format.h>

#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

// Stiffness and damping at each step; the files hold the rest.
std::string material_table(const std::vector<study::MaterialRow>& rows) {
  std::string text = fmt::format("{:<14} {:<32} {:>9} {:>6} {:>6} {:>9} {:>9} {:>9} {:>9}  {}\n",
                                 "scene", "solver", "step", "sweeps", "newton", "resting",
                                 "vibrating", "damping", "added", "status");
  for (const study::MaterialRow& row : rows)
    text += fmt::format(
        "{:<14} {:<32} {:>9.3g} {:>6} {:>6} {:>9.3g} {:>9.3g} {:>9.3g} {:>9.2g}  "
        "{}{}{}\n",
        row.scene, row.library + "/" + row.solver, row.step, row.sweeps, row.newton, row.resting,
        row.vibrating, row.damping, row.added_damping_ratio, row.status,
        row.detail.empty() ? "" : ": ", row.detail);
  return text;
}

std::string parts_table(const std::vector<study::ErrorPartsRow>& rows) {
  std::string text =
      fmt::format("\n{:<32} {:>9} {:>6} {:>6} {:>9} {:>9} {:>9} {:>9}  {}\n", "errors in m", "step",
                  "sweeps", "newton", "total", "iteration", "time step", "model", "status");
  for (const study::ErrorPartsRow& row : rows)
    text += fmt::format("{:<32} {:>9.3g} {:>6} {:>6} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g}  {}{}{}\n",
                        row.library + "/" + row.solver, row.step, row.sweeps, row.newton, row.total,
                        row.iteration, row.time_step, row.model, row.status,
                        row.detail.empty() ? "" : ": ", row.detail);
  return text;
}

}  // namespace

void add_material(CLI::App& app, int& result) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand(
      "material", "what engines do to stiffness and damping, and cloths in the long run");
  add_study_options(*command, *options);
  command->callback([options, &result] {
    if (options->resume)
      throw UsageError("--resume: material keeps no journal, it takes half a minute");
    check_solver_globs(options->solvers);
    const record::OutputFolder folder(options->out);
    const study::MaterialResult measured =
        study::measure_material({.solvers = options->solvers, .jobs = options->jobs_or_cores()});
    write_csv(measured, folder);
    print(material_table(measured.material) + parts_table(measured.errors));
    remark(fmt::format(
        "material.csv, material_error.csv, cloth_long.csv, cloth_cost.csv and implicit_wins.csv "
        "are in {}",
        options->out));
    result = success;
  });
}

}  // namespace odeum::cli
