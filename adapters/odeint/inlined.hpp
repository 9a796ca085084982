// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer_dense_out.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/modified_midpoint.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54_classic.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/symplectic_euler.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "odeint/adaptive_adams.hpp"
#include "odeint/catalogue.hpp"
#include "odeint/run.hpp"
#include "odeint/scaled.hpp"

/// Its steppers on a type of problem; slow to compile.
namespace odeum::adapters::odeint {

namespace od = boost::numeric::odeint;

/// Steppers on a type of problem, by name.
template <Ode P>
class Roster {
 public:
  struct Stepper {
    std::string method;
    Run<P> run;
  };

  void add(std::string_view method, Run<P> run) { steppers_.push_back({std::string(method), run}); }
  const std::vector<Stepper>& steppers() const { return steppers_; }
  /// Null where there is none of that name.
  Run<P> find(std::string_view method) const {
    for (const Stepper& stepper : steppers_)
      if (stepper.method == method) return stepper.run;
    return nullptr;
  }

 private:
  std::vector<Stepper> steppers_;
};

/// One type for all steppers, so that std::function is instantiated once a problem.
template <Ode P>
struct Solve {
  Contest<P> contest;
  Run<P> run;
  Outcome operator()(const Request& request) const {
    if (request.mode == Mode::fixed || !request.tolerance.by_component())
      return run(contest, request);
    if constexpr (std::same_as<P, SharedOde>) return run_scaled(contest, request, run);
    return refuse_by_component();
  }
};

/// Whether a stepper of that name suits the problem. The symplectic ones are not told the time.
template <Ode P>
bool suits(std::string_view method, const P& problem) {
  return !method.starts_with("symplectic") || is_autonomous(problem);
}

/// Appends those of the steppers that suit the problem of a contest.
template <Ode P>
void enroll(const Roster<P>& roster, const Contest<P>& contest, std::vector<Entrant>& entrants) {
  for (const auto& [method, run] : roster.steppers())
    if (suits(method, *contest.problem))
      entrants.push_back({.info = info_of(method), .unfit = {}, .solve = Solve<P>{contest, run}});
}

template <class Stepper, Ode P>
constexpr Run<P> run_error_stepper = run_either<Stepper, run_plain<Stepper, P>, P>;

template <unsigned short Order, Ode P>
constexpr Run<P> run_extrapolation =
    run_either<od::extrapolation_stepper<Order, State<P>>,
               run_out_of_place<od::extrapolation_stepper<Order, State<P>>, P>, P>;

/// adams_bashforth_moulton, started like adams_bashforth: its default, runge_kutta4, limits it to
/// order 5.
template <std::size_t K, class Y>
using AdamsBashforthMoulton = od::adams_bashforth_moulton<
    K, Y, double, Y, double, typename od::algebra_dispatcher<Y>::algebra_type,
    typename od::operations_dispatcher<Y>::operations_type, od::initially_resizer,
    typename od::adams_bashforth<K, Y>::initializing_stepper_type>;

template <Ode P>
void add_one_step(Roster<P>& roster) {
  using Y = State<P>;
  roster.add("euler", run_plain<od::euler<Y>, P>);
  roster.add("modified_midpoint", run_plain<od::modified_midpoint<Y>, P>);
  roster.add("runge_kutta4", run_plain<od::runge_kutta4<Y>, P>);
  roster.add("runge_kutta4_classic", run_plain<od::runge_kutta4_classic<Y>, P>);
  roster.add("runge_kutta_cash_karp54", run_error_stepper<od::runge_kutta_cash_karp54<Y>, P>);
  roster.add("runge_kutta_cash_karp54_classic",
             run_error_stepper<od::runge_kutta_cash_karp54_classic<Y>, P>);
  using Dopri5 = od::runge_kutta_dopri5<Y>;
  constexpr auto make_dense_dopri5 = [](const Tolerance& tolerance) {
    return od::dense_output_runge_kutta<Controlled<Dopri5>>(make_controlled<Dopri5>(tolerance));
  };
  constexpr Run<P> dense_dopri5 = run_dense<make_dense_dopri5, 4, P>;
  roster.add("runge_kutta_dopri5", run_with_outputs<Dopri5, run_plain<Dopri5, P>, dense_dopri5, P>);
  roster.add("runge_kutta_fehlberg78", run_error_stepper<od::runge_kutta_fehlberg78<Y>, P>);
  roster.add("dense_output_runge_kutta_dopri5", dense_dopri5);
}

template <Ode P>
void add_extrapolation(Roster<P>& roster) {
  using Y = State<P>;
  roster.add("extrapolation_stepper_4", run_extrapolation<4, P>);
  roster.add("extrapolation_stepper_6", run_extrapolation<6, P>);
  roster.add("extrapolation_stepper_8", run_extrapolation<8, P>);
  roster.add("extrapolation_stepper_10", run_extrapolation<10, P>);
  roster.add("extrapolation_stepper_12", run_extrapolation<12, P>);
  roster.add("bulirsch_stoer", run_controlled<od::bulirsch_stoer<Y>, 4, P>);
  constexpr auto make_dense_bulirsch_stoer = [](const Tolerance& tolerance) {
    return od::bulirsch_stoer_dense_out<Y>(tolerance.absolute(0), tolerance.relative);
  };
  roster.add("bulirsch_stoer_dense_out", run_dense<make_dense_bulirsch_stoer, 4, P>);
}

template <Ode P, std::size_t... K>
void add_multistep(Roster<P>& roster, std::index_sequence<K...>) {
  using Y = State<P>;
  (roster.add("adams_bashforth_" + std::to_string(K + 1),
              run_out_of_place<od::adams_bashforth<K + 1, Y>, P>),
   ...);
  (roster.add("adams_bashforth_moulton_" + std::to_string(K + 1),
              run_out_of_place<AdamsBashforthMoulton<K + 1, Y>, P>),
   ...);
}

/// The Adams method of the highest order alone, for timed runs.
template <Ode P>
void add_longest_adams(Roster<P>& roster) {
  roster.add("adams_bashforth_8", run_out_of_place<od::adams_bashforth<8, State<P>>, P>);
}

template <std::size_t... K, Ode P>
void add_adaptive_adams(Roster<P>& roster) {
  (roster.add("adaptive_adams_bashforth_moulton_" + std::to_string(K), run_adaptive_adams<K, P>),
   ...);
  (roster.add("controlled_adams_bashforth_moulton_" + std::to_string(K),
              run_controlled_adams<K, P>),
   ...);
}

/// Adds the methods of second order that the type of problem fits.
template <Ode P>
void add_second_order(Roster<P>& roster) {
  if constexpr (Separable<P>) {
    using Q = Half<P>;
    roster.add("symplectic_euler", run_pair<od::symplectic_euler<Q>, SymplecticSystem, P>);
    roster.add("symplectic_rkn_sb3a_mclachlan",
               run_pair<od::symplectic_rkn_sb3a_mclachlan<Q>, SymplecticSystem, P>);
    roster.add("symplectic_rkn_sb3a_m4_mclachlan",
               run_pair<od::symplectic_rkn_sb3a_m4_mclachlan<Q>, SymplecticSystem, P>);
  }
  if constexpr (SecondOrder<P>)
    roster.add("velocity_verlet", run_pair<od::velocity_verlet<Half<P>>, SecondOrderSystem, P>);
}

// On the shared types they are compiled in this folder.
extern template void add_second_order(Roster<SharedSecondOrder>&);
extern template void add_second_order(Roster<SharedSeparable>&);

}  // namespace odeum::adapters::odeint
