// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "odeum/cli/session.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/fem/field_files.hpp"
#include "odeum/fem/gmsh_reader.hpp"
#include "odeum/fem/hierarchy.hpp"
#include "odeum/fem/plane_function.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/formula/parser.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/report/report.hpp"
#include "odeum/trajectories/run_page.hpp"

namespace odeum::cli {
namespace {

using fem::Point;

struct PoissonOptions {
  std::string mesh, load = "1", value = "0", flux, exact, out;
  std::vector<std::string> a, on;
  bool mean_zero = false;
  std::size_t refine = 0;
  double tolerance = 1e-10;
};

/// The boundary edges where u is given, by their middles, which determine them.
using Middles = std::set<std::pair<double, double>>;

fem::GmshMesh read_mesh(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string shape = name.substr(0, colon);
  if (shape != "square" && shape != "l_shape" && shape != "disc") return fem::read_gmsh_file(name);
  std::size_t n = 16;
  if (colon != std::string::npos) {
    const char* const end = name.data() + name.size();
    if (const auto read = std::from_chars(name.data() + colon + 1, end, n);
        read.ptr != end || read.ec != std::errc() || n < 1 || n > 4096)
      throw UsageError("the mesh {}: expected {}:N with N from 1 to 4096", name, shape);
  }
  fem::GmshMesh mesh;
  mesh.mesh = shape == "square"    ? fem::unit_square(n)
              : shape == "l_shape" ? fem::l_shape(n)
                                   : fem::polygon(6);
  for (std::size_t divisions = 1; shape == "disc" && 2 * divisions <= n; divisions *= 2)
    mesh.mesh = fem::refined(mesh.mesh, fem::onto_unit_circle).mesh;
  return mesh;
}

fem::PlaneFunction read_function(const std::string& option, const std::string& text) {
  try {
    return fem::PlaneFunction(text);
  } catch (const formula::ExpressionError& error) {
    throw UsageError("--{}, character {}: {}", option, error.at() + 1, error.what());
  }
}

std::pair<double, double> key_of(const fem::TriangleMesh& mesh,
                                 const std::array<std::size_t, 2>& edge) {
  const Point p = fem::middle(mesh.nodes[edge[0]], mesh.nodes[edge[1]]);
  return {p.x, p.y};
}

Middles given_edges(const fem::GmshMesh& mesh, const std::vector<std::string>& on) {
  const bool everywhere = on.empty(), nowhere = on == std::vector<std::string>{"none"};
  for (const std::string& group : on)
    if (!nowhere && std::ranges::find(mesh.groups, group) == mesh.groups.end())
      throw UsageError(
          "--on {}: the mesh has no physical group of curves of that name; it has {}, and none "
          "means nowhere{}",
          group, mesh.groups.empty() ? "none" : fmt::format("{}", fmt::join(mesh.groups, ", ")),
          did_you_mean(group, mesh.groups));
  Middles middles;
  for (const auto& edge : fem::boundary_edges(mesh.mesh))
    if (everywhere || std::ranges::any_of(
                          on, [&](const std::string& group) { return mesh.in_group(edge, group); }))
      middles.insert(key_of(mesh.mesh, edge));
  return middles;
}

/// The halves of the edges in `coarse`.
Middles halves(const Middles& coarse, const fem::TriangleMesh& mesh, const fem::Refined& fine) {
  Middles middles;
  for (const auto& edge : fem::boundary_edges(fine.mesh)) {
    std::array<std::size_t, 2> parent{};
    for (const std::size_t node : edge)
      if (fine.parents[node][0] != fine.parents[node][1]) parent = fine.parents[node];
    if (coarse.contains(key_of(mesh, parent))) middles.insert(key_of(fine.mesh, edge));
  }
  return middles;
}

fem::EllipticProblem make_problem(const PoissonOptions& given) {
  fem::EllipticProblem problem;
  problem.load = read_function("load", given.load);
  if (given.a.size() == 1) {
    problem.diffusion = [a = read_function("a", given.a[0])](Point p) {
      const double k = a(p);
      return fem::Tensor{k, 0, k};
    };
  } else if (given.a.size() == 3) {
    problem.diffusion = [xx = read_function("a", given.a[0]), xy = read_function("a", given.a[1]),
                         yy = read_function("a", given.a[2])](Point p) {
      return fem::Tensor{xx(p), xy(p), yy(p)};
    };
  } else if (!given.a.empty()) {
    throw UsageError("--a: expected one expression, or three: a_xx a_xy a_yy");
  }
  problem.boundary_value = read_function("value", given.value);
  if (!given.flux.empty())
    problem.flux = [flux = read_function("flux", given.flux)](Point p, Point) { return flux(p); };
  return problem;
}

/// Solves on one mesh and prints its line.
class Solution {
 public:
  explicit Solution(const PoissonOptions& given) : given_(given) {
    if (!given.exact.empty()) exact_.emplace(read_function("exact", given.exact));
    print("{:>10} {:>10} {:>10} {:>10} {:>10}{}\n", "triangles", "unknowns", "h", "iterations",
          "residual", exact_ ? "      L2 error      H1 error     max error  order L2, H1" : "");
  }

