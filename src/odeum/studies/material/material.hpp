// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/studies/scene_stage.hpp"

namespace odeum::study {

/// What a solver makes of springs of known stiffness and damping: a line of material.csv.
struct MaterialRow {
  std::string scene;  ///< one_mass, hanging_chain
  std::string library, solver;
  /// A Status, `unstable`, `not_applicable`, or `unmeasured` where it ran but numbers are missing.
  std::string status, detail;
  double step = nan;                     ///< s
  std::uint64_t sweeps = 0;              ///< option of the engine; 0: its own
  std::uint64_t newton = 0;              ///< option of the engine; 0: its own
  double phase = nan;                    ///< step times the slowest mode's frequency, radians
  double static_stiffness_ratio = nan;   ///< stiffness shown at rest / nominal
  double dynamic_stiffness_ratio = nan;  ///< stiffness shown by the slowest mode / nominal
  double damping = nan;                  ///< damping shown by the slowest mode / nominal
  double added_damping_ratio = nan;      ///< damping ratio shown less the nominal one

  static constexpr const char* file = "material.csv";
  static constexpr const char* shown =
      "scene solver step:.3g sweeps newton static_stiffness_ratio:.3g dynamic_stiffness_ratio:.3g "
      "damping:.3g added_damping_ratio:.2g status";
  static constexpr int schema = 2;  ///< 2: the names of both stiffness ratios
  ODEUM_COLUMNS(scene, library, solver, status, step, sweeps, newton, phase, static_stiffness_ratio,
                dynamic_stiffness_ratio, damping, added_damping_ratio, detail)
};

struct MaterialResult {
  std::vector<MaterialRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// A hanging chain with known static and dynamic response: `masses` equal masses below a fixed
/// point, each on a spring of rest length `length`. Weights are small, so that every strain is
/// below 1 %.
struct Specimen {
  std::string name;
  std::size_t masses = 1;
  double mass = 0.1;        ///< kg
  double stiffness = 1000;  ///< N/m
  double damping = 1;       ///< N s/m
  double length = 1;        ///< m
  double gravity = 1;       ///< m/s^2

  /// The slowest mode: angular frequency (1/s) without damping, damping ratio, and the mode's
  /// shape, 1 at the lowest mass.
  double frequency() const;
  double damping_ratio() const;
  std::vector<double> shape() const;
  /// Sag of the lowest mass under gravity, m.
  double sag() const;
  scene::Scene scene() const;
};
Specimen one_mass();
Specimen hanging_chain();  ///< ten masses

/// Lets the specimen settle under gravity, then oscillate in its slowest mode, at steps of about
/// `step` seconds.
MaterialRow measure_response(const Specimen& specimen, const SceneStage& stage,
                             const Entrant& entrant, double step, const Iterations& iterations);
MaterialResult measure_material(const Options& options, const Runner& runner = Runner());

/// The oscillator z'' + decay z' + omega_squared (z - rest) = 0 that passes through the samples of
/// a motion: exactly so for any linear scheme of two unknowns.
struct Vibration {
  double omega_squared = 0;  ///< k/m, 1/s^2
  double decay = 0;          ///< d/m, 1/s
  std::string reason = {};   ///< why no oscillator fits, a sentence; empty: one does
};

/// Fits z[j + lag] = a z[j] + b z[j - lag] + c by least squares and takes the logarithms of the
/// roots of x^2 = a x + b; the lag is about a sixth of a turn. Samples are `step` s apart; z starts
/// displaced, with velocity 0.
Vibration fit_vibration(const std::vector<double>& z, double step);

}  // namespace odeum::study
