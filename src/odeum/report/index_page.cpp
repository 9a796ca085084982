// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "odeum/core/machine.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"

namespace odeum::report {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json json_of(const CaseFacts& c, bool has_data) {
  ordered_json eigenvalues = ordered_json::array();
  for (const auto& z : c.eigenvalues) eigenvalues.push_back({z.real(), z.imag()});
  return {{"id", plain(c.id)},
          {"title", plain(c.title)},
          {"equation", plain(c.equation)},
          {"tags", c.tags},
          {"floor", number(c.truth_floor)},
          {"timed_floor", number(c.timed_floor)},
          {"end", number(c.timed_end)},
          {"scale", number(c.scale)},
          {"unit", c.has_tag("mechanical") ? "s" : ""},
          {"page", as_address(c.file)},
          {"data", has_data ? data_name(c) : ""},
          {"eigenvalues", eigenvalues},
          {"eigenvalues_time", number(c.eigenvalues_time)}};
}

ordered_json json_of(const SolverInfo& solver) {
  return {{"library", plain(solver.library)},
          {"method", plain(solver.method)},
          {"family", plain(solver.family)},
          {"order", number(solver.order)},
          {"fixed", solver.fixed},
          {"adaptive", solver.adaptive},
          {"needs", plain(solver.needs)},
          {"source", plain(solver.source)}};
}

std::string view(const char* id, const char* title, const char* text) {
  return fmt::format(
      "<section id=\"{0}\" class=\"view\" aria-labelledby=\"{0}-title\">\n<h2 "
      "id=\"{0}-title\">{1}</h2>\n"
      "<p class=\"lead\">{2}</p>\n<div data-view=\"{0}\"></div>\n</section>\n",
      id, title, text);
}

}  // namespace

void Page::write_all_data(const RunFacts& run) const {
  ordered_json cases = ordered_json::array(), solvers = ordered_json::array();
  for (std::size_t i = 0; i < facts_.cases.size(); ++i)
    cases.push_back(json_of(facts_.cases[i], !case_data_[i].empty()));
  for (const SolverInfo& solver : facts_.solvers) solvers.push_back(json_of(solver));
  const auto text = [](const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  };
  std::map<std::string, Data> files = data_;
  Data& data = files["index"];
  data["cases"] = text(cases);
  data["solvers"] = text(solvers);
  data["libraries"] = text(facts_.library_names());
  data["run"] = text({{"quick", run.quick}, {"date", utc_text(run.finished)}});
  for (std::size_t i = 0; i < facts_.cases.size(); ++i)
    if (!case_data_[i].empty()) files[data_name(facts_.cases[i])] = case_data_[i];
  // Compression takes a second or two.
  std::vector<std::pair<std::string, Data>> list(files.begin(), files.end());
  parallel_for(list.size(), std::thread::hardware_concurrency(),
               [&](std::size_t i) { write_data(list[i].first, list[i].second); });
}

std::string Page::index_page(const RunFacts& run) const {
  std::size_t measured = 0;
  for (const Data& data : case_data_) measured += !data.empty();
  std::string about = fmt::format(
      "<p class=\"about\">{} of {} libraries, each on the same problems, judged by the same "
      "independent truth. Times are of this machine (<a href=\"data.html\">run and data</a>).",
      show_count(facts_.solvers.size(), "solver"), facts_.library_names().size());
  if (run.quick)
    about += fmt::format(
        " <strong>A quick report: {} of {}, each measured in full (the cloth without its "
        "orders).</strong> <code>odeum report</code> adds the other cases, the largest stable "
        "steps of stiff cases, "
        "drift over 10,000 steps, order reduction, materials, meshes and proofs.",
        measured, show_count(facts_.cases.size(), "case"));
  return document(
      "Odeum report", navigation("", "index.html"),
      "<noscript><p>The views on this page need scripts. The tables under the other links do "
      "not.</p></noscript>\n" +
          view("answers", "Which integrator?",
               "Choose a problem and the error that you can accept.") +
          about + "</p>\n" +
          view("compare", "Compare",
               "Any solvers of any libraries side by side. Add them by any part of a name, a "
               "family, a library, or an order.") +
          view("regions", "Stability",
               "Where a step of a solver does not grow, and where the eigenvalues of a problem, "
               "times the step, lie.") +
          view("methods", "Methods",
               "What a method is, where it is stable, and how it did on every problem."),
      {"data/index.js", "viewer/page.js"});
}

}  // namespace odeum::report
