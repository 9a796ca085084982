// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "odeum/report/html.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::study {

double Options::number(const std::string& name, double otherwise) const {
  const auto found = own.find(name);
  return found == own.end() ? otherwise : record::number_of(found->second);
}

std::string Options::word(const std::string& name) const {
  const auto found = own.find(name);
  return found == own.end() ? "" : found->second;
}

std::string Options::text() const { return fmt::format("{} {} {} {}", cases, solvers, quick, own); }

std::string origin_text(const Origin& origin, bool empty) {
  std::string html;
  if (!origin.problem.empty())
    html = fmt::format("<p class=\"missing\">{}</p>\n", report::escape(origin.problem));
  const std::string how =
      fmt::format("<code>odeum {}</code> with this folder as <code>--out</code>", origin.command);
  if (empty)
    return html + "<p>Not measured in this run: " + how +
           " measures it, and the next report shows it.</p>\n";
  if (!origin.measured)
    return html +
           "<p>Not measured in this run: these are results of an earlier one, which the folder "
           "held.</p>\n";
  if (!origin.selection.empty())
    html += fmt::format(
        "<p>To keep a report short, it runs a selection: {}. {} runs every pair, and the next "
        "report shows those too.</p>\n",
        report::escape(origin.selection), how);
  return html;
}

Origin Study::origin() const {
  std::string selection;
  for (const Options& run : ran_) {
    if (run.cases.empty() && run.solvers.empty()) continue;
    selection += selection.empty() ? "" : "; ";
    selection += run.solvers.empty() ? "every solver"
                                     : fmt::format("solvers {}", fmt::join(run.solvers, ", "));
    selection +=
        run.cases.empty() ? " on every case" : fmt::format(" on {}", fmt::join(run.cases, ", "));
  }
  return {.command = declaration_.name,
          .place = declaration_.place,
          .problem = problem_,
          .measured = measured(),
          .selection = selection};
}

bool is_known(const std::string& case_id, const std::string& solver) {
  static const std::set<record::detail::Group> known = [] {
    std::set<record::detail::Group> all{{"", ""}};
    for (const Case* c : known_cases()) {
      all.insert({c->id, ""});
      for (const Entrant& entrant : c->entrants) {
        all.insert({c->id, entrant.info.id()});
        all.insert({"", entrant.info.id()});
      }
    }
    return all;
  }();
  return known.contains({case_id, solver});
}

}  // namespace odeum::study
