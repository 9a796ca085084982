/* SPDX-License-Identifier: BSD-3-Clause */
/* The classical method of Runge and Kutta at fixed steps, and to a tolerance by step doubling. */
#include <math.h>
#include <odeum/plugin.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const odeum_system* system;
  double *k, *sum, *stage, *one, *two;
  double h;
  uint64_t steps;
} rk4;

static void* create(const odeum_system* system, double t0, const double* y0) {
  const size_t n = system->dimension;
  rk4* self = calloc(1, sizeof *self);
  double* memory = malloc(5 * n * sizeof *memory);
  (void)t0, (void)y0;
  if (!self || !memory) return NULL;
  self->system = system;
  self->k = memory, self->sum = memory + n, self->stage = memory + 2 * n;
  self->one = memory + 3 * n, self->two = memory + 4 * n;
  return self;
}

static void destroy(void* data) {
  rk4* self = data;
  free(self->k);
  free(self);
}

static int step(void* data, double t, double h, double* y) {
  static const double share[] = {0.5, 0.5, 1, 0}, weight[] = {1, 2, 2, 1},
                      node[] = {0, 0.5, 0.5, 1};
  rk4* self = data;
  const size_t n = self->system->dimension;
  memset(self->sum, 0, n * sizeof *self->sum);
  memcpy(self->stage, y, n * sizeof *y);
  for (int s = 0; s < 4; ++s) {
    if (self->system->rhs(self->system->data, t + node[s] * h, self->stage, self->k) != 0) return 1;
    for (size_t i = 0; i < n; ++i) {
      self->sum[i] += weight[s] * self->k[i];
      self->stage[i] = y[i] + share[s] * h * self->k[i];
    }
  }
  for (size_t i = 0; i < n; ++i) y[i] += h / 6 * self->sum[i];
  return 0;
}

static int solve(void* data, double* t, double stop, double tolerance, double* y) {
  rk4* self = data;
  const size_t n = self->system->dimension;
  if (self->h == 0) self->h = 1e-3 * (stop - *t);
  while (*t < stop) {
    const int last = *t + self->h >= stop;
    const double h = last ? stop - *t : self->h;
    double error = 0;
    memcpy(self->one, y, n * sizeof *y);
    memcpy(self->two, y, n * sizeof *y);
    if (step(self, *t, h, self->one) || step(self, *t, h / 2, self->two) ||
        step(self, *t + h / 2, h / 2, self->two))
      return 1;
    for (size_t i = 0; i < n; ++i) {
#ifdef RK4_OF_VERSION_1
      const double absolute = tolerance;
#else
      const double absolute = self->system->absolute_tolerances[i];
#endif
      const double scale = absolute + tolerance * fabs(self->two[i]);
      error = fmax(error, fabs(self->two[i] - self->one[i]) / 15 / scale);
    }
    if (error <= 1) {
      memcpy(y, self->two, n * sizeof *y);
      *t = last ? stop : *t + h;
      ++self->steps;
    }
    if (!last || error > 1) self->h = h * fmin(4, fmax(0.2, 0.9 * pow(error + 1e-10, -0.2)));
    if (self->h < 1e-14 * (1 + fabs(*t))) return 2;
  }
  return 0;
}

static uint64_t steps(const void* data) { return ((const rk4*)data)->steps; }

static const odeum_solver solver = {.name = "rk4",
                                    .family = "explicit_rk",
                                    .source = "Kutta 1901",
                                    .order = 4,
                                    .create = create,
                                    .step = step,
                                    .solve = solve,
                                    .steps = steps,
                                    .destroy = destroy};
static const odeum_plugin plugin = {
#ifdef RK4_OF_VERSION_1
    .version = 1,
    .name = "older",
#else
    .version = ODEUM_PLUGIN_VERSION,
    .name = "mine",
#endif
    .solver_count = 1,
    .solvers = &solver};
const odeum_plugin* odeum_plugin_entry(void) { return &plugin; }
