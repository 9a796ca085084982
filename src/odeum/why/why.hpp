// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "odeum/cases/conditions.hpp"
#include "odeum/measure/local.hpp"
#include "odeum/measure/recording.hpp"
#include "odeum/measure/run_record.hpp"
#include "odeum/why/kink.hpp"

/// What a run spends its steps on, why it failed, and what does better: by this run, by measuring
/// along it, and by other runs. Nothing is concluded from a name, a family or a tag.
namespace odeum::why {

enum class Cause {
  accuracy,        ///< the error test: a looser tolerance gives longer steps
  stability,       ///< a step at or beyond the edge of the stability region
  kink,            ///< the right-hand side is not smooth somewhere
  sliding,         ///< the solution stays where the right-hand side jumps
  pole,            ///< the solution grows beyond all bounds at a finite time
  growth,          ///< the solution itself grows beyond the largest number
  singular,        ///< its slope grows beyond all bounds, and it does not
  domain,          ///< the right-hand side is not defined at a state that the solver tried
  wrong_jacobian,  ///< differences of the right-hand side deny the one given
  rounding,        ///< the tolerance is at the rounding of the state
  pulse,           ///< the run steps over a time at which the right-hand side is another
  aliasing,        ///< the right-hand side turns round and back within single steps
  amplification,   ///< the problem itself makes errors grow
  absolute,        ///< an absolute tolerance is above the size of a component
  energy,          ///< each step multiplies the energy of an undamped motion
  too_coarse,      ///< a fixed step that does not resolve the solution
  too_fine,        ///< a fixed step far shorter than its error needs
  astray,          ///< the run left the solution, which others follow to the end
  newton,          ///< the iteration of an implicit step does not converge
  unfit,           ///< the solver can't make this run
  events,          ///< steps end at events, after each of which the run begins anew
};
const char* name_of(Cause cause);

struct Finding {
  Cause cause;
  double share = nan;  ///< of the run's steps, or of its evaluations for a kink; NaN: of no part
  double from = nan;   ///< since when
  std::string text;    ///< a sentence without its end
};

/// Steps one after the other that the same bounds.
struct Segment {
  double from = 0, to = 0;
  double steps = 0;
  std::ptrdiff_t evaluations = 0;    ///< rejected steps among them
  std::optional<Cause> cause = {};   ///< empty: the start, or nothing that was measured
  double h = nan;                    ///< the middle one
  double fastest = nan, rate = nan;  ///< |lambda| and the solution's own rate of change, per time
  double used = nan;                 ///< h |lambda| over the edge
  std::string component = {};
};

/// Another run that was made. Its error is that at its end, NaN where the truth is not known.
struct Other : measure::RunRecord {
  Request request;
  double reached = nan;
  /// Largest difference of a component from what is known at its end, over the component's size.
  double difference = nan;

  std::string id() const { return library + "/" + solver; }
};

struct Why {
  std::string solver;
  Request request;
  Outcome outcome;
  double error = nan, reached = nan;
  double difference = nan;  ///< see Other
  std::string known_by;     ///< the truth, or two runs that agree; empty: nothing is known
  double doubt = 0;         ///< by how much those differ
  double steps_left = 0;    ///< to the end, as long as the last ones
  bool exact_steps = true;
  std::vector<Finding> findings;  ///< the main one first
  std::vector<Segment> segments;
  std::vector<Other> others;
  std::optional<std::size_t> better;  ///< in `others`: what to do
  std::string advice;                 ///< what no option of `odeum run` can say; may be empty
};

/// `solver` is one that the case has; `request` that of `odeum run`, its budget aside. Throws
/// Interrupted. `conditions`: those of the equations, where they are known.
Why why(const Case& c, const std::string& solver, const Request& request, double seconds,
        cases::Conditions conditions = {});

/// The first line: what and how much of it.
std::string first_line(const Why& why);

}  // namespace odeum::why
