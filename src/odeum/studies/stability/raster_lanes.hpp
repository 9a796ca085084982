// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace odeum::study {

/// y' = z y for L complex values of z at once, as 2L real unknowns: the real parts of all, then the
/// imaginary parts. To an explicit method's kernel it is a problem like any other, whose loops over
/// the unknowns become vector instructions.
template <std::size_t L>
struct DahlquistLanes {
  static constexpr std::size_t dimension = 2 * L;
  std::array<double, L> re{}, im{};

  void rhs(double, const double* y, double* dydt) const {
    for (std::size_t i = 0; i < L; ++i) {
      dydt[i] = re[i] * y[i] - im[i] * y[L + i];
      dydt[L + i] = im[i] * y[i] + re[i] * y[L + i];
    }
  }
};

/// Eight 512-bit vectors for a state. Measured on RK4 (g++ 12): from 24 to 56 lanes the loops are
/// completely unrolled and most of a step stays in registers, 1.0 ns per step and lane; 64 take 2
/// ns.
inline constexpr std::size_t lanes = 32;

/// Takes `steps` steps of size 1 from y = 1 for each of `count` values of z (any number) and puts
/// the squared modulus |y|^2 of each into `squared`.
using LaneRunner = void (*)(const double* re, const double* im, std::size_t count, unsigned steps,
                            double* squared);

/// The runner of an own explicit Runge-Kutta method; null for any other method.
LaneRunner find_lane_runner(std::string_view method);

}  // namespace odeum::study
