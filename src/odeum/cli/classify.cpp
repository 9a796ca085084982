// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "odeum/cli/classify.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/fem/second_order_pde.hpp"
#include "odeum/formula/parser.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/report/report.hpp"
#include "odeum/trajectories/run_page.hpp"

namespace odeum::cli {
namespace {

using fem::PdePoint;
using fem::PdeType;

struct ClassifyOptions {
  std::vector<std::string> pde;
  std::vector<double> at, region{-1, 1, -1, 1};
  std::size_t divisions = 120;
  std::string out;
  std::vector<std::string> solvers;  ///< of a linear problem
  std::optional<double> step;
  ProblemOptions problems;
};

/// Whether the arguments are an equation, not a problem: those have signs in them that names of
/// cases and files have not.
bool is_pde(const std::vector<std::string>& words) {
  return words.size() != 1 || (!cases::kind_of(cases::Named(words[0])) &&
                               (words[0].find_first_of("+=*/ (") != std::string::npos ||
                                words[0].starts_with("u_") || words[0] == "u"));
}

fem::SecondOrderPde read_pde(const std::vector<std::string>& pde) {
  try {
    if (pde.size() == 1) return fem::SecondOrderPde(pde[0]);
    if (pde.size() == 3) return fem::SecondOrderPde(pde[0], pde[1], pde[2]);
  } catch (const formula::ExpressionError& error) {
    throw UsageError("the equation, character {}: {}", error.at() + 1, error.what());
  }
  throw UsageError(
      "got {} arguments, expected an equation in quotes ('y*u_xx + u_yy = 0'), or three "
      "coefficients of u_xx, u_xy and u_yy",
      pde.size());
}

/// The slope dy/dx of a direction.
std::string slope(const std::array<double, 2>& direction, const std::string& second) {
  if (direction[0] == 0) return "x = constant";
  return fmt::format("d{}/dx = {:.6g}", second, direction[1] / direction[0] + 0.);
}

std::string characteristics(const PdePoint& point, const std::string& second) {
  std::string text;
  for (const auto& direction : point.characteristics)
    text += (text.empty() ? "" : ", ") + slope(direction, second);
  return text.empty() ? "none" : text;
}

std::string describe(const PdePoint& point, const std::string& second) {
  std::string text = fmt::format(
      "type             {}\ncoefficients     {:.6Lg} u_xx, {:.6Lg} u_x{}, {:.6Lg} u_{}{}\n"
      "discriminant     b^2 - 4 a c = {:.6Lg}\ncharacteristics  {}\n",
      to_string(point.type), point.a, point.b, second, point.c, second, second,
      point.discriminant + 0.L, characteristics(point, second));
  if (point.degenerate)
    text +=
        "degenerate       no first derivative along the characteristic: an ordinary differential "
        "equation on lines\n";
  if (point.type == PdeType::first_order)
    text += "                 the second derivatives have coefficients of 0 here\n";
  if (point.type == PdeType::undefined)
    text += "                 a coefficient is not finite here\n";
  return text;
}

/// A letter for each point, the highest second variable first.
std::string letters(const fem::PdeMap& map) {
  constexpr std::size_t columns = 60, rows = 20;
  std::string text;
  for (std::size_t row = 0; row <= rows; ++row) {
    text += "  ";
    for (std::size_t column = 0; column <= columns; ++column) {
      const PdeType type =
          map.point(column * map.divisions / columns, (rows - row) * map.divisions / rows).type;
      text += type == PdeType::undefined     ? '?'
              : type == PdeType::first_order ? '1'
                                             : to_string(type)[0];
    }
    text += '\n';
  }
  return text;
}

constexpr PdeType all_types[] = {PdeType::elliptic, PdeType::parabolic, PdeType::hyperbolic,
                                 PdeType::first_order, PdeType::undefined};

std::string describe(const fem::PdeMap& map) {
  std::string text = fmt::format("over [{:g}, {:g}] x [{:g}, {:g}], {} points\n", map.region.x0,
                                 map.region.x1, map.region.y0, map.region.y1, map.points.size());
  for (const PdeType type : all_types)
    if (map.share(type) > 0)
      text += fmt::format("  {:<12} {:.1f} %\n", to_string(type), 100 * map.share(type));
  text += letters(map);
  if (map.changes.empty())
    return text + (map.share(map.points[0].type) == 1
                       ? "the type does not change\n"
                       : "no curve with a discriminant of 0 was found between the types\n");
  text += fmt::format("the type changes at {} points of the grid's lines, among them",
                      map.changes.size());
  const std::size_t stride = std::max<std::size_t>(1, map.changes.size() / 4);
  for (std::size_t i = stride / 2, shown = 0; i < map.changes.size() && shown < 4;
       i += stride, ++shown)
    text += fmt::format("{} ({:.6g}, {:.6g})", shown ? "," : "", map.changes[i][0] + 0.,
                        map.changes[i][1] + 0.);
  return text + '\n';
}

std::string csv_of(const fem::PdeMap& map, const std::string& second) {
  record::Records table{{"x", second, "type", "discriminant", "dx_1", "d" + second + "_1", "dx_2",
                         "d" + second + "_2"}};
  for (std::size_t j = 0; j <= map.divisions; ++j)
    for (std::size_t i = 0; i <= map.divisions; ++i) {
      const PdePoint& point = map.point(i, j);
      const auto place = map.place(i, j);
      auto& row = table.rows.emplace_back();
      row = {place[0], place[1], to_string(point.type), static_cast<double>(point.discriminant)};
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t d = 0; d < 2; ++d)
          row.emplace_back(k < point.characteristics.size() ? point.characteristics[k][d] : nan);
    }
  return table.csv();
}

/// Rectangles of one type: cells of the type of their lower left node, joined along a row.
record::Records regions_of(const fem::PdeMap& map) {
  record::Records table{{"x0", "x1", "y0", "y1", "type"}};
  for (std::size_t j = 0; j < map.divisions; ++j)
    for (std::size_t i = 0, end = 0; i < map.divisions; i = end) {
      const PdeType type = map.point(i, j).type;
      while (end < map.divisions && map.point(end, j).type == type) ++end;
      const auto low = map.place(i, j), high = map.place(end, j + 1);
      table.rows.push_back({low[0], high[0], low[1], high[1], to_string(type)});
    }
  return table;
}

/// Characteristic directions at some points.
record::Records directions_of(const fem::PdeMap& map) {
  record::Records table{{"x", "y", "dx", "dy"}};
  const std::size_t stride = std::max<std::size_t>(1, map.divisions / 24);
  for (std::size_t j = stride / 2; j <= map.divisions; j += stride)
    for (std::size_t i = stride / 2; i <= map.divisions; i += stride)
      for (const auto& direction : map.point(i, j).characteristics) {
        const auto [x, y] = map.place(i, j);
        table.rows.push_back({x, y, direction[0], direction[1]});
      }
  return table;
}

record::Records changes_of(const fem::PdeMap& map) {
  record::Records table{{"x", "y"}};
  for (const auto& [x, y] : map.changes) table.rows.push_back({x, y});
  return table;
}

bool write_page(const record::OutputFolder& folder, const fem::PdeMap& map,
                const std::string& equation, const std::string& second) {
  const fem::PdeRegion& r = map.region;
  trajectories::RunTexts texts{
      .title = equation,
      .lead = "",
      .facts = {{"region", fmt::format("x from {:g} to {:g}, {} from {:g} to {:g}, {} points", r.x0,
                                       r.x1, second, r.y0, r.y1, map.points.size())}}};
  for (const PdeType type : all_types)
    if (map.share(type) > 0)
      texts.facts.emplace_back(to_string(type), fmt::format("{:.1f} %", 100 * map.share(type)));
  if (!map.changes.empty())
    texts.facts.emplace_back("change of type",
                             fmt::format("at {} points of the grid's lines", map.changes.size()));
  report::Report page({}, folder);
  const record::Records regions = regions_of(map), directions = directions_of(map),
                        changes = changes_of(map);
  page.table("runs", "types", regions);
  page.table("runs", "characteristics", directions);
  page.table("runs", "type_changes", changes);
  auto json = trajectories::page_facts("types", texts);
  json["second"] = second;
  json["region"] = {r.x0, r.x1, r.y0, r.y1};
  page.fact("runs", json);
  return page.write({.command_line = "odeum classify " + equation});
}

void classify(Session& session, const ClassifyOptions& given) {
  if (!is_pde(given.pde)) {
    if (given.step) require_positive("--step", *given.step);
    classify_linear(case_of(session, given.pde[0], given.problems), given.solvers, given.step);
    return;
  }
  if (!given.solvers.empty() || given.step)
    throw UsageError("--solver and --step: for a linear problem u' = A u + b, not for {}",
                     given.pde[0]);
  const fem::SecondOrderPde pde = read_pde(given.pde);
  if (!given.at.empty() && given.at.size() != 2)
    throw UsageError("--at: expected two numbers, X Y");
  if (!given.at.empty() || pde.constant()) {
    const std::vector<double> at = given.at.empty() ? std::vector{0., 0.} : given.at;
    print(describe(pde.at(at[0], at[1]), pde.second()));
  }
  if ((!given.at.empty() || pde.constant()) && given.out.empty()) return;
  std::optional<record::OutputFolder> folder;
  if (!given.out.empty()) folder.emplace(given.out);
  fem::PdeMap map;
  try {
    const auto& r = given.region;
    map = fem::map_types(pde, {r[0], r[1], r[2], r[3]}, given.divisions);
  } catch (const std::invalid_argument& error) {
    throw UsageError("--region: {}", error.what());
  }
  print(describe(map));
  if (!folder) return;
  const std::string title = given.pde.size() == 1
                                ? given.pde[0]
                                : fmt::format("({}) u_xx + ({}) u_xy + ({}) u_yy", given.pde[0],
                                              given.pde[1], given.pde[2]);
  folder->write("classify.csv", csv_of(map, pde.second()));
  const bool page = write_page(*folder, map, title, pde.second());
  remark_on_page(page);
  remark("{}classify.csv {} in {}", page ? "index.html, " : "", page ? "are" : "is", given.out);
}

}  // namespace

