// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/inlined.hpp"
#include "odeint/solvers.hpp"

namespace odeum::adapters::odeint {
namespace {

/// A stepper on q'' = a(t, q, v), through the shared type that shows most of the problem.
Solver second_order_solver(const char* method) {
  return {info_of(method), [method](const ErasedContest& contest, Entrant& entrant) {
            entrant.unfit = "needs " + entrant.info.needs;
            with_shared_type(contest.view, [&]<Shared P>() {
              if constexpr (SecondOrder<P>) {
                Roster<P> roster;
                add_second_order(roster);
                const Contest<P> shared = shared_contest<P>(contest);
                const Run<P> run = roster.find(method);
                if (!run || !suits(method, *shared.problem)) return;
                entrant.unfit.clear();
                entrant.solve = Solve<P>{shared, run};
              }
            });
          }};
}

}  // namespace

void add_solvers(std::vector<Solver>& all) {
  Roster<SharedOde> first_order;
  add_one_step(first_order);
  add_extrapolation(first_order);
  add_multistep(first_order, std::make_index_sequence<8>());
  add_adaptive_adams<4, 8>(first_order);
  for (const auto& [method, run] : first_order.steppers())
    all.push_back({info_of(method), [run = run](const ErasedContest& contest, Entrant& entrant) {
                     entrant.solve = Solve<SharedOde>{shared_contest<SharedOde>(contest), run};
                   }});
  for (const char* method : {"symplectic_euler", "symplectic_rkn_sb3a_mclachlan",
                             "symplectic_rkn_sb3a_m4_mclachlan", "velocity_verlet"})
    all.push_back(second_order_solver(method));
  add_implicit(all);
}

}  // namespace odeum::adapters::odeint
