// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/given_cases.hpp"

#include <list>
#include <stdexcept>
#include <utility>

namespace odeum {
namespace {

std::list<Case>& storage() {
  static std::list<Case> cases;
  return cases;
}

}  // namespace

std::vector<const Case*> given_cases() {
  std::vector<const Case*> cases;
  for (const Case& c : storage()) cases.push_back(&c);
  return cases;
}

const Case& add_given_case(Case c) {
  for (const Case* known : given_cases())
    if (known->id == c.id) throw std::invalid_argument("a case named " + c.id + " exists");
  return storage().emplace_back(std::move(c));
}

}  // namespace odeum