void add_classify(CLI::App& app, Session& session) {
  const auto given = std::make_shared<ClassifyOptions>();
  CLI::App* command = app.add_subcommand(
      "classify",
      "the type of a second-order partial differential equation, and where it changes; of a linear "
      "problem its matrix, eigenvalues, solution, and the matrix of one step");
  command
      ->add_option("pde", given->pde,
                   "an equation in u_xx, u_xy, u_yy, u_x, u_y, u, x and y (or t in place of y), or "
                   "the coefficients of u_xx, u_xy and u_yy: expressions in x and y; or a linear "
                   "problem of up to 8 unknowns: a case or a problem's file")
      ->required()
      ->expected(1, 3);
  add_option(*command, "--at X Y", given->at, "the type at one point")->expected(2);
  add_option(*command, "--region X0 X1 Y0 Y1", given->region,
             fmt::format("where the type is mapped; default: {}", fmt::join(given->region, " ")))
      ->expected(4);
  add_option(*command, "--divisions N", given->divisions, "of the map, each way; default: {}")
      ->check(CLI::Range(1, 2000));
  add_option(*command, "--out DIR", given->out,
             "folder for a table of the map and a page that draws it");
  add_option(*command, "--solver ID", given->solvers, "of a linear problem: the matrix of one step")
      ->allow_extra_args(false);
  add_option(*command, "--step H", given->step, "of these solvers");
  add_problem_options(*command, given->problems, false);
  command->callback([given, &session] { classify(session, *given); });
}

}  // namespace odeum::cli
