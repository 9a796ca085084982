/* SPDX-License-Identifier: BSD-3-Clause */
/* Three problems: a driven oscillator q'' = -4 q + 3 sin t, q = sin t, a linear chain of cooling
 * rods with a banded Jacobian, and a pendulum q'' = -sin q, whose solution Odeum computes. */
#include <math.h>
#include <odeum/plugin.h>

static int acceleration(void* data, double t, const double* q, const double* v, double* a) {
  (void)data, (void)v;
  a[0] = -4 * q[0] + 3 * sin(t);
  return 0;
}
static int rhs(void* data, double t, const double* y, double* dydt) {
  dydt[0] = y[1];
  return acceleration(data, t, y, y + 1, dydt + 1);
}
static int jacobian(void* data, double t, const double* y, double* j) {
  (void)data, (void)t, (void)y;
  j[0] = 0, j[1] = 1, j[2] = -4, j[3] = 0;
  return 0;
}
static int time_derivative(void* data, double t, const double* y, double* d) {
  (void)data, (void)y;
  d[0] = 0, d[1] = 3 * cos(t);
  return 0;
}
static int exact(void* data, double t, double* y) {
  (void)data;
  y[0] = sin(t), y[1] = cos(t);
  return 0;
}

enum { rods = 8 };
/* The slowest mode decays at this rate and keeps its shape. */
static double rate(void) { return 2 - 2 * cos(acos(-1.0) / (rods + 1)); }
static double shape(size_t i) { return sin(acos(-1.0) * (double)(i + 1) / (rods + 1)); }
static int chain_rhs(void* data, double t, const double* y, double* dydt) {
  (void)data, (void)t;
  for (size_t i = 0; i < rods; ++i)
    dydt[i] = (i ? y[i - 1] : 0) - 2 * y[i] + (i + 1 < rods ? y[i + 1] : 0);
  return 0;
}
static int chain_jacobian(void* data, double t, const double* y, double* j) {
  (void)data, (void)t, (void)y;
  for (size_t i = 0; i < rods; ++i) j[3 * i] = 1, j[3 * i + 1] = -2, j[3 * i + 2] = 1;
  return 0;
}
static int chain_exact(void* data, double t, double* y) {
  (void)data;
  for (size_t i = 0; i < rods; ++i) y[i] = exp(-rate() * t) * shape(i);
  return 0;
}

static int swing(void* data, double t, const double* y, double* dydt) {
  (void)data, (void)t;
  dydt[0] = y[1], dydt[1] = -sin(y[0]);
  return 0;
}

static const double start[] = {0, 1}, stops[] = {2, 5, 10};
static double chain_start[rods];
static odeum_problem problems[3];
static const odeum_plugin plugin = {
    .version = ODEUM_PLUGIN_VERSION, .name = "models", .problem_count = 3, .problems = problems};

const odeum_plugin* odeum_plugin_entry(void) {
  const odeum_problem driven = {.name = "driven",
                                .title = "A driven oscillator",
                                .equation = "q'' = -4 q + 3 sin t, q(0) = 0, q'(0) = 1",
                                .dimension = 2,
                                .y0 = start,
                                .stops = stops,
                                .stop_count = 3,
                                .rhs = rhs,
                                .jacobian = jacobian,
                                .time_derivative = time_derivative,
                                .acceleration = acceleration,
                                .exact = exact};
  const odeum_problem chain = {.name = "chain",
                               .dimension = rods,
                               .y0 = chain_start,
                               .stops = stops,
                               .stop_count = 3,
                               .rhs = chain_rhs,
                               .lower = 1,
                               .upper = 1,
                               .banded_jacobian = chain_jacobian,
                               .exact = chain_exact};
  const odeum_problem pendulum = {.name = "pendulum",
                                  .equation = "q'' = -sin q, q(0) = 0, q'(0) = 1",
                                  .dimension = 2,
                                  .y0 = start,
                                  .stops = stops,
                                  .stop_count = 3,
                                  .rhs = swing};
  for (size_t i = 0; i < rods; ++i) chain_start[i] = shape(i);
  problems[0] = driven;
  problems[1] = chain;
  problems[2] = pendulum;
  return &plugin;
}