  void add(const fem::Levels& levels) {
    const auto& level = levels.finest();
    const linear::Multigrid m = levels.multigrid(levels.size() - 1);
    const auto run = linear::preconditioned_cg(level.system.matrix, m, level.system.right,
                                               {.relative_residual = given_.tolerance});
    if (run.status != linear::IterationStatus::converged)
      throw std::runtime_error(
          fmt::format("conjugate gradients ended {} at a residual of {:.1e} after {} iterations",
                      to_string(run.status), run.residuals.back(), run.iterations));
    nodal_ = given_.mean_zero ? fem::nodal_of_mean_zero(level.mesh, level.system, run.x)
                              : level.system.nodal(run.x);
    const double h = fem::longest_edge(level.mesh);
    std::string line =
        fmt::format("{:>10} {:>10} {:>10.3g} {:>10} {:>10.1e}", level.mesh.triangles.size(),
                    level.system.right.size(), h, run.iterations, run.residuals.back());
    if (exact_) {
      const fem::FieldErrors errors = fem::field_errors(
          level.mesh, nodal_, *exact_, [&](Point p) { return exact_->gradient(p); });
      line += fmt::format(" {:>13.4e} {:>13.4e} {:>13.4e}", errors.l2, errors.h1, errors.maximum);
      if (before_h_ > 0)
        line += fmt::format("  {:.2f}, {:.2f}",
                            std::log(before_.l2 / errors.l2) / std::log(before_h_ / h),
                            std::log(before_.h1 / errors.h1) / std::log(before_h_ / h));
      before_ = errors, before_h_ = h;
    }
    print(line + '\n');
    if (level.system.imbalance != 0)
      remark("load and flux add up to {:.2g} of their size, which was subtracted",
             level.system.imbalance);
  }

  /// The solution, and its error where that is known.
  std::vector<fem::NodalField> fields(const fem::TriangleMesh& mesh) const {
    std::vector<fem::NodalField> fields{{"u", nodal_}};
    if (exact_) {
      fields.push_back({"error", nodal_});
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        fields.back().values[i] -= (*exact_)(mesh.nodes[i]);
    }
    return fields;
  }
  std::string summary() const {
    const auto [low, high] = std::ranges::minmax_element(nodal_);
    return fmt::format("u lies between {:.6g} and {:.6g} at the nodes", *low, *high);
  }

