// SPDX-License-Identifier: BSD-3-Clause
#include "odepack/solvers.hpp"

#include "odepack/run.hpp"

namespace odeum::adapters::odepack {
namespace {

constexpr const char* odepack_papers =
    "ODEPACK, Hindmarsh, in: Scientific Computing (1983) 55-64; Petzold, SIAM J. Sci. Stat. "
    "Comput. "
    "4 (1983) 136-148";
constexpr const char* vode_paper =
    "Brown, Byrne, Hindmarsh, VODE, SIAM J. Sci. Stat. Comput. 10 (1989) 1038-1051";

const MultistepMethod methods[] = {
    {"odepack", "lsoda", "LSODA", &Library::lsoda, &Library::of_odepack, false, true,
     "Adams methods of orders 1 to 12 and BDF of orders 1 to 5, between which it switches"},
    {"odepack", "lsode_adams", "LSODE", &Library::lsode, &Library::of_odepack, false, false,
     "Adams methods of orders 1 to 12, functional iteration"},
    {"odepack", "lsode_bdf", "LSODE", &Library::lsode, &Library::of_odepack, true, false,
     "BDF of orders 1 to 5, chord iteration"},
    {"vode", "adams", "VODE", &Library::vode, &Library::of_vode, false, false,
     "variable-coefficient Adams methods of orders 1 to 12, functional iteration"},
    {"vode", "bdf", "VODE", &Library::vode, &Library::of_vode, true, false,
     "variable-coefficient BDF of orders 1 to 5, modified Newton iteration, Jacobian saved"},
};

SolverInfo describe(const MultistepMethod& method) {
  SolverInfo info;
  info.library = method.library;
  info.method = method.method;
  info.family = "multistep";
  info.fixed = false;
  info.adaptive = true;
  info.common_use = method.switches ? CommonUse::tolerance : CommonUse::none;
  info.controller = "step and order chosen together, by the library";
  info.source = std::string(method.name) + " of " ODEUM_DESOLVE_VERSION ": " + method.source +
                "; " + (method.run == &Library::vode ? vode_paper : odepack_papers);
  return info;
}

SolverInfo radau5() {
  SolverInfo info;
  info.library = "radau5";
  info.method = "radau5";
  info.family = "implicit_rk";
  info.order = 5;
  info.fixed = false;
  info.adaptive = true;
  info.controller = "embedded formula of order 3, Gustafsson's predictive controller";
  info.source = "RADAU5 of 2002-01-18 in " ODEUM_DESOLVE_VERSION
                ": Radau IIA of three stages; Hairer, Wanner, "
                "Solving ODEs II, IV.8";
  return info;
}

}  // namespace

void add_solvers(std::vector<Solver>& all) {
  for (const MultistepMethod& method : methods)
    all.push_back({describe(method), [&method](const ErasedContest& contest, Entrant& entrant) {
                     entrant.solve = [&method, contest](const Request& request) {
                       return odepack::solve(method, contest, request);
                     };
                   }});
  all.push_back({radau5(), [](const ErasedContest& contest, Entrant& entrant) {
                   entrant.solve = [contest](const Request& request) {
                     return solve_by_radau5(contest, request);
                   };
                 }});
}

}  // namespace odeum::adapters::odepack
