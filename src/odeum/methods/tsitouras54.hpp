// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/dense_output.hpp"
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Tsitouras's pair 5(4), derived under the first column simplifying assumption only: the solution
/// has order 5, the embedded row order 4. First same as last.
inline constexpr Tableau<7> tsitouras54_tableau{
    .a = {{{0},
           {161. / 1000},
           {-8.4806554923569885444e-3, 0.33548065549235698854},
           {2.8971530571054934321, -6.3594484899750748431, 4.362295432869581411},
           {5.3258648284392566044, -11.748883564062827878, 7.4955393428898362083,
            -0.092495066361755249257},
           {5.8614554429464200287, -12.920969317847109292, 8.1593678985761586432,
            -0.071584973281400997225, -0.028269050394068382909},
           {0.096460766818065229518, 1. / 100, 0.47988965041449957478, 1.3790085741037418932,
            -3.2900695154360806799, 2.3247105240997739824}}},
    .b = {0.096460766818065229518, 1. / 100, 0.47988965041449957478, 1.3790085741037418932,
          -3.2900695154360806799, 2.3247105240997739824},
    .order = 5,
    .b_hat = {0.094680755765839458075, 9.1835655403432530968e-3, 0.48777052842476157079,
              1.2342975669304789857, -2.7077123499835254549, 1.8666284181705870358, 1. / 66},
    .order_hat = 4,
};
static_assert(proven<tsitouras54_tableau>());

/// The row d of its interpolant of order 4, see kernel/dense_output.hpp: the coefficients of
/// theta^4 in the paper's b_i(theta).
inline constexpr std::array<double, 7> tsitouras54_dense_row{-1.0530884977290216,
                                                             0.1017,
                                                             2.490627285651252793,
                                                             -16.54810288924490272,
                                                             47.37952196281928122,
                                                             -34.87065786149660974,
                                                             2.5};
static_assert(interpolates<tsitouras54_tableau, tsitouras54_dense_row>());

struct tsitouras54 : ForAnyProblem, ExplicitRungeKuttaMethod<tsitouras54_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "tsitouras54", .source = "Tsitouras, Comput. Math. Appl. 62 (2011) 770-775, table 1"});
  static constexpr const auto& dense_row = tsitouras54_dense_row;
};

}  // namespace odeum::methods
