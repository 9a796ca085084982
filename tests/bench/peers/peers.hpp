// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/solvers/case.hpp"

/// Settings of the peers, measured with the libraries alone, see reports/peers.md.
namespace odeum::peers {

struct Run {
  bool ok = false;  ///< as the library says
  long steps = 0;   ///< accepted
  std::vector<double> y;
};

/// The problem of a case as a library's user data: counts evaluations, and refuses more than
/// most_evaluations of them.
struct Counted {
  OdeView view;
  long evaluations = 0;
  static constexpr long most_evaluations = 100'000;

  bool rhs(double t, const double* y, double* dydt) {
    view.rhs(view.problem, t, y, dydt);
    return ++evaluations <= most_evaluations;
  }
};

constexpr double tolerances[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
constexpr double wanted_errors[] = {1e-2, 1e-4, 1e-6};
constexpr double unreached = std::numeric_limits<double>::infinity();

/// At the horizon, relative to the largest component there; infinite where it is not a number.
double error_at_end(const Case& c, const std::vector<double>& y);

/// A solved run.
struct Solved {
  double error, time, evaluations;
};

/// The least cost of a run of at most that error; the cost on the line between two neighbouring
/// tolerances, in logarithms, where that is less.
double cost_of(double error, const std::vector<Solved>& runs, double Solved::*cost);

struct Alternative {
  std::string setting;
  bool taken;  ///< by the adapter
  std::function<Run(const Case&, double tolerance, Counted&)> run;
};

struct Choice {
  std::string solver, choice;
  std::string documentation;  ///< what it recommends, and where
  std::vector<Alternative> alternatives;
  bool smooth = false;  ///< measured on the smooth cases instead of the stiff ones
};

std::vector<Choice> sundials_choices();
std::vector<Choice> gsl_choices();
std::vector<Choice> odeint_choices();
/// ARKODE's default tables before and since SUNDIALS 7.3.0, a row a case: reports/peers.md.
record::Records sundials_default_rows();
/// The rows on Bullet, which runs scenes at fixed steps; none where it is not built.
record::Records bullet_rows();

}  // namespace odeum::peers
