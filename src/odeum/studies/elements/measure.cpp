// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <sstream>

#include "odeum/core/glob.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/studies/elements/problems.hpp"
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {
namespace {

/// Far below any error of a mesh, and above what rounding leaves on the finest one.
constexpr double solved = 1e-11;
constexpr std::size_t fewest_divisions = 4;
/// Triangles that can be told apart in a picture.
constexpr std::size_t pictured_divisions = 8;

/// |error| at the node in the middle of the unit square; NaN where there is none.
double centre_error(const fem::Levels::Level& level, const std::vector<double>& nodal,
                    double value) {
  for (std::size_t i = 0; i < nodal.size(); ++i)
    if (fem::distance(level.mesh.nodes[i], {0.5, 0.5}) < 1e-9) return std::abs(nodal[i] - value);
  return nan;
}

void add_field(const ModelProblem& model, std::size_t divisions, const fem::TriangleMesh& mesh,
               const std::vector<double>& nodal, ElementsResult& result) {
  for (const auto& ids : mesh.triangles) {
    ElementsFieldRow& row = result.fields.emplace_back();
    row.problem = model.id, row.divisions = divisions;
    for (std::size_t k = 0; k < 3; ++k) {
      const fem::Point p = mesh.nodes[ids[k]];
      row.x[k] = p.x, row.y[k] = p.y;
      row.u[k] = nodal[ids[k]], row.error[k] = row.u[k] - model.value(p);
    }
  }
}

/// A row, and the field where it is pictured.
void add_mesh(const ModelProblem& model, const Hierarchy& hierarchy, std::size_t number,
              ElementsResult& result) {
  const fem::Levels::Level& level = hierarchy.levels()[number];
  ElementsRow& row = result.meshes.emplace_back();
  row.problem = model.id, row.rule = model.rule->name;
  row.divisions = hierarchy.divisions(number), row.triangles = level.mesh.triangles.size();
  row.unknowns = level.system.right.size(), row.h = fem::longest_edge(level.mesh);
  const linear::CgOutcome solution =
      linear::preconditioned_cg(level.system.matrix, hierarchy.levels().multigrid(number),
                                level.system.right, {.relative_residual = solved});
  row.status = to_string(solution.status), row.iterations = solution.iterations;
  if (solution.status != linear::IterationStatus::converged) {
    row.detail = "conjugate gradients did not reach the residual";
    return;
  }
  const std::vector<double> nodal = hierarchy.nodal(level, solution.x);
  if (model.value) {
    const fem::FieldErrors errors =
        fem::field_errors(level.mesh, nodal, model.value, model.gradient);
    row.l2 = errors.l2, row.h1 = errors.h1, row.maximum = errors.maximum;
  }
  if (!std::isnan(model.centre_value)) row.centre = centre_error(level, nodal, model.centre_value);
  if (model.pictured && row.divisions == pictured_divisions)
    add_field(model, row.divisions, level.mesh, nodal, result);
}

double error_in(const ElementsRow& row, const std::string& norm) {
  if (norm == "max_by_log") return row.maximum / std::abs(std::log(row.h));
  return norm == "l2" ? row.l2 : norm == "h1" ? row.h1 : norm == "max" ? row.maximum : row.centre;
}

ElementsOrderRow order_of(const ModelProblem& model, const ModelProblem::Claim& claim,
                          const std::vector<ElementsRow>& rows) {
  ElementsOrderRow row;
  row.problem = model.id, row.rule = model.rule->name, row.norm = claim.norm;
  row.claimed_order = claim.order, row.theory = claim.theory;
  std::vector<judge::ErrorPoint> points;
  for (const ElementsRow& each : rows) {
    row.finest = error_in(each, claim.norm);
    points.push_back({.step = each.h,
                      .error = row.finest,
                      .steps = static_cast<double>(each.divisions),
                      .rounding_unit = std::numeric_limits<double>::epsilon() * model.scale,
                      .scale = model.scale});
  }
  row.fit = judge::fit_order(points, claim.order, judge::fixed_step_tolerance(claim.order));
  // The judge's own sentence looks for reasons in a run over time.
  if (row.fit.verdict == judge::Verdict::floors)
    row.fit.reason = fmt::format("the error stops falling at {:.2g}, from h = {:.2g} on",
                                 row.fit.floor, row.fit.floor_step);
  return row;
}

ElementsResult converge(const ModelProblem& model, std::size_t most) {
  ElementsResult result;
  const Hierarchy hierarchy(model, most);
  for (std::size_t number = 0; number < hierarchy.levels().size(); ++number) {
    if (interrupted) throw Interrupted();
    if (hierarchy.divisions(number) >= fewest_divisions) add_mesh(model, hierarchy, number, result);
  }
  for (const ModelProblem::Claim& claim : model.claims)
    result.orders.push_back(order_of(model, claim, result.meshes));
  return result;
}

}  // namespace

ElementsResult measure_orders(std::size_t most, const Runner& runner,
                              const std::vector<std::string>& cases) {
  std::vector<ModelProblem> selected = model_problems();
  std::erase_if(selected,
                [&](const ModelProblem& model) { return !any_glob_matches(cases, model.id); });
  return runner.run(
      "elements", selected,
      [&](const ModelProblem& model) { return model.id + ' ' + model.rule->name; },
      [&](const ModelProblem& model) { return converge(model, most); });
}

ElementsResult measure_elements(const Options& options, const Runner& runner) {
  const auto most = static_cast<std::size_t>(options.number(elements_divisions));
  std::istringstream words(options.word("problems"));
  const std::vector<std::string> problems(std::istream_iterator<std::string>(words), {});
  ElementsResult result = measure_orders(most, runner, problems);
  if (!problems.empty()) return result;
  record::append(result, measure_solvers(most, runner));
  if (interrupted) throw Interrupted();
  result.times = time_solvers(most);
  return result;
}

}  // namespace odeum::study
