// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/core/progress.hpp"
#include "odeum/solvers/settings.hpp"
#include "odeum/why/why.hpp"

/// The parts of why(): each measures, and adds what it found.
namespace odeum::why {

/// A run whose end is off by more than this share of the solution's size is not an answer.
inline constexpr double far_off = 0.02;
/// The tolerance at a fixed step, where none was asked for.
inline constexpr double usual_tolerance = 1e-6;

/// The state at the end of the run.
struct Known {
  std::vector<double> end;
  double doubt = 0;  ///< by how much two runs differ, over the sizes of the components
  std::string by;    ///< the truth, or the two
};

/// What is known of a run at one of its states.
struct Sample {
  Moment at;
  double weight = 0;  ///< steps that it stands for
  Spectrum spectrum = {};
  double rate = 0;                 ///< of the solution, largest |f_i| over the size of y_i
  std::complex<double> binding{};  ///< the eigenvalue that is nearest to the edge, or beyond it
  double used = nan;               ///< h |binding| over the edge; NaN: no edge is known
  double looser = nan;             ///< how much longer steps are under a looser tolerance
  std::optional<Cause> cause = {};
};

struct Inquiry {
  Inquiry(const Case& given, const std::string& solver, const Request& request, double seconds,
          cases::Conditions conditions_given);

  const Case& c;
  cases::Conditions conditions;
  Why why;
  double seconds;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double processor_start;

  Run run;
  std::vector<Run> others;  ///< in the order of why.others
  std::optional<Known> known;
  std::optional<Run> trusted;  ///< one that ends there
  /// Two runs of different families to a hundredth of the tolerance, where none is trusted.
  std::optional<std::pair<Run, Run>> disagree;
  /// The largest factor by which the problem itself makes an error grow up to the end, of the sizes
  /// of the components; 0: it was not measured.
  double amplification = 0;
  /// Whether rounding itself grows to a part of the solution.
  bool no_tolerance_helps() const { return 1e-13 * amplification > far_off; }
  double pulse = 0, period = 0;  ///< as long as what the run does not see; 0: nothing was found
  std::optional<Run> looser;     ///< of an adaptive run
  double looser_by = 100;        ///< its tolerance over the run's; below 1: there was no room
  bool parted = false;           ///< whether that run ends elsewhere
  std::vector<double> sizes;     ///< by component, the largest along the solution
  std::vector<Sample> samples;
  std::vector<Kink> kinks;
  mutable Progress progress{"why", 20};
  double kink_reach = 0;           ///< how far from one its steps are taken to be short for it
  std::vector<std::string> names;  ///< of the components
  bool trust_jacobian = true;
  Region region;

  /// The name of a component; one that is not known is called the state.
  std::string name_of(const std::optional<std::size_t>& component) const {
    return component ? names[*component] : "the state";
  }
  bool adaptive() const { return run.request.mode == Mode::adaptive; }
  /// Seconds of the processor, and at most three times as many by the clock.
  double left() const;
  Run make(const Case& on, const std::string& solver, Request request, std::size_t moments,
           double share) const;
  /// Whether that share of the seconds is left.
  bool time_for_more(double share) const;
  void keep(const Run& from);
  /// Makes another run, if it was not made, and keeps it; returns its index in why.others.
  std::size_t also(const std::string& solver, const Request& request, double share);
  /// The same run with states along it.
  Run along(const Run& of) const;
  void find_sizes(const Run& from);
  void add(Cause cause, double share, double from, std::string text);
  bool found(Cause cause) const;
  /// Largest difference of a component between two states, relative to the component's size.
  double distance(const double* one, const double* other) const;
  double apart(const Run& one, const Run& other) const;
  /// Distance of a run's end from what is known of the solution; infinite where the run did not get
  /// there, NaN where nothing is known or it ends elsewhere.
  double difference(const Run& of) const;
  /// The error against the case's truth; NaN where that is not known.
  double error_at_end(const Request& request, const Outcome& outcome) const;
};

/// Evaluations, and those that Jacobians by differences would take: about ten where it is sparse.
double work_of(const Counters& counters, const Case& c);
/// How many states are taken along a run.
std::size_t states_along(const Inquiry& q);
/// Whether the right-hand side is another between evaluations of a run than they show.
bool has_unseen(const Inquiry& q, const Run& run);

/// The relative tolerance that was asked for; at a fixed step, where none was, the usual one.
double wanted(const Inquiry& q);

/// The request of other solvers: to the same tolerance, or to the usual one.
Request comparable(const Inquiry& q);
/// Runs of other solvers to the same tolerance, and by them, or by the truth, what is known of the
/// solution and of the sizes of components.
void try_others(Inquiry& q);
void find_known(Inquiry& q);
/// What the causes themselves suggest: the same solver with another setting, or a shorter run.
void try_settings(Inquiry& q);
/// Makes the cheapest of the others as exact as a run whose error is not at fault.
void try_as_exact(Inquiry& q);
/// Chooses the best of the others that do better.
void choose(Inquiry& q);
/// The run to a tolerance that came farthest, this one or another.
const Run& farthest(const Inquiry& q);

/// Spectrum and edge at the moments of `along`, with the steps that the run has at those times, or
/// of length `h`.
void sample(Inquiry& q, const Run& along, double h);
/// The solution's rate at the samples, and how much longer looser steps are.
void compare_samples(Inquiry& q);
/// The segments of the samples by their causes.
void make_segments(Inquiry& q);
/// What bounds each sample of an adaptive run, the segments of them, and findings by their shares.
void share_out(Inquiry& q);

/// Whether an event lies between two states of a run, so that no smooth path joins them.
bool has_event_between(const Run& run, const Moment& from, const Moment& to);
/// Each adds a finding where it is one.
void look_for_kinks(Inquiry& q);
void look_at_jacobian(Inquiry& q);
void look_at_tolerances(Inquiry& q);
/// A solution that changes at its start within the rounding of t.
void look_at_start(Inquiry& q);
/// Finds an absolute tolerance above the size of a component; the run with another one tells.
void look_at_absolutes(Inquiry& q);
/// A component that grows from below its absolute tolerance carries its error along, although it
/// is larger later.
void look_for_growth_from_below(Inquiry& q);
/// Pulses and periods that the run steps over.
void look_for_unseen(Inquiry& q);
/// How errors grow by the problem itself.
void look_at_amplification(Inquiry& q);
/// Why a solution ends: pole, growth, slope or domain, by the run that came farthest.
void look_at_end(Inquiry& q, const Run& run);
/// Where the steps of a run that fails lie beyond the edge along a solution that is trusted.
void look_at_edge(Inquiry& q);
/// Where a run that fails, or ends far off, had left the solution that others follow to the end,
/// and runs to tighter tolerances, of which one ends near it.
void look_for_leaving(Inquiry& q);
/// Instability, energy and coarseness of a fixed step, by a solution that is trusted.
void look_at_fixed_step(Inquiry& q);
/// Whether the method feeds or damps an undamped motion that its steps resolve, `off` from the
/// solution at the end.
void look_at_energy(Inquiry& q, double step, double off);

}  // namespace odeum::why
