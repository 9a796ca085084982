// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/scaled.hpp"

namespace odeum::adapters::odeint {

ScaledProblem::ScaledProblem(const Contest<SharedOde>& contest, const Request& request)
    : original_(contest), thresholds_(request.tolerance.thresholds), y_(thresholds_.size()) {}

void ScaledProblem::rhs(double t, const double* z, double* dzdt) const {
  for (std::size_t i = 0; i < size(); ++i) y_[i] = z[i] * thresholds_[i];
  original_.problem->rhs(t, y_.data(), dzdt);
  for (std::size_t i = 0; i < size(); ++i) dzdt[i] /= thresholds_[i];
}

Contest<SharedOde> ScaledProblem::contest() const {
  auto z0 = std::make_shared<std::vector<double>>(*original_.y0);
  for (std::size_t i = 0; i < z0->size(); ++i) (*z0)[i] /= thresholds_[i];
  return {std::make_shared<const SharedOde>(view_of(*this), nullptr), original_.t0, z0,
          original_.scene};
}

void ScaledProblem::unscale(Outcome& outcome) const {
  for (std::size_t k = 0; k < outcome.states.size(); ++k)
    outcome.states[k] *= thresholds_[k % thresholds_.size()];
}

}  // namespace odeum::adapters::odeint
