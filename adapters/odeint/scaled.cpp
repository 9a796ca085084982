// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/scaled.hpp"

namespace odeum::adapters::odeint {

ScaledProblem::ScaledProblem(const Contest<SharedOde>& contest, const Request& request)
    : original_(contest), thresholds_(request.tolerances().thresholds), y_(thresholds_.size()) {}

void ScaledProblem::rhs(const void* self, double t, const double* z, double* dzdt) {
  const auto& scaled = *static_cast<const ScaledProblem*>(self);
  const std::vector<double>& thresholds = scaled.thresholds_;
  for (std::size_t i = 0; i < thresholds.size(); ++i) scaled.y_[i] = z[i] * thresholds[i];
  scaled.original_.problem->rhs(t, scaled.y_.data(), dzdt);
  for (std::size_t i = 0; i < thresholds.size(); ++i) dzdt[i] /= thresholds[i];
}

Contest<SharedOde> ScaledProblem::contest() const {
  const OdeView view{.problem = this, .dimension = thresholds_.size(), .rhs = rhs};
  auto z0 = std::make_shared<std::vector<double>>(*original_.y0);
  for (std::size_t i = 0; i < z0->size(); ++i) (*z0)[i] /= thresholds_[i];
  return {std::make_shared<const SharedOde>(view, nullptr), original_.t0, z0, original_.scene};
}

void ScaledProblem::unscale(Outcome& outcome) const {
  for (std::size_t k = 0; k < outcome.states.size(); ++k)
    outcome.states[k] *= thresholds_[k % thresholds_.size()];
}

}  // namespace odeum::adapters::odeint
