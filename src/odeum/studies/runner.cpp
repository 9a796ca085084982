// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/runner.hpp"

#include <stdexcept>

#include "odeum/cases/catalogue.hpp"
#include "odeum/core/glob.hpp"

namespace odeum::study {

std::vector<const Case*> select_cases(const std::vector<std::string>& globs) {
  std::vector<const Case*> cases;
  for (const std::string& id : known_ids())
    if (any_glob_matches(globs, id)) cases.push_back(&known_case(id));
  return cases;
}

std::vector<Pair> select_pairs(const std::vector<const Case*>& cases,
                               const std::vector<std::string>& solver_globs) {
  std::vector<Pair> pairs;
  for (const Case* c : cases)
    for (std::size_t k = 0; k < c->entrants.size(); ++k)
      if (any_glob_matches(solver_globs, c->entrants.info(k).id()))
        pairs.push_back({c, &c->entrants[k]});
  return pairs;
}

const Case& find_case(const std::string& id) { return known_case(id); }

const Entrant& find_solver(const Entrants& entrants, const std::string& id) {
  if (const Entrant* const entrant = entrants.find(id)) return *entrant;
  throw std::out_of_range("no solver " + id);
}

std::string key_of(const Pair& pair) {
  return pair.c->id + ' ' + pair.entrant->info.id() + ' ' + to_string(pair.mode);
}

}  // namespace odeum::study
