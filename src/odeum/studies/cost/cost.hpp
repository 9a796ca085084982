// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/record/rows.hpp"
#include "odeum/studies/stopwatch.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// What a step of a cloth costs a particle: a line of cloth_cost.csv.
struct ClothCostRow : WallTimes {
  std::uint64_t side = 0;  ///< particles along an edge of the square
  std::string precision;   ///< f64, f32
  Conditions conditions;

  static constexpr const char* file = "cloth_cost.csv";
  static constexpr const char* shown = "side precision wall_ns_min:.1f wall_ns_median:.1f";
  static constexpr bool keeps_earlier = true;
  ODEUM_COLUMNS(side, precision, wall_ns_min, wall_ns_median, repetitions, conditions)
};

/// One way to step a cloth of one stiffness at one frame, for a simulated second: a line of
/// implicit_wins.csv.
struct ImplicitWinsRow : WallTimes {
  double stiffness = nan;  ///< N/m
  double frame = nan;      ///< s; of explicit engines NaN, they step as they can
  std::string engine;      ///< verlet_f32, imex_f32, implicit_f64
  std::string status, detail;
  double step = nan;  ///< s
  /// RMS distance of particles from a run of RK4 in f64 (m), and of that from one at twice its
  /// step. No independent truth exists at this size.
  double rk4_distance = nan, rk4_left = nan;
  Conditions conditions;

  static constexpr const char* file = "implicit_wins.csv";
  static constexpr const char* shown =
      "stiffness frame:.3g engine step:.3g wall_ns_min:.3g rk4_distance:.2g status";
  static constexpr int schema = 2;
  static constexpr bool keeps_earlier = true;
  ODEUM_COLUMNS(stiffness, frame, engine, status, step, wall_ns_min, wall_ns_median, repetitions,
                rk4_distance, rk4_left, conditions, detail)
};

struct CostResult {
  std::vector<ClothCostRow> cost;
  std::vector<ImplicitWinsRow> implicit_wins;
  static auto lists(auto& result) { return std::tie(result.cost, result.implicit_wins); }
};

/// Particles along an edge of the cloth on which explicit and implicit steps are timed.
inline constexpr std::size_t timed_cloth_side = 32;
/// How long that runs (s, a whole number of every frame), to what its linear systems are solved,
/// and its explicit steps over the largest stable one.
inline constexpr double timed_cloth_time = 8.0 / 30, timed_cloth_residual = 1e-2,
                        timed_cloth_margin = 0.9;

/// Own engines, timed alternately on one processor.
std::vector<ClothCostRow> measure_cloth_cost(const std::vector<std::size_t>& sides,
                                             double seconds_each);
std::vector<ImplicitWinsRow> measure_implicit_wins(std::size_t side,
                                                   const std::vector<double>& stiffnesses,
                                                   const std::vector<double>& frames,
                                                   double seconds_each);

}  // namespace odeum::study
