// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/rosenbrock.hpp"

namespace odeum::methods {

/// RODAS: six stages, stiffly accurate and L-stable, as is its embedded row of order 3.
inline constexpr RosenbrockTableau<6> rodas4_tableau{
    .gamma = 0.25,
    .a = {{{0},
           {1.544},
           {0.9466785280815826, 0.2557011698983284},
           {3.314825187068521, 2.896124015972201, 0.9986419139977817},
           {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
           {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}}},
    .c = {{{0},
           {-5.6688},
           {-2.430093356833875, -0.2063599157091915},
           {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
           {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
           {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136,
            -6.058818238834054}}},
    .m = {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1, 1},
    .order = 4,
    .m_hat = {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1},
    .order_hat = 3,
    .rounding = 1e-11,
};
static_assert(proven<rodas4_tableau>());

struct rodas4 : ForAnyProblem, RosenbrockMethod<rodas4_tableau> {
  static constexpr MethodInfo info = described(
      {.id = "rodas4",
       .control = Control::predictive,
       .source = "Hairer, Wanner, Solving ODEs II, VI.4; coefficients of their code RODAS, set 1"});
  static constexpr auto inlined = Inlined::stiff;
};

}  // namespace odeum::methods
