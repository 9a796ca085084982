// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/plugin.h"
#include "odeum/problem/capabilities.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/problem/piece.hpp"
#include "odeum/solvers/foreign_evaluator.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum::foreign {

/// The problem of a plug-in or an FMU: called directly in a process of a solve, through an
/// Evaluator elsewhere. Its functions load the code where they are called first, which is never in
/// the process of the laboratory.
class Problem {
 public:
  explicit Problem(const odeum_problem& description);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  static constexpr std::size_t dimension = dynamic;
  std::size_t size() const { return p_.dimension; }
  static constexpr bool velocity_dependent = true;  // as far as the type knows
  bool depends_on_velocity() const { return p_.velocity_dependent != 0; }
  bool offers_jacobian() const;
  bool offers_time_derivative() const { return p_.time_derivative != nullptr; }
  bool offers_acceleration() const { return p_.acceleration != nullptr; }
  void rhs(double t, const double* y, double* dydt) const;
  void jacobian(double t, const double* y, double* j) const;
  void time_derivative(double t, const double* y, double* dfdt) const;
  void acceleration(double t, const double* q, const double* v, double* a) const;

  /// False where the solution is not known there.
  bool exact(double t, double* y) const;
  double energy(const double* y) const;
  /// A sentence where a function cannot be called from the initial state to the horizon; to be
  /// called in a process of its own.
  std::string fault() const;

 private:
  enum Function { f, f_y, f_t, second, energy_of, exact_at };
  int direct(int function, double t, const double* in, double* out) const;
  void evaluate(Function function, double t, const double* in, std::size_t n_in, double* out,
                std::size_t n_out) const;
  int dense(double t, const double* y, double* j) const;
  std::string fault_of_exact() const;

  odeum_problem p_;
  mutable std::vector<double> values_;  ///< of a banded or sparse Jacobian
  std::shared_ptr<Evaluator> evaluator_;
};

/// What is wrong with a name that goes into ids, files and pages; empty where nothing is.
std::string fault_of_name(const char* what, const char* name);
/// A text for people on one line, without control characters, of at most 300 characters.
std::string cleaned(const char* text);

/// What is wrong with the description, in a sentence; empty where nothing is.
std::string fault_of(const odeum_problem& problem);

/// A problem of a plug-in or an FMU, and what is said of it.
struct ProblemCallbacks {
  odeum_problem functions{};
  std::shared_ptr<const void> keep_alive;  ///< what the functions need; may be null
  std::string id, title, equation, source;
  std::string provider;  ///< for sentences: "the plug-in", "the FMU"
  std::string tag;
  std::string content;                                     ///< identifies its code and parameters
  std::vector<std::string> components;                     ///< their names; may be empty
  std::vector<double> scale;                               ///< by component; empty: 1
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and text, for people
  /// Null: none. Their functions are called in an isolated process alone.
  std::shared_ptr<const Events> events = nullptr;
  std::vector<Switch> switches = {};  ///< ascending
  std::string no_truth = {};          ///< why none can be had; empty: one may be
  /// What it brings to solve itself. They solve in an isolated process alone.
  std::vector<Entrant> own_solvers = {};
};

}  // namespace odeum::foreign
