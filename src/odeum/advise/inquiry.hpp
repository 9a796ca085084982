// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "odeum/advise/why.hpp"
#include "odeum/solvers/settings.hpp"

/// The parts of why(): each measures, and adds what it found.
namespace odeum::advise {

/// Of the solution's size: no answer, whatever it cost.
inline constexpr double far_off = 0.02;

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
  Inquiry(const Case& given, const std::string& solver, const Request& request, double seconds);

  const Case& c;
  Why why;
  double seconds;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  Run run;
  std::vector<Run> others;     ///< in the order of why.others
  std::optional<Run> trusted;  ///< one that came to the end, to a hundredth of the tolerance,
  bool sure = false;           ///< where that could be paid for
  std::optional<Run> looser;   ///< of an adaptive run
  double looser_by = 100;      ///< its tolerance over the run's; below 1: there was no room
  std::vector<double> sizes;   ///< by component, the largest along the solution
  std::vector<Sample> samples;
  std::vector<Kink> kinks;
  double kink_reach = 0;           ///< how far from one its steps are taken to be short for it
  std::vector<std::string> names;  ///< of the components
  bool trust_jacobian = true;
  Region region;

  /// Of a component that may not be known.
  std::string name_of(const std::optional<std::size_t>& component) const {
    return component ? names[*component] : "the state";
  }
  bool adaptive() const { return run.request.mode == Mode::adaptive; }
  double left() const;  ///< seconds
  Run make(const Case& on, const std::string& solver, Request request, std::size_t moments,
           double share) const;
  /// Makes another run and keeps it; returns its index in why.others.
  std::size_t also(const std::string& solver, const Request& request, double share);
  /// The same run with states along it.
  Run along(const Run& of) const;
  void find_sizes(const Run& from);
  void add(Cause cause, double share, double from, std::string text);
  bool found(Cause cause) const;
  /// Of a run's end from that of the trusted one, over the sizes of the components, the largest;
  /// infinite where the run did not get there, NaN where none is trusted or it ends elsewhere.
  double difference(const Run& of) const;
  /// From the case's truth; NaN where that is not known.
  double error_at_end(const Request& request, const Outcome& outcome) const;
};

/// Runs of other solvers to the same tolerance, one that is trusted, and the sizes of components.
void try_others(Inquiry& q);
/// What the causes themselves suggest: the same solver with another setting, or a shorter run.
void try_settings(Inquiry& q);
/// Of the others the best that does better.
void choose(Inquiry& q);
/// The run to a tolerance that came farthest, this one or another.
const Run& farthest(const Inquiry& q);

/// Spectrum, rate, edge and looser steps at the moments of `along`, with the steps that the run has
/// at those times, or of length `h`.
void sample(Inquiry& q, const Run& along, double h);
/// The segments of the samples by their causes.
void make_segments(Inquiry& q);
/// What bounds each sample of an adaptive run, the segments of them, and findings by their shares.
void share_out(Inquiry& q);

/// Each adds a finding where it is one.
void look_for_kinks(Inquiry& q);
void look_at_jacobian(Inquiry& q);
void look_at_tolerances(Inquiry& q);
/// Why a solution ends: pole, growth, slope or domain, by the run that came farthest.
void look_at_end(Inquiry& q, const Run& run);
/// Where the steps of a run that fails lie beyond the edge along a solution that is trusted.
void look_at_edge(Inquiry& q);
/// Where a run that fails, or ends far off, had left the solution that others follow to the end,
/// and runs to tighter tolerances, of which one ends near it.
void look_for_leaving(Inquiry& q);
/// Instability, energy and coarseness of a fixed step, by a solution that is trusted.
void look_at_fixed_step(Inquiry& q);

}  // namespace odeum::advise
