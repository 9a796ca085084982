// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "odeum/core/common_use.hpp"
#include "odeum/core/outcome.hpp"
#include "odeum/linear/dense_limit.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/extended_problem.hpp"
#include "odeum/problem/implicit_form.hpp"
#include "odeum/problem/piece.hpp"

namespace odeum {

struct Events;
namespace scene {
struct Scene;
}

/// The stability function of a one-step method, where it has one; limits measured on the running
/// code are compared with it.
using StabilityFunction = std::function<double(double re, double im)>;  ///< |R(z)|

/// Properties of a solver, independent of any case.
struct SolverInfo {
  std::string library;  ///< odeum, cvode, arkode, gsl, odeint, bullet
  std::string method;   ///< the library's own name for it
  std::string family;   ///< explicit_rk, implicit_rk, multistep, symplectic, extrapolation, ...
  /// The order that the library's documentation claims; NaN where it varies during a run.
  double order = std::numeric_limits<double>::quiet_NaN();
  bool fixed = true;            ///< can be run at a fixed step
  bool adaptive = false;        ///< can be run to a tolerance
  bool adaptive_order = false;  ///< adaptive: the order is chosen too, so that none is claimed
  CommonUse common_use = CommonUse::none;
  std::string controller;  ///< adaptive: the step control, in a few words
  std::string
      needs;  ///< required capabilities of a problem, in a few words; empty: a right-hand side
  std::string source;  ///< paper and table, or the library's documentation
  /// Options of its own that a Request may give values for: name, and what the value means.
  std::map<std::string, std::string> options;
  /// Rounding of one step over that of the state: more than 1 where large weights cancel.
  double rounding = 1;
  StabilityFunction amplification;  ///< own one-step methods: |R(z)|; empty otherwise
  /// Own second-order methods: spectral radius of one step on q'' = -w^2 q, by w*h; else empty.
  std::function<double(double omega_h)> oscillator_amplification;

  std::string id() const { return library + "/" + method; }
  /// It evaluates a closed form of the solution, exact at any step: it stands beside methods, and
  /// no ratio of times compares it with one.
  bool closed_form() const { return family == "exponential"; }
};

/// A solver enrolled on a problem: the only place where types are erased, once per solve.
struct Entrant {
  SolverInfo info;
  /// Why the solver does not fit the problem, in a sentence; empty where it fits and `solve` may be
  /// called.
  std::string unfit;
  /// Runs from t0 and y0 of the contest to the last stop. The outcome has the states at the stops
  /// that were reached, one after the other, as many numbers each as y0; a numerical failure is its
  /// status. On a case it throws std::invalid_argument for a malformed request (require_sound).
  /// Several threads may call it at once while no parameter of the problem is changed.
  std::function<Outcome(const Request&)> solve;
  ExtendedRun extended{};  ///< empty: no coefficients in extended precision
};

/// The input for enrolling a library's solvers: the problem, its initial state, and its scene.
/// Solvers read the problem and the scene at each solve, since a study may change parameters
/// between solves; only dimensions are fixed.
template <Ode P>
struct Contest {
  std::shared_ptr<const P> problem;
  double t0 = 0;
  std::shared_ptr<const std::vector<double>> y0;
  std::shared_ptr<const scene::Scene> scene;  ///< null where the case is not mechanical
};

/// The same behind function pointers, for libraries whose own interface asks for them.
struct ErasedContest {
  OdeView view;
  std::shared_ptr<const void> keep_alive;
  double t0 = 0;
  std::shared_ptr<const std::vector<double>> y0;
  std::shared_ptr<const scene::Scene> scene;
  /// The residuals that state the problem, where they are not solved for all rates; else null.
  std::shared_ptr<const ImplicitForm> implicit = nullptr;
  /// The switches in [from, to], ascending; empty: the problem names none.
  std::function<std::vector<Switch>(double from, double to)> switches = {};
  std::shared_ptr<const Events> events = nullptr;  ///< null: nothing happens to the solution
};

template <Ode P>
ErasedContest erase(const Contest<P>& contest) {
  return {view_of(*contest.problem), contest.problem, contest.t0, contest.y0, contest.scene};
}

struct LaneFamily;
struct LaneMembers;
/// Runs members of a request with one stop, see lane_run.hpp.
using LaneRun = std::vector<Outcome> (*)(const LaneMembers& members, const Request& request);

/// A solver of a library, which is known without any problem.
struct Solver {
  SolverInfo info;
  /// Puts it on a problem: fills `unfit`, or `solve` and what else it can do there. The entrant
  /// comes with the solver's info, which may be completed from the problem. Several threads may
  /// enroll it at once, on contests of their own.
  std::function<void(const ErasedContest&, Entrant&)> enroll;
  /// An own method's run of many members in vector lanes; no function where it has none, and null
  /// where it has none in this mode or needs what the problem does not offer. An explicit method
  /// gives a member the bits and the counts that it has alone; a Rosenbrock method its tolerance.
  LaneRun (*lanes)(Mode mode, const LaneFamily& family) = nullptr;
};

/// A solver of residuals R(t, y, y') = 0 with dense matrices.
Solver on_residuals(SolverInfo info, Outcome (*solve)(const ErasedContest&, const Request&));

}  // namespace odeum
