// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace odeum::report {

bool CaseFacts::has_tag(const std::string& tag) const {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

void describe(ReportData& data, const std::vector<Case>& cases,
              const std::vector<LibraryInfo>& libraries) {
  std::set<std::string> known;
  for (const Case& c : cases) {
    double scale = 0;
    for (const double value : c.y0) scale = std::max(scale, std::abs(value));
    data.cases.push_back({.id = c.id,
                          .title = c.title,
                          .equation = c.equation,
                          .source = c.source,
                          .truth = c.truth.source,
                          .truth_floor = c.truth.floor,
                          .timed_floor = c.timed_floor(),
                          .timed_end = c.timed_stops().empty() ? c.t0 : c.timed_stops().back(),
                          .scale = scale > 0 ? scale : 1,
                          .tags = c.tags});
    for (const Entrant& entrant : c.entrants)
      if (known.insert(entrant.info.id()).second) data.solvers.push_back(entrant.info);
  }
  data.libraries = libraries;
}

std::vector<std::string> library_names(const ReportData& data) {
  std::vector<std::string> names;
  for (const SolverInfo& solver : data.solvers)
    if (std::find(names.begin(), names.end(), solver.library) == names.end())
      names.push_back(solver.library);
  return names;
}

std::string library_version(const ReportData& data, const std::string& library) {
  for (const LibraryInfo& info : data.libraries)
    if (std::find(info.libraries.begin(), info.libraries.end(), library) != info.libraries.end())
      return info.version;
  return {};
}

}  // namespace odeum::report
