// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/record/rows.hpp"

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

}  // namespace odeum::study
