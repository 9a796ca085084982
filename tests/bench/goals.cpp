// SPDX-License-Identifier: BSD-3-Clause
// Prints the table of speed goals, goal beside measured; see scripts/bench. No arguments: all
// groups; else those named. Exits 0 whatever the figures say: no test fails on a time.
#include "goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "odeum/core/machine.hpp"
#include "odeum/studies/stopwatch.hpp"

int main(int argc, char** argv) {
  using namespace odeum::bench;
  struct Group {
    const char* name;
    const char* title;
    std::vector<Row> (*rows)();
  };
  constexpr Group groups[] = {
      {"kernel", "Forces of a cloth", cloth_kernel_rows},
      {"steps", "Steps of a cloth", cloth_step_rows},
      {"cloth", "A cloth at equal error", cloth_error_rows},
      {"contact", "A cloth that lies on itself, with contacts / without", contact_rows},
      {"fixed", "Fixed-step RK4 against the better of odeint's two", fixed_step_rows},
      {"evaluation", "What a step costs beyond the right-hand side, by unknowns", evaluation_rows},
      {"growth", "Time as work grows: the largest number of unknowns / the smallest, an unknown",
       growth_rows},
      {"precision", "At equal error: time of the best peer / of the best own solver",
       precision_rows},
      {"advise", "Time of the setting advised / of the best of an exhaustive search", advise_rows},
      {"sparse", "Implicit methods on many unknowns", sparse_rows},
      {"fem", "Linear finite elements on a million triangles", fem_rows}};
  for (int i = 1; i < argc; ++i)
    if (std::none_of(std::begin(groups), std::end(groups),
                     [&](const Group& g) { return std::string(g.name) == argv[i]; })) {
      fmt::print(stderr,
                 "odeum_goals: no group {}; got {}, expected kernel, steps, cloth, contact, fixed, "
                 "evaluation, growth, precision, advise, sparse or fem\n",
                 argv[i], argv[i]);
      return 2;
    }
  const double before = odeum::study::calibration_ns();
  Printed out;
  out.machine();
  for (const Group& group : groups) {
    if (argc > 1 && std::none_of(argv + 1, argv + argc,
                                 [&](const char* a) { return std::string(a) == group.name; }))
      continue;
    out.title(group.title);
    for (const Row& row : group.rows()) out.row(row);
  }
  out.end(odeum::study::calibration_ns() / before - 1);
}
