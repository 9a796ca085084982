// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/runner.hpp"

#include "odeum/core/glob.hpp"

namespace odeum::study {

std::vector<const Case*> select_cases(const std::vector<std::string>& globs) {
  std::vector<const Case*> cases;
  for (const Case& c : all_cases())
    if (any_glob_matches(globs, c.id)) cases.push_back(&c);
  return cases;
}

std::vector<Pair> select_pairs(const std::vector<const Case*>& cases,
                               const std::vector<std::string>& solver_globs) {
  std::vector<Pair> pairs;
  for (const Case* c : cases)
    for (const Entrant& entrant : c->entrants)
      if (any_glob_matches(solver_globs, entrant.info.id())) pairs.push_back({c, &entrant});
  return pairs;
}

}  // namespace odeum::study
