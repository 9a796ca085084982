// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/cost/cloth_lanes.hpp"

#include "odeum/methods/imex_verlet.hpp"
#include "odeum/methods/predicted_implicit_euler.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/velocity_verlet.hpp"

namespace odeum::study {
namespace {

template <class Method, class Real>
class Steps final : public ClothSteps<Real> {
  using Stepper = typename Method::template Stepper<scene::GridCloth<Real>>;
  using ClothSteps<Real>::y_;

 public:
  template <class... Options>
  Steps(const scene::Scene& scene, std::size_t threads, Options... options)
      : ClothSteps<Real>(scene, threads), stepper_(*this->cloth_, options...) {}

  bool run(double h, std::uint64_t steps) override {
    const auto step = static_cast<Real>(h);
    if constexpr (requires { stepper_.start(step, step, y_); }) stepper_.start(0, step, y_);
    for (std::uint64_t i = 0; i < steps; ++i)
      if (stepper_.step(static_cast<Real>(static_cast<double>(i) * h), step, y_) != Status::ok)
        return false;
    return true;
  }

 private:
  Stepper stepper_;
};

}  // namespace

template <class Real>
std::unique_ptr<ClothSteps<Real>> velocity_verlet_steps(const scene::Scene& scene,
                                                        std::size_t threads) {
  return std::make_unique<Steps<methods::velocity_verlet, Real>>(scene, threads);
}
template std::unique_ptr<ClothSteps<double>> velocity_verlet_steps(const scene::Scene&,
                                                                   std::size_t);
template std::unique_ptr<ClothSteps<float>> velocity_verlet_steps(const scene::Scene&, std::size_t);

std::unique_ptr<ClothSteps<double>> rk4_steps(const scene::Scene& scene) {
  return std::make_unique<Steps<methods::rk4, double>>(scene, 1);
}
std::unique_ptr<ClothSteps<float>> imex_verlet_steps(const scene::Scene& scene, double relative,
                                                     std::size_t threads) {
  return std::make_unique<Steps<methods::imex_verlet, float>>(scene, threads, relative);
}
std::unique_ptr<ClothSteps<double>> predicted_implicit_euler_steps(const scene::Scene& scene,
                                                                   double relative) {
  return std::make_unique<Steps<methods::predicted_implicit_euler, double>>(scene, 1, relative);
}

}  // namespace odeum::study
