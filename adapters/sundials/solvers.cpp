// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/solvers.hpp"

#include <iterator>
#include <utility>

#include "sundials/ida.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

const std::vector<Method>& all_methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> list;
    for (const auto part :
         {cvode_methods, cvode_held_methods, arkode_explicit_methods, arkode_implicit_methods}) {
      std::vector<Method> more = part();
      std::move(more.begin(), more.end(), std::back_inserter(list));
    }
    return list;
  }();
  return all;
}

}  // namespace

void add_solvers(std::vector<Solver>& all) {
  for (const Method& method : all_methods())  // they live as long as the program
    all.push_back({method.info, [&method](const ErasedContest& contest, Entrant& entrant) {
                     entrant.solve = [&method, contest](const Request& request) {
                       return solve(method, contest, request);
                     };
                   }});
  add_ida(all);
}

}  // namespace odeum::adapters::sundials
