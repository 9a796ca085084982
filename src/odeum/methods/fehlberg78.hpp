// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"

namespace odeum::methods {

/// Fehlberg's 7(8) pair as published: the solution has order 7, the row of order 8 only estimates
/// the error. On y' = f(t) both rows give the same result, so that the estimate is zero.
inline constexpr Tableau<13> fehlberg78_tableau{
    .a = {{{0},
           {2. / 27},
           {1. / 36, 1. / 12},
           {1. / 24, 0, 1. / 8},
           {5. / 12, 0, -25. / 16, 25. / 16},
           {1. / 20, 0, 0, 1. / 4, 1. / 5},
           {-25. / 108, 0, 0, 125. / 108, -65. / 27, 125. / 54},
           {31. / 300, 0, 0, 0, 61. / 225, -2. / 9, 13. / 900},
           {2, 0, 0, -53. / 6, 704. / 45, -107. / 9, 67. / 90, 3},
           {-91. / 108, 0, 0, 23. / 108, -976. / 135, 311. / 54, -19. / 60, 17. / 6, -1. / 12},
           {2383. / 4100, 0, 0, -341. / 164, 4496. / 1025, -301. / 82, 2133. / 4100, 45. / 82,
            45. / 164, 18. / 41},
           {3. / 205, 0, 0, 0, 0, -6. / 41, -3. / 205, -3. / 41, 3. / 41, 6. / 41},
           {-1777. / 4100, 0, 0, -341. / 164, 4496. / 1025, -289. / 82, 2193. / 4100, 51. / 82,
            33. / 164, 12. / 41, 0, 1}}},
    .b = {41. / 840, 0, 0, 0, 0, 34. / 105, 9. / 35, 9. / 35, 9. / 280, 9. / 280, 41. / 840},
    .order = 7,
    .b_hat = {0, 0, 0, 0, 0, 34. / 105, 9. / 35, 9. / 35, 9. / 280, 9. / 280, 0, 41. / 840,
              41. / 840},
    .order_hat = 8,
};
static_assert(proven<fehlberg78_tableau>());

struct fehlberg78 : ForAnyProblem, ExplicitRungeKuttaMethod<fehlberg78_tableau> {
  static constexpr MethodInfo info =
      described({.id = "fehlberg78",
                 .source = "Fehlberg, NASA TR R-287 (1968), table X; Hairer, Norsett, Wanner, "
                           "Solving ODEs I, II.5"});
};

}  // namespace odeum::methods
