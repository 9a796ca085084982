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

/// The error at the stops and the least processor time of three runs, in microseconds.
std::string cell(const Case& c, const Entrant& entrant, const Tuning& tuning, std::uint64_t steps) {
  Request request;
  request.stops = c.stops;
  request.steps = steps * c.settings.steps_multiple;
  request.options = tuning.options;
  double least = std::numeric_limits<double>::infinity(), error = 0;
  for (int repetition = 0; repetition < 3; ++repetition) {
    const std::clock_t start = std::clock();
    const Outcome outcome = entrant.solve(request);
    least = std::min(least, 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (outcome.status != Status::ok) return to_string(outcome.status);
    error = 0;
    for (const judge::StopError& stop : judge::Judge(c, request.stops).errors(outcome))
      error = std::max(error, stop.error_max);
  }
  return fmt::format("{:.1e} in {:.0f}", error, least);
}

}  // namespace

void write_bullet() {
  constexpr std::uint64_t steps[] = {20, 80, 320, 1280};
  for (const Case& c : all_cases()) {
    if (c.id != "cloth11_two_way") continue;
    fmt::print("## Bullet: iterations on {}\n\n", c.id);
    fmt::print(
        "Header btSoftBody.h: piterations is the number of iterations of the position solver, 1 by "
        "default; the deformable world has its limits of iterations in btDeformableBodySolver. No "
        "documentation recommends a number; `odeum precision` runs 4 and 16 of them and 2 Newton "
        "steps beside the defaults. Through the adapter, since the set-up of a cloth is "
        "long. Largest error at the stops in m and m/s, and processor time in microseconds, set-up "
        "included, by number of steps between two stops.\n\n| method | setting |");
    for (const std::uint64_t n : steps) fmt::print(" {} |", n);
    fmt::print(" |\n|---|---|---|---|---|---|---|\n");
    for (const Tuning& tuning : tunings)
      for (const Entrant& entrant : c.entrants) {
        if (entrant.info.library != "bullet" || entrant.info.method != tuning.method) continue;
        fmt::print("| {} | {} |", tuning.method, tuning.words);
        for (const std::uint64_t n : steps)
          fmt::print(" {} |", entrant.unfit.empty() ? cell(c, entrant, tuning, n) : "unfit");
        fmt::print(" {} |\n", tuning.taken ? "taken" : "");
        std::fflush(stdout);
      }
    fmt::print("\n");
  }
}

}  // namespace odeum::peers
