// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/studies/cloth/rows.hpp"
#include "odeum/studies/scene_stage.hpp"

namespace odeum::study {

/// Particles along an edge.
inline constexpr std::size_t cloth_side = 11;

/// The runs from which an error is split.
struct SplitPlan {
  double time = 0.25;                ///< s
  std::vector<std::uint64_t> steps;  ///< each twice the one before, at least three
  std::vector<Iterations> tried;
  Iterations converged, half;  ///< the largest number, and half of it to estimate its error
  double order = 1;            ///< of the step, for the extrapolation to h -> 0
};
/// Positions at plan.time; where the run failed, nothing and the reason.
struct Reached {
  std::optional<std::vector<double>> positions;
  std::string reason;
};
using RunCloth = std::function<Reached(std::uint64_t steps, const Iterations& iterations)>;

/// A row for each number of steps and each of plan.tried; library and solver are left empty.
std::vector<ErrorPartsRow> split_error(const SplitPlan& plan, const RunCloth& run,
                                       const std::vector<double>& truth);
ClothResult measure_error_parts(const Options& options, const Runner& runner = Runner());

/// Drape, energy and momentum of cloths over 10 s.
ClothResult measure_long_runs(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
