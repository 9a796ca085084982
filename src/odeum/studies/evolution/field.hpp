// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odeum/fem/semi_discrete.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::study {

/// The heat or the wave equation by linear elements on right triangles of the unit square, with
/// all solvers enrolled.
class Field {
 public:
  Field(bool wave, std::size_t divisions, fem::Mass mass, bool with_modes,
        const std::function<double(fem::Point)>& start);

  const fem::SemiDiscrete& system() const { return *system_; }
  const std::vector<double>& start() const { return case_.y0; }
  /// The state after equal steps; empty where the solver failed, and `detail` says why.
  std::vector<double> after(const std::string& solver, double end, std::size_t steps,
                            std::string* detail = nullptr) const;
  /// Multiplications of the last run.
  double work() const { return *system_->multiplications; }
  /// Root of u^T M u, of a lumped mass.
  double norm(const std::vector<double>& u) const;

 private:
  std::shared_ptr<const fem::SemiDiscrete> system_;
  Case case_;
};

}  // namespace odeum::study
