// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

/// Solutions over time, for the page.
namespace odeum::trajectories {

/// A run to draw: which one, and where it ends.
struct DrawnRun {
  const Entrant* entrant = nullptr;
  Mode mode = Mode::fixed;
  std::uint64_t steps = 0;  ///< fixed
  double tolerance = 0;     ///< adaptive
  double end = 0;           ///< the horizon
};

/// The run with output at some 100 times: at a fixed step at whole steps, to a tolerance at equal
/// distances, over which own solvers step. `evaluations`: its budget.
Request drawn_request(const Case& c, const DrawnRun& run, std::uint64_t evaluations);

/// The components of a case that are drawn, at most four: all of a small problem; of a larger one
/// of second order the coordinate that moves most and its velocity.
std::vector<std::size_t> drawn_components(const Case& c);

/// The exact states at times (ascending).
struct ExactCurve {
  std::vector<double> times, states;  ///< those known, one state after the other
  bool everywhere = false;            ///< at all the times that were asked for
  /// Bound of their error: the truth's, or the largest difference to it where they are computed.
  double floor = 0;
  std::string source;

  /// Null where it is not known at that time.
  const double* at(double t) const;
  std::size_t size = 0;  ///< of a state
};

/// The truth where it is known at all the times; else a run of `truth` (extrapolation in extended
/// precision) where that meets the truth at the case's own stops to 1e-6 of its size; else the
/// truth at the stops.
ExactCurve exact_curve(const Case& c, std::vector<double> times);

/// Runs with a common end as JSON: the drawn components in thousandths of their range, errors and
/// energy errors as hundredths of their decimal logarithm. Made for
/// reports/viewer/solution.js.
class Solutions {
 public:
  Solutions(const Case& c, double end, ExactCurve exact);
  /// Adds a run with its outcome; nothing where it has no output.
  void add(const DrawnRun& run, const Request& request, const Outcome& outcome);
  nlohmann::ordered_json json() const;

 private:
  std::vector<int> levels(const double* y) const;
  std::size_t curve(std::vector<int> values);

  const Case& case_;
  double end_;
  ExactCurve exact_;
  std::vector<std::size_t> components_, measured_;
  std::vector<double> low_, high_;
  double energy_scale_ = 0;
  std::vector<std::vector<int>> curves_;
  nlohmann::ordered_json runs_ = nlohmann::ordered_json::object();
};

}  // namespace odeum::trajectories
