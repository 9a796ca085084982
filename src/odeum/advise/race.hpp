// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "odeum/advise/clock.hpp"
#include "odeum/measure/run_record.hpp"
#include "odeum/measure/setting_search.hpp"
#include "odeum/studies/stopwatch.hpp"

/// Which solver, at which setting, has an error on a case in the least time, or the least error
/// within a time: by runs on that case.
/// Nothing about a case or a solver is stored or learned.
namespace odeum::advise {

struct Wishes {
  /// One of the two: the largest error at the case's stops, in the units of its errors, or the time
  /// of a run, in nanoseconds of processor time.
  double error = 0, time_ns = 0;
  /// Largest error of the energy at the stops, relative to the largest energy, beside an error; 0:
  /// none is asked for.
  double energy = 0;
  /// Beside `energy`, which the problem conserves: the time up to which it keeps to that, in the
  /// case's unit.
  double horizon = 0;
  /// Length of a frame in the case's unit of time: fixed steps divide it, and `time_ns` is the time
  /// allowed for one frame. With an error, the cases' stops are the ends of the frames. 0: no
  /// frames.
  double frame = 0;
  double seconds = 0;  ///< for the answer; 0: 20, and where a run takes over 2 ms
                       ///< that of 30 of the best runs foreseen, up to 600
  /// When the seconds begin to count. The time for the truth is included, up to half of them.
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double used_at_start = process_seconds();  ///< the processor's seconds at that time
  std::function<double()> clock;             ///< of a test, see Clock; empty: the machine's
  std::vector<std::string> libraries;        ///< empty: all
  std::vector<std::string> solvers;          ///< globs on library/method; empty: all
  /// Whether a command may end its steps on the stops, where its run misses the error without.
  bool may_stop = false;
};

/// The run of a trial on one of the cases.
struct Part : measure::RunRecord {
  Request request;
  double end_error = nan;  ///< at the end, where the run has no other stop
  double ns = 0;
};

/// A run that was made, on each case.
/// Its error is the largest at the stops of all cases, or that of the energy in proportion to the
/// wishes; its time is the processor's under the guard, less what the guard takes, mean of the
/// cases.
struct Trial : measure::Tried {
  std::vector<Part> parts;
  const Request& request() const { return parts.front().request; }

  /// The counters of the run on the first case.
  const Counters& counters() const { return parts.front().counters; }

  /// The largest error of the states alone.
  double state_error() const;
  double energy_error() const;
  /// The case of the largest error.
  std::size_t worst() const;
};

/// Why a candidate is not searched further.
struct Dropped {
  std::string why = {};    ///< empty: it is
  std::string group = {};  ///< the same of several candidates; empty: `why` holds for each of them
  bool empty() const { return why.empty(); }
};

/// A solver in one mode.
struct Candidate {
  const Entrant* entrant;
  Mode mode;
  std::vector<const Entrant*> on = {};  ///< the same solver, enrolled on each case
  std::vector<Trial> trials = {};       ///< in the order of their runs
  std::optional<Trial> found = {};      ///< the coarsest that reaches the error
  double foreseen = nan;                ///< cost of what is asked, from a run to the first stop
  double starts_at = 0;                 ///< fineness of the first run to the end; 0: not foreseen
  Dropped dropped = {};
  study::Times times = {};  ///< of `found`, with the bare right-hand side

  /// Powers of ten by which the error falls where the fineness grows tenfold.
  double slope() const;
  /// Claimed order, at least 1; 4 where a step control has none, 2 at fixed steps.
  double order() const;
  bool closed_form() const { return entrant->info.closed_form(); }
};

struct Advice {
  Wishes wishes;
  double run_ns = 0;    ///< the time of a run that was asked for; 0: an error was
  double frames = 0;    ///< in a run; 0: it has none
  std::string failure;  ///< why there is no answer, a sentence; empty: there is one
  double floor = 0;     ///< error of the truth
  std::vector<Candidate> candidates;
  std::size_t winner = 0;          ///< in `candidates`
  std::vector<std::size_t> timed;  ///< the same, by least time, or by least error within the time
  /// The winner's command has no stop but the end, and `found` is the run that it makes; or its
  /// steps end on the stops, since it misses the error without them.
  bool on_stops = false;
  std::optional<Trial> coarser;  ///< the winner with fewer steps, or ten times the tolerance
  std::string limit;             ///< see limit_of() in limit.hpp
  std::string growth;            ///< see growth_of() in limit.hpp; empty: nothing is to be said
  std::map<std::string, std::vector<std::string>> not_tried;  ///< solvers by reason
  bool cut = false;        ///< the seconds were over before the race was
  bool disturbed = false;  ///< other programs ran, or the processor's speed changed

  /// Whether the first has no larger error than the second, within a tenth and the truth's own.
  bool same_error(const Trial& one, const Trial& than) const {
    return one.error <= std::max(1.1 * than.error, than.error + 2 * floor);
  }
};

/// Makes the race on cases of one problem with other parameters, one at least: each setting has to
/// do what is asked on all of them, and times are means. They have to know their truth at their
/// stops. Throws Interrupted, and std::invalid_argument where no solver is selected or none fits,
/// or a wish makes no sense for the problem.
Advice advise(const std::vector<const Case*>& cases, const Wishes& asked);

}  // namespace odeum::advise