 private:
  const PoissonOptions& given_;
  std::optional<fem::PlaneFunction> exact_;
  std::vector<double> nodal_;
  fem::FieldErrors before_;
  double before_h_ = 0;
};

trajectories::RunTexts page_texts(const PoissonOptions& given, const std::string& mesh,
                                  const std::string& summary) {
  return {.title = "-div(a grad u) = " + given.load,
          .lead = "",
          .facts = {{"mesh", mesh},
                    {"a", given.a.empty() ? "1" : fmt::format("{}", fmt::join(given.a, ", "))},
                    {"solution", summary}}};
}

void solve(const PoissonOptions& given) {
  const fem::GmshMesh coarse = read_mesh(given.mesh);
  std::optional<record::OutputFolder> out;
  if (!given.out.empty()) out.emplace(given.out);
  auto middles = std::make_shared<Middles>(given_edges(coarse, given.on));
  fem::EllipticProblem problem = make_problem(given);
  if (given.mean_zero && !middles->empty())
    throw UsageError("--mean-zero: u is given on the boundary, which determines it; add --on none");
  problem.is_dirichlet = [middles](Point p) { return middles->contains({p.x, p.y}); };
  const auto undetermined =
      given.mean_zero ? fem::Undetermined::mean_zero : fem::Undetermined::refuse;
  fem::Levels levels(problem, fem::degree_5_rule(), undetermined);
  Solution solution(given);
  levels.add(coarse.mesh);
  solution.add(levels);
  for (std::size_t k = 0; k < given.refine; ++k) {
    if (interrupted) throw Interrupted();
    fem::Refined finer = fem::refined(levels.finest().mesh);
    *middles = halves(*middles, levels.finest().mesh, finer);
    levels.add(std::move(finer));
    solution.add(levels);
  }
  print(solution.summary() + '\n');
  if (!out) return;
  const record::OutputFolder& folder = *out;
  const fem::TriangleMesh& mesh = levels.finest().mesh;
  const std::vector<fem::NodalField> fields = solution.fields(mesh);
  // A browser shows no more triangles at once.
  const bool drawn = mesh.triangles.size() <= 20'000;
  const trajectories::RunTexts texts =
      page_texts(given,
                 fmt::format("{}, {} triangles{}", given.mesh, mesh.triangles.size(),
                             drawn ? "" : ", too many to draw"),
                 solution.summary());
  folder.write("solution.vtk", fem::vtk_of(mesh, texts.title, fields));
  const record::Records triangles = fem::triangle_rows(drawn ? mesh : fem::TriangleMesh(), fields);
  report::Report page({}, folder);
  page.table("runs", "triangles", triangles);
  page.fact("runs", trajectories::page_facts("field", texts));
  const bool written = page.write({.command_line = "odeum poisson " + given.mesh});
  remark_on_page(written);
  remark("{}solution.vtk {} in {}", written ? "index.html, " : "", written ? "are" : "is",
         given.out);
}

}  // namespace

void add_poisson(CLI::App& app) {
  const auto given = std::make_shared<PoissonOptions>();
  CLI::App* command = app.add_subcommand(
      "poisson", "solves -div(a grad u) = f by linear finite elements on a mesh");
  add_option(*command, "mesh MESH", given->mesh,
             "a Gmsh file (format 4.1, ASCII), or square:N, l_shape:N or disc:N")
      ->required();
  add_option(*command, "--load", given->load, "f, an expression in x and y; default: {}");
  command->add_option("--a", given->a, "a, one expression or three: a_xx a_xy a_yy; default: 1")
      ->expected(1, 3);
  command->add_option("--on", given->on,
                      "physical groups of the mesh's curves where u is given; none: nowhere; "
                      "default: on the whole boundary");
  add_option(*command, "--value", given->value, "u there; default: {}");
  add_option(*command, "--flux", given->flux, "n . a grad u on the rest; default: {}");
  command->add_flag("--mean-zero", given->mean_zero,
                    "where u is given nowhere: the solution of mean 0");
  command->add_option("--exact", given->exact, "the exact solution, to measure errors");
  add_option(*command, "--refine", given->refine, "times that the mesh is refined; default: {}")
      ->check(CLI::Range(0, 10));
  add_option(*command, "--tolerance", given->tolerance, "of the residual; default: {}")
      ->check(CLI::Range(1e-15, 1.0));
  add_option(*command, "--out DIR", given->out, "folder for solution.vtk and a page that draws it");
  command->callback([given] {
    try {
      solve(*given);
    } catch (const fem::MeshError& error) {
      throw UsageError("the mesh: {}", error.what());
    } catch (const fem::ProblemError& error) {
      throw UsageError(error.what());
    }
  });
}

}  // namespace odeum::cli
