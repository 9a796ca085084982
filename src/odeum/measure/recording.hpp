// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/solvers/case.hpp"

/// Runs whose evaluations are looked at: every solver is enrolled on a problem that notes them.
namespace odeum::measure {

/// An evaluation of the right-hand side that gave a value that is not finite.
struct NotFinite {
  double t = nan;  ///< NaN: there was none
  std::vector<double> y;
  std::size_t component = 0;
  double value = 0;
};

/// What a run evaluated.
struct Trace {
  std::vector<double> times;  ///< of the evaluations, as far as there is room
  NotFinite first_bad;
};

/// A case's problem from a state of its own, whose evaluations are noted.
class Recording {
 public:
  Recording(const Case& c, double t0, const std::vector<double>& y0);
  /// The solver on it; null where there is none of that id.
  const Entrant* solver(const std::string& id) const { return entrants_.find(id); }
  const Trace& trace() const { return log_->trace; }

 private:
  struct Log {
    OdeView inner;
    std::shared_ptr<const void> keep_alive;
    Trace trace;
    /// Whether it is the first that is not finite.
    bool note(double t, const double* values, std::size_t n, std::size_t first);
  };

  std::shared_ptr<Log> log_;
  Entrants entrants_;
};

/// A state of a run at the end of a step, or at its start.
struct Moment {
  double t = 0, h = 0;   ///< the step that follows; 0 at the end of the run
  std::size_t step = 0;  ///< how many steps lie before it
  std::vector<double> y;
};

/// A run with its steps and its states at some of them.
struct Run {
  std::string solver;
  Request request;
  Outcome outcome = {};
  /// t0, and the ends of the steps: the solver's own, or with `exact` off estimated for a peer.
  std::vector<double> ends = {};
  bool exact = true;
  Trace trace = {};
  std::vector<Moment> moments = {};  ///< in the order of time

  std::size_t steps() const { return ends.size() - 1; }
  bool ok() const { return outcome.status == Status::ok; }
  /// Points to the last state.
  const double* end() const {
    return outcome.states.data() + outcome.states.size() - moments.front().y.size();
  }
  /// The mean length of the steps around t, a hundredth of them.
  double step_at(double t) const;
  /// How many steps lie in an interval, parts of steps included.
  double steps_in(double from, double to) const;
  /// The interval around t over which step_at takes the mean.
  std::pair<double, double> around(double t) const;
};

/// Makes the run; `most` states are taken along it, evenly in steps and in time, which is a second
/// run of the same steps. Throws Interrupted.
Run record(const Case& c, const std::string& solver, const Request& request, std::size_t most);

}  // namespace odeum::measure
