// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "odeum/trajectories/case_runs.hpp"

/// Solutions over time, for the page.
namespace odeum::trajectories {

/// A run until `end` with output at so many times or fewer: at a fixed step (the setting) at whole
/// steps, to a tolerance at equal distances, over which own solvers step.
inline constexpr std::uint64_t drawn_outputs = 100;
Request drawn_request(const Case& c, Mode mode, double setting, double end, const Budget& budget,
                      std::uint64_t outputs = drawn_outputs);

/// The components of a case that are drawn, at most four: all of a small problem; of a larger one
/// of second order the coordinate that moves most and its velocity.
std::vector<std::size_t> drawn_components(const Case& c);

/// The truth where it is known at all the times (ascending); else a run of `truth` (extrapolation
/// in extended precision) where that meets the truth at the case's own stops to 1e-6 of its size;
/// else the truth at the stops.
ExactStates exact_curve(const Case& c, const std::vector<double>& times);

/// Runs with a common end as JSON: the drawn components in thousandths of their range, errors and
/// energy errors as hundredths of their decimal logarithm. Made for
/// reports/viewer/solution.js.
class Solutions {
 public:
  Solutions(const Case& c, double end, ExactStates exact);
  /// Adds a run with its outcome; nothing where it has no output.
  void add(const CaseRun& run);
  nlohmann::ordered_json json() const;

 private:
  std::vector<int> levels(const double* y) const;
  std::size_t curve(std::vector<int> values);

  const Case& case_;
  double end_;
  ExactStates exact_;
  std::vector<std::size_t> components_;
  std::vector<double> low_, high_;
  double energy_scale_ = 0;
  std::vector<std::vector<int>> curves_;
  nlohmann::ordered_json runs_ = nlohmann::ordered_json::object();
};

}  // namespace odeum::trajectories
