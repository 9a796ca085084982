// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// Changes states as rounding does, by far more: by `moved_by` of themselves up or down.
class Disturbance {
 public:
  void move(State& y) {
    for (Real& x : y) {
      bits_ = bits_ * 6364136223846793005U + 1442695040888963407U;  // Knuth's generator
      x *= 1 + ((bits_ >> 63U) != 0 ? moved_by : -moved_by);
    }
  }

 private:
  std::uint64_t bits_ = 1;
};

/// Whether the slope of a solution that ends by vanishing steps grows without bound towards that
/// time, and no solution goes on beyond it.
class Ending {
 public:
  void add(Real t, const State& y) {
    times_.push_back(t);
    states_.push_back(y);
    if (times_.size() > 2 * most) {
      times_.erase(times_.begin(), times_.begin() + most);
      states_.erase(states_.begin(), states_.begin() + most);
    }
  }
  /// Whether the solution itself ends at t, whose rounding is `unit`.
  bool is_of_solution(const System& system, Real t, const State& y, Real unit) const {
    // The slope grows as (end - t)^-p; with p < 1 the solution is finite.
    State f(y.size()), g(y.size());
    const auto far = place_before(t, 1e6L * unit), near = place_before(t, 1e3L * unit);
    if (near <= far || near == times_.size()) return false;
    system.rhs(times_[far], states_[far].data(), g.data());
    system.rhs(times_[near], states_[near].data(), f.data());
    const Real apart = std::log((t - times_[far]) / (t - times_[near]));
    Real power = 0;
    std::size_t of = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const Real grown = std::log(std::abs(f[i] / g[i])) / apart;
      if (!(grown > power)) continue;
      power = grown;
      of = i;
    }
    constexpr Real pole = 0.98L, bounded = 0.05L;
    if (power > pole) return true;
    if (!(power > bounded)) return false;
    // A root, beyond which another solution may go on: as far from its end as `near` is.
    State beyond(y);
    for (std::size_t i = 0; i < y.size(); ++i) beyond[i] += y[i] - states_[near][i];
    const auto& rhs = system.whole_rhs ? system.whole_rhs : system.rhs;
    rhs(2 * t - times_[near], beyond.data(), g.data());
    return !(g[of] * f[of] > 0);
  }

 private:
  static constexpr std::ptrdiff_t most = 400;
  /// The last step that began so long before.
  std::size_t place_before(Real t, Real before) const {
    std::size_t k = times_.size();
    while (k > 0 && t - times_[k - 1] < before) --k;
    return k == 0 ? times_.size() : k - 1;
  }
  std::vector<Real> times_;
  std::vector<State> states_;
};

}  // namespace odeum::truth
