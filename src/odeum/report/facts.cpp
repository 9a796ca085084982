// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/facts.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "odeum/cases/linear_form.hpp"
#include "odeum/cases/spectrum.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/core/file_sum.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/report/text.hpp"

namespace odeum::report {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

CaseFacts facts_of(const Case& c) {
  double scale = 0;
  for (std::size_t i = 0; i < c.y0.size(); ++i)
    scale = std::max(scale, std::abs(c.y0[i]) / c.units.of(i, c.y0[i]));
  cases::Spectrum spectrum = cases::spectrum_of(c);
  const auto linear = cases::linear_form(c);
  return {.id = c.id,
          .title = c.title,
          .equation = c.equation,
          .source = c.source,
          .truth = cases::with_proof(c),
          .scaled = !c.units.scale.empty(),
          .unit = c.problem.scene ? "s" : "",
          .truth_floor = c.truth.floor,
          .timed_floor = c.timed_floor(),
          .start = c.t0,
          .timed_end = c.timed_stops().empty() ? c.t0 : c.timed_stops().back(),
          .scale = scale > 0 ? scale : 1,
          .tags = tags_of(c),
          .eigenvalues = std::move(spectrum.eigenvalues),
          .eigenvalues_time = spectrum.time,
          .linear = linear ? cases::facts_of(*linear, c) : odeum::Facts{}};
}

}  // namespace

Facts describe(const std::vector<const Case*>& cases, const std::vector<LibraryInfo>& libraries,
               unsigned jobs) {
  Facts facts{.cases = std::vector<CaseFacts>(cases.size()), .solvers = {}, .libraries = libraries};
  // A truth's proof takes up to seconds.
  parallel_for(cases.size(), jobs, [&](std::size_t k) { facts.cases[k] = facts_of(*cases[k]); });
  std::set<std::string> known;
  for (const Case* each : cases)
    for (const Entrant& entrant : each->entrants)
      if (known.insert(entrant.info.id()).second) facts.solvers.push_back(entrant.info);
  return facts;
}

ordered_json json_of(const CaseFacts& c) {
  ordered_json eigenvalues = ordered_json::array();
  for (const auto& z : c.eigenvalues) eigenvalues.push_back({z.real(), z.imag()});
  ordered_json linear = ordered_json::array();
  for (const auto& [name, text] : c.linear) linear.push_back({name, plain(text)});
  return {{"id", plain(c.id)},
          {"title", plain(c.title)},
          {"equation", plain(c.equation)},
          {"source", plain(c.source)},
          {"truth", plain(c.truth)},
          {"words", plain(c.words.empty() ? c.id : c.words)},
          {"scaled", c.scaled},
          {"tags", c.tags},
          {"floor", number(c.truth_floor)},
          {"timed_floor", number(c.timed_floor)},
          {"start", number(c.start)},
          {"end", number(c.timed_end)},
          {"scale", number(c.scale)},
          {"unit", c.unit},
          {"eigenvalues", eigenvalues},
          {"eigenvalues_time", number(c.eigenvalues_time)},
          {"linear", linear}};
}

ordered_json json_of(const SolverInfo& solver) {
  return {{"library", plain(solver.library)},
          {"method", plain(solver.method)},
          {"family", plain(solver.family)},
          {"order", number(solver.order)},
          {"fixed", solver.fixed},
          {"adaptive", solver.adaptive},
          {"controller", plain(solver.controller)},
          {"needs", plain(solver.needs)},
          {"closed_form", solver.closed_form()},
          {"source", plain(solver.source)}};
}

ordered_json json_of(const std::vector<LibraryInfo>& libraries) {
  ordered_json list = ordered_json::array();
  for (const LibraryInfo& info : libraries) {
    ordered_json entry{{"name", info.name}, {"solvers", info.libraries}, {"built", info.built}};
    entry["version"] = info.built ? ordered_json(info.version) : ordered_json(nullptr);
    if (!info.built) entry["option"] = info.option;
    list.push_back(entry);
  }
  return list;
}

ordered_json facts_of_process() {
  namespace fs = std::filesystem;
  std::error_code none;
  ordered_json facts{{"words", ordered_json::array()},
                     {"folder", plain(fs::current_path(none).string())},
                     {"loaded", ordered_json::array()}};
  std::ifstream words("/proc/self/cmdline", std::ios::binary);
  for (std::string word; std::getline(words, word, '\0');) facts["words"].push_back(plain(word));
  for (const std::string& library : loaded_libraries()) {
    const fs::path file = fs::canonical(library, none);
    const auto bytes = none ? 0 : fs::file_size(file, none);
    if (none) continue;  // what the kernel adds
    facts["loaded"].push_back(
        {{"file", plain(file.string())}, {"bytes", bytes}, {"sum", sum_of_file(file.string())}});
  }
  return facts;
}

}  // namespace odeum::report
