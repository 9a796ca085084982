// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/facts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/cases/spectrum.hpp"

namespace odeum::report {

bool CaseFacts::has_tag(const std::string& tag) const {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

std::vector<std::string> Facts::library_names() const {
  std::vector<std::string> names;
  for (const SolverInfo& solver : solvers)
    if (std::find(names.begin(), names.end(), solver.library) == names.end())
      names.push_back(solver.library);
  return names;
}

std::string Facts::library_version(const std::string& library) const {
  for (const LibraryInfo& info : libraries)
    if (std::find(info.libraries.begin(), info.libraries.end(), library) != info.libraries.end())
      return info.version;
  return {};
}

Facts describe(const std::vector<Case>& cases, const std::vector<LibraryInfo>& libraries) {
  Facts facts{.cases = {}, .solvers = {}, .libraries = libraries};
  std::set<std::string> known;
  for (const Case& c : cases) {
    double scale = 0;
    for (const double value : c.y0) scale = std::max(scale, std::abs(value));
    Spectrum spectrum = spectrum_of(c);
    facts.cases.push_back({.id = c.id,
                           .title = c.title,
                           .equation = c.equation,
                           .source = c.source,
                           .truth = c.truth.source,
                           .truth_floor = c.truth.floor,
                           .timed_floor = c.timed_floor(),
                           .timed_end = c.timed_stops().empty() ? c.t0 : c.timed_stops().back(),
                           .scale = scale > 0 ? scale : 1,
                           .tags = c.tags,
                           .eigenvalues = std::move(spectrum.eigenvalues),
                           .eigenvalues_time = spectrum.time});
    for (const Entrant& entrant : c.entrants)
      if (known.insert(entrant.info.id()).second) facts.solvers.push_back(entrant.info);
  }
  return facts;
}

std::string file_stem(std::string_view text) {
  std::string stem;
  for (const char c : text.substr(0, 80)) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_';
    stem += kept ? c : '_';
  }
  return stem.empty() ? "_" : stem;
}

}  // namespace odeum::report
