// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/scene/model/scene.hpp"

namespace odeum::study {

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

  /// Of the slowest mode: angular frequency (1/s) without damping, damping ratio, and the mode's
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

}  // namespace odeum::study
