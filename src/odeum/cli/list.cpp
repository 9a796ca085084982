// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/record/table.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/studies/elements/problems.hpp"

namespace odeum::cli {
namespace {

/// A table in three formats.
struct Listing {
  std::vector<std::string> columns;
  std::vector<std::vector<record::Cell>> rows = {};
  std::size_t shown = columns.size();  ///< the table omits the long columns of the other formats
  std::vector<std::vector<double>> stops = {};  ///< of cases, which json gives as numbers
};

Listing list_cases() {
  Listing listing{
      .columns = {"id", "title", "equation", "dimension", "horizon", "tags", "truth", "stops"},
      .shown = 3};
  for (const Case& c : all_cases()) {
    listing.rows.push_back({c.id, c.title, c.equation, std::uint64_t{c.y0.size()}, c.stops.back(),
                            fmt::format("{}", fmt::join(tags_of(c), " ")), c.truth.source,
                            fmt::format("{}", fmt::join(c.stops, " "))});
    listing.stops.push_back(c.stops);
  }
  // Problems in space alone: their dimension is that of the mesh. One has several rules of
  // quadrature.
  for (const study::ModelProblem& model : study::model_problems())
    if (listing.rows.back()[0] != record::Cell(model.id))
      listing.rows.push_back({model.id, model.title, model.equation, "mesh", "none",
                              "elliptic linear finite_elements", model.truth, ""});
  listing.stops.resize(listing.rows.size());
  return listing;
}

Listing list_parameters() {
  Listing listing{{"case", "parameter", "value", "meaning"}};
  for (const Case& c : all_cases())
    for (const Parameter& parameter : c.parameters)
      listing.rows.push_back({c.id, parameter.name, parameter.value, parameter.meaning});
  return listing;
}

std::string modes(const SolverInfo& info) {
  std::string text = info.fixed ? "step" : "";
  if (info.adaptive)
    text += (text.empty() ? "tol" : ", tol") + fmt::format(" ({})", info.controller);
  return text;
}

Listing list_solvers(Session& session, const std::string& problem) {
  Listing listing{.columns = {"id", "family", "order", "settings", "needs", "source"}, .shown = 5};
  std::optional<Entrants> entrants;
  if (!problem.empty()) {
    listing.columns.insert(listing.columns.begin() + 1, "fits");
    entrants = case_before_truth(session, cases::Named(problem), ProblemOptions()).entrants;
  }
  const auto add = [&](const SolverInfo& info, const std::string& unfit) {
    const bool varies = std::isnan(info.order);
    std::vector<record::Cell> row{info.id(),
                                  info.family,
                                  varies ? record::Cell("varies") : record::Cell(info.order),
                                  modes(info),
                                  info.needs.empty() ? "a right-hand side" : info.needs,
                                  info.source};
    if (entrants) row.insert(row.begin() + 1, unfit.empty() ? "yes" : "no: " + unfit);
    listing.rows.push_back(std::move(row));
  };
  if (entrants)
    for (const Entrant& entrant : *entrants) add(entrant.info, entrant.unfit);
  else
    for (const Solver& solver : all_solvers()) add(solver.info, "");
  return listing;
}

// The first comment of a scene's file, on one line, without the licence.
std::string first_comment(std::string_view text) {
  std::string comment;
  while (text.starts_with("#")) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.size() > 2 && line.find("SPDX") == std::string_view::npos)
      comment += (comment.empty() ? "" : " ") + std::string(line.substr(2));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return comment;
}

Listing list_scenes() {
  Listing listing{{"name", "solver", "duration", "particles", "springs", "shows"}};
  for (const cases::SceneText& text : cases::all_scenes()) {
    const scene::Scene scene =
        scene::read_scene(std::string(text.name), std::string(text.text)).scene;
    listing.rows.push_back({std::string(text.name), scene.solver->type, *scene.duration,
                            std::uint64_t{scene.particles.size()},
                            std::uint64_t{scene.springs.size()}, first_comment(text.text)});
  }
  return listing;
}

std::string as_table(const Listing& listing) {
  record::Table table;
  for (std::size_t k = 0; k < listing.shown; ++k) table.columns.push_back({listing.columns[k]});
  for (const auto& row : listing.rows) {
    table.rows.emplace_back();
    for (std::size_t k = 0; k < listing.shown; ++k)
      table.rows.back().push_back(record::cell_text(row[k]));
  }
  return table.text();
}

/// Numbers as numbers; where a number is to be and a word stands in its place, null.
std::string as_json(const Listing& listing) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < listing.rows.size(); ++i) {
    nlohmann::ordered_json object;
    for (std::size_t k = 0; k < listing.columns.size(); ++k) {
      const std::string& column = listing.columns[k];
      std::visit([&](const auto& value) { object[column] = value; }, listing.rows[i][k]);
      const bool is_number = column == "order" || column == "dimension" || column == "horizon";
      if (is_number && object[column].is_string()) object[column] = nullptr;
    }
    if (!listing.stops.empty()) object["stops"] = listing.stops[i];
    array.push_back(std::move(object));
  }
  return array.dump(2) + "\n";
}

}  // namespace

void add_list(CLI::App& app, Session& session) {
  struct Options {
    std::string what = "cases", problem;
    std::string format = "table";
    bool parameters = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("list", "the cases, the solvers, or the scenes");
  command->add_option("what", options->what, "cases, solvers or scenes")
      ->check(CLI::IsMember({"cases", "solvers", "scenes"}));
  command
      ->add_option("problem", options->problem,
                   "of solvers: which of them fit this case, scene, problem's file or FMU, and why "
                   "others do not")
      ->type_name("CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu");
  add_format(*command, options->format);
  command->add_flag("--parameters", options->parameters,
                    "the parameters of cases, which odeum run --set changes");
  command->callback([options, &session] {
    if (options->parameters && options->what != "cases")
      throw UsageError(
          "--parameters: only cases have parameters; use odeum list cases --parameters");
    if (!options->problem.empty() && options->what != "solvers")
      throw UsageError("list {}: got {}, expected a problem after odeum list solvers only",
                       options->what, options->problem);
    const Listing listing = options->parameters         ? list_parameters()
                            : options->what == "cases"  ? list_cases()
                            : options->what == "scenes" ? list_scenes()
                                                        : list_solvers(session, options->problem);
    print(options->format == "csv"    ? record::Records{listing.columns, listing.rows}.csv()
          : options->format == "json" ? as_json(listing)
                                      : as_table(listing));
  });
}

}  // namespace odeum::cli
