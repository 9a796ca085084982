// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/scene/model/scene.hpp"

namespace odeum::study {

/// Springs whose answer is known: `masses` equal ones hung one below the other from a fixed point,
/// each on a spring of `length` at rest. Small weights, so that every strain is below 1 %.
struct Specimen {
  std::string name;
  std::size_t masses = 1;
  double mass = 0.1;        ///< kg
  double stiffness = 1000;  ///< N/m
  double damping = 1;       ///< N s/m
  double length = 1;        ///< m
  double gravity = 1;       ///< m/s^2

  /// Of the slowest mode: angular frequency (1/s) without damping, damping ratio, and how far each
  /// mass moves, the lowest by 1.
  double frequency() const;
  double damping_ratio() const;
  std::vector<double> shape() const;
  /// How far the lowest mass hangs below where it is without gravity, m.
  double sag() const;
  scene::Scene scene() const;
};
Specimen one_mass();
Specimen hanging_chain();  ///< ten masses

}  // namespace odeum::study
