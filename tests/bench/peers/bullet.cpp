// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

#include "bench/peers/peers.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/judge/errors.hpp"

namespace odeum::peers {
namespace {

struct Tuning {
  const char* method;
  const char* words;
  std::map<std::string, double> options;
  bool taken;
};

const Tuning tunings[] = {
    {"soft_body_force", "forces on nodes", {}, true},
    {"deformable_explicit", "explicit", {}, true},
    {"deformable_implicit", "one Newton step, 300 iterations of conjugate gradients", {}, true},
    {"deformable_implicit", "conjugate gradients limited to 4", {{"sweeps", 4}}, false},
    {"deformable_implicit", "conjugate gradients limited to 16", {{"sweeps", 16}}, false},
    {"deformable_implicit", "2 Newton steps", {{"newton", 2}}, false},
    {"soft_body_links", "1 sweep", {}, true},
    {"soft_body_links", "4 sweeps", {{"sweeps", 4}}, false},
    {"soft_body_links", "16 sweeps", {{"sweeps", 16}}, false},
    {"soft_body_links_stock", "1 sweep", {}, true},
    {"soft_body_links_stock", "4 sweeps", {{"sweeps", 4}}, false},
};

constexpr const char* documentation =
    "Header btSoftBody.h: piterations is the number of iterations of the position solver, 1 by "
    "default; the deformable world has its limits of iterations in btDeformableBodySolver. No "
    "documentation recommends a number.";

/// The error at the stops and the least processor time of three runs, in microseconds.
std::vector<record::Cell> measured(const Case& c, const Entrant& entrant, const Tuning& tuning,
                                   std::uint64_t steps) {
  Request request;
  request.stops = c.stops;
  request.steps = steps * c.settings.steps_multiple;
  request.options = tuning.options;
  double least = std::numeric_limits<double>::infinity(), error = 0;
  const std::string missing = "nan";
  for (int repetition = 0; repetition < 3; ++repetition) {
    const std::clock_t start = std::clock();
    const Outcome outcome = entrant.solve(request);
    least = std::min(least, 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (outcome.status != Status::ok) return {missing, missing};
    error = 0;
    for (const judge::StopError& stop : judge::Judge(c, request.stops).errors(outcome))
      error = std::max(error, stop.error_max);
  }
  return {fmt::format("{:.1e}", error), fmt::format("{:.0f}", least)};
}

}  // namespace

record::Records bullet_rows() {
  constexpr std::uint64_t steps[] = {20, 80, 320, 1280};
  record::Records table{{"method", "setting", "steps_between_stops", "error", "processor_us",
                         "taken", "documentation"}};
  const Case& c = known_case("cloth11_two_way");
  for (const Tuning& tuning : tunings)
    for (const Entrant& entrant : c.entrants) {
      if (entrant.info.library != "bullet" || entrant.info.method != tuning.method) continue;
      if (!entrant.unfit.empty()) continue;
      for (const std::uint64_t n : steps) {
        const std::vector<record::Cell> numbers = measured(c, entrant, tuning, n);
        table.rows.push_back({std::string(tuning.method), std::string(tuning.words),
                              static_cast<double>(n), numbers[0], numbers[1],
                              std::string(tuning.taken ? "yes" : "no"),
                              std::string(documentation)});
      }
    }
  return table;
}

}  // namespace odeum::peers
