// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/catalogue.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "odeint/implicit.hpp"

namespace odeum::adapters::odeint {
namespace {

constexpr double varies = std::numeric_limits<double>::quiet_NaN();

enum Modes { fixed_only, adaptive_only, both };

/// `order` is what order() or stepper_order() in the stepper's header claims. A family of steppers
/// is one row; its number is appended to the name, and its order is that number plus `order`.
struct Row {
  const char* name = "";
  const char* family = "";
  double order = 0;
  Modes modes = both;
  const char* controller = "";
  const char* needs = "";
  const char* note = "";
  int numbered_to = 0;
  CommonUse common_use = CommonUse::none;
};

constexpr const char* controlled =
    "make_controlled(abs, rel): error within abs + rel (|y| + h |y'|)";
constexpr const char* own_control = "the stepper's own";
constexpr const char* needs_nothing = "";
constexpr const char* needs_dense = "a dense Jacobian (differenced where there is none)";
constexpr const char* needs_second_order = "q'' = a(t, q, v)";
constexpr const char* needs_separable =
    "q'' = a(q), of neither velocity nor time: the system function is given neither";

const Row rows[] = {
    {"euler", "explicit_rk", 1, fixed_only, "", needs_nothing, ""},
    {"modified_midpoint", "explicit_rk", 2, fixed_only, "", needs_nothing, "two sub-steps"},
    {"runge_kutta4", "explicit_rk", 4, fixed_only, "", needs_nothing, "by the generic algorithm", 0,
     CommonUse::fixed_step},
    {"runge_kutta4_classic", "explicit_rk", 4, fixed_only, "", needs_nothing, "written out"},
    {"runge_kutta_cash_karp54", "explicit_rk", 5, both, controlled, needs_nothing, ""},
    {"runge_kutta_cash_karp54_classic", "explicit_rk", 5, both, controlled, needs_nothing, ""},
    {"runge_kutta_dopri5", "explicit_rk", 5, both, controlled, needs_nothing, "", 0,
     CommonUse::tolerance},
    {"runge_kutta_fehlberg78", "explicit_rk", 8, both, controlled, needs_nothing, ""},
    {"dense_output_runge_kutta_dopri5", "explicit_rk", 5, adaptive_only, controlled, needs_nothing,
     "make_dense_output: stops before the horizon are interpolated"},
    {"extrapolation_stepper", "extrapolation", 0, both, controlled, needs_nothing,
     "order is the template parameter", 12},
    {"bulirsch_stoer", "extrapolation", varies, adaptive_only, own_control, needs_nothing,
     "chooses order and step"},
    {"bulirsch_stoer_dense_out", "extrapolation", varies, adaptive_only, own_control, needs_nothing,
     "chooses order and step; stops before the horizon are interpolated"},
    {"adams_bashforth", "multistep", 0, fixed_only, "", needs_nothing,
     "order is the number of steps; starts itself by extrapolation_stepper, called out of place",
     8},
    {"adams_bashforth_moulton", "multistep", 0, fixed_only, "", needs_nothing,
     "order() is the number of steps (the header's comment says one more); started as "
     "adams_bashforth, called out of place",
     8},
    {"adaptive_adams_bashforth_moulton", "multistep", 1, fixed_only, "", needs_nothing,
     "stepper_order() is the number of steps + 1; the first step is as many sub-steps of "
     "extrapolation_stepper, by initialize()",
     8},
    {"controlled_adams_bashforth_moulton", "multistep", varies, adaptive_only,
     "H211 PI filter on step, and order by error", needs_nothing,
     "the number is the highest order; starts at order 1", 8},
    {"symplectic_euler", "symplectic", 1, fixed_only, "", needs_separable, ""},
    {"symplectic_rkn_sb3a_mclachlan", "symplectic", 4, fixed_only, "", needs_separable, ""},
    {"symplectic_rkn_sb3a_m4_mclachlan", "symplectic", 4, fixed_only, "", needs_separable, ""},
    {"velocity_verlet", "symplectic", 1, fixed_only, "", needs_second_order, "order() says 1", 0,
     CommonUse::fixed_step},
    {"implicit_euler", "implicit_rk", 1, fixed_only, "", needs_dense,
     "its Newton iteration ends at a step of 1e-6"},
    {"rosenbrock4", "linearly_implicit", 4, both, "rosenbrock4_controller", needs_dense, ""},
    {"rosenbrock4_dense_output", "linearly_implicit", 4, adaptive_only, "rosenbrock4_controller",
     needs_dense, "stops before the horizon are interpolated"},
};

/// Splits "adams_bashforth_3" into its row and 3; a plain name is its own row and 0.
const Row& row_of(std::string_view method, int& number) {
  for (const Row& row : rows) {
    const std::string_view name = row.name;
    number = 0;
    if (!row.numbered_to && method == name) return row;
    if (!row.numbered_to || !method.starts_with(name) || method.size() < name.size() + 2) continue;
    const char* const end = method.data() + method.size();
    const auto parsed = std::from_chars(method.data() + name.size() + 1, end, number);
    if (parsed.ptr == end && number >= 1 && number <= row.numbered_to) return row;
  }
  throw std::logic_error("odeint has no stepper " + std::string(method));
}

/// The sum of the moduli of the weights with which extrapolation_stepper of an order adds up the
/// states of its midpoint runs of 2, 4, ..., `order` sub-steps; their rounding is multiplied by it.
double extrapolation_weights(int order) {
  double sum = 0;
  for (double j = 2; j <= order; j += 2) {
    double weight = 1;
    for (double i = 2; i <= order; i += 2)
      if (i != j) weight *= j * j / (j * j - i * i);
    sum += std::abs(weight);
  }
  return sum;
}

}  // namespace

SolverInfo info_of(std::string_view method) {
  int number = 0;
  const Row& row = row_of(method, number);
  SolverInfo info;
  info.library = "odeint";
  info.method = method;
  info.family = row.family;
  info.order = row.order + number;
  info.fixed = row.modes != adaptive_only;
  info.adaptive = row.modes != fixed_only;
  if (row.name == std::string_view("extrapolation_stepper"))
    info.rounding = extrapolation_weights(number);
  info.common_use = row.common_use;
  info.controller = row.controller;
  info.needs = row.needs;
  info.source = "Boost 1.74, Numeric.Odeint, the stepper's header";
  if (*row.note) info.source += std::string("; ") + row.note;
  return info;
}

void add_implicit(std::vector<Solver>& all) {
  const auto add = [&](const char* method, ImplicitRun run) {
    all.push_back({info_of(method), [run](const ErasedContest& contest, Entrant& entrant) {
                     entrant.solve = [run, contest](const Request& request) {
                       const std::size_t n = contest.view.dimension;
                       if (n > dense_dimension_limit) return dense_over_budget(n);
                       return run(contest.view, contest.t0, *contest.y0, request);
                     };
                   }});
  };
  add("implicit_euler", run_implicit_euler);
  add("rosenbrock4", run_rosenbrock4);
  add("rosenbrock4_dense_output", run_rosenbrock4_dense_output);
}

}  // namespace odeum::adapters::odeint
