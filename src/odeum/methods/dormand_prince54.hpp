// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/dense_output.hpp"
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Dormand and Prince's pair 5(4): the solution has order 5, the embedded row order 4. First same
/// as last.
inline constexpr Tableau<7> dormand_prince54_tableau{
    .a = {{{0},
           {1. / 5},
           {3. / 40, 9. / 40},
           {44. / 45, -56. / 15, 32. / 9},
           {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
           {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
           {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}}},
    .b = {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
    .order = 5,
    .b_hat = {5179. / 57600, 0, 7571. / 16695, 393. / 640, -92097. / 339200, 187. / 2100, 1. / 40},
    .order_hat = 4,
};
static_assert(proven<dormand_prince54_tableau>());

/// The row d of its interpolant of order 4, see kernel/dense_output.hpp (Hairer, Norsett, Wanner,
/// Solving ODEs I, II.6).
inline constexpr std::array<double, 7> dormand_prince54_dense_row{
    -12715105075. / 11282082432,  0,
    87487479700. / 32700410799,   -10690763975. / 1880347072,
    701980252875. / 199316789632, -1453857185. / 822651844,
    69997945. / 29380423};
static_assert(interpolates<dormand_prince54_tableau, dormand_prince54_dense_row>());

struct dormand_prince54 : ForAnyProblem, ExplicitRungeKuttaMethod<dormand_prince54_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "dormand_prince54",
       .common_use = CommonUse::tolerance,
       .source = "Dormand, Prince, J. Comput. Appl. Math. 6 (1980) 19-26, table 2 (RK5(4)7M)"});
  static constexpr auto inlined = Inlined::nonstiff;
  static constexpr const auto& dense_row = dormand_prince54_dense_row;
};

}  // namespace odeum::methods
