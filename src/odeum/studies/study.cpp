// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "odeum/cases/catalogue.hpp"

namespace odeum::study {

double Options::number(const std::string& name, double otherwise) const {
  const auto found = own.find(name);
  return found == own.end() ? otherwise : record::number_of(found->second);
}

double Options::number(const Option& option) const {
  return number(option.name, option.otherwise.value());
}

std::string Options::word(const std::string& name) const {
  const auto found = own.find(name);
  return found == own.end() ? "" : found->second;
}

std::string Options::text() const { return fmt::format("{} {} {} {}", cases, solvers, quick, own); }

report::StudyFacts Study::facts() const {
  std::string selection;
  for (const Options& run : ran_) {
    if (run.cases.empty() && run.solvers.empty()) continue;
    selection += selection.empty() ? "" : "; ";
    selection += run.solvers.empty() ? "every solver"
                                     : fmt::format("solvers {}", fmt::join(run.solvers, ", "));
    selection +=
        run.cases.empty() ? " on every case" : fmt::format(" on {}", fmt::join(run.cases, ", "));
  }
  return {.name = folder(),
          .command = declaration_.name,
          .help = declaration_.help,
          .place = declaration_.place,
          .figures = declaration_.figures,
          .problem = problem_,
          .selection = selection,
          .measured = measured()};
}

bool is_known(const std::string& case_id, const std::string& solver) {
  static const std::set<std::string> solvers = [] {
    std::set<std::string> all{""};
    for (const Solver& each : all_solvers()) all.insert(each.info.id());
    return all;
  }();
  static const std::set<std::string> cases = [] {
    std::set<std::string> all{""};
    for (const std::string& id : known_ids()) all.insert(id);
    return all;
  }();
  return cases.contains(case_id) && solvers.contains(solver);
}

}  // namespace odeum::study
