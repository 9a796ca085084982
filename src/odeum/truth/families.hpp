// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// Two methods that share no formula.
struct Family {
  Method first, second;
  const char* words;
  Method for_moved;            ///< the cheaper one of those without a series
  Real finest;                 ///< tolerance below which `second` does the same
  std::array<Real, 2> orders;  ///< work grows as the tolerance to -1 / order
};

/// Two runs and how they differ.
struct Comparison {
  Run a, b;
  bool spent = false;        ///< one of them ended for the work that it took
  double seconds = 0;        ///< of both
  std::vector<State> apart;  ///< by time and component, as far as both came
  Real worst = 0;            ///< of those that are known
  std::size_t known = 0;     ///< times at which they agree
};

inline constexpr Family plain{
    verner_run, extrapolation_run, "Verner's pair 9(8) and Gragg's extrapolation", verner_run, 0,
    {9, 13}};
/// The weights of extrapolation amplify rounding: where there is a series, it is not needed.
inline constexpr Family by_series{taylor_run, verner_run, "Taylor's series and Verner's pair 9(8)",
                                  verner_run, 0,          {28, 9}};
/// Its first method estimates an error of four orders less.
inline constexpr Family implicit_family{
    radau_run,
    implicit_extrapolation_run,
    "Radau IIA of order 13 and the extrapolated implicit Euler method",
    radau_run,
    finest_implicit_extrapolation,
    {12, 8}};

}  // namespace odeum::truth
