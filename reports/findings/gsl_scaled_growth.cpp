// SPDX-License-Identifier: BSD-3-Clause
// GSL alone: gsl_odeiv2_control_scaled_new with all scales 1 and gsl_odeiv2_control_standard_new
// have the same error level, and let a step grow by 4.9 and by 5 at most.
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace {
double after(gsl_odeiv2_control* control, gsl_odeiv2_step* step, double error) {
  const double y = 1, dydt = 1;
  double h = 1;
  gsl_odeiv2_control_hadjust(control, step, &y, &error, &dydt, &h);
  gsl_odeiv2_control_free(control);
  return h;
}
}  // namespace

int main() {
  gsl_odeiv2_step* const step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rkf45, 1);
  const double level = 2e-6, scale = 1;  // abs + rel |y|, both 1e-6
  bool holds = true;
  for (const double part : {1e-9, 1e-5, 1e-2, 0.3, 0.8, 2.0, 1e3}) {
    const double standard =
        after(gsl_odeiv2_control_standard_new(1e-6, 1e-6, 1, 0), step, part * level);
    const double scaled =
        after(gsl_odeiv2_control_scaled_new(1e-6, 1e-6, 1, 0, &scale, 1), step, part * level);
    std::printf("error %.0e of the level: step 1 becomes %.6g (standard), %.6g (scaled)\n", part,
                standard, scaled);
    const bool largest = part < 1e-4;
    holds = holds && std::abs(standard - (largest ? 5 : scaled)) < 1e-12 &&
            (!largest || std::abs(scaled - 4.9) < 1e-12);
  }
  gsl_odeiv2_step_free(step);
  return holds ? 0 : 1;
}
