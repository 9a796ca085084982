/* SPDX-License-Identifier: BSD-3-Clause */
/* A plug-in with one fault, chosen when it is compiled. Without a fault its solver is Euler's. */
#include <math.h>
#include <odeum/plugin.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const odeum_system* the_system;
static void* create(const odeum_system* system, double t0, const double* y0) {
  (void)t0, (void)y0;
  the_system = system;
#ifdef FAULT_null_create
  return NULL;
#endif
  return malloc(64);
}

static int step(void* self, double t, double h, double* y) {
  const size_t n = the_system->dimension;
  double* k = malloc(n * sizeof *k);
  const int spent = the_system->rhs(the_system->data, t, y, k);
  for (size_t i = 0; i < n; ++i) y[i] += h * k[i];
  (void)self;
#ifdef FAULT_crash
  *(volatile int*)8 = 1;
#endif
#ifdef FAULT_hang
  for (;;) pause();
#endif
#ifdef FAULT_exit_process
  printf("this is not data\n");
  exit(0);
#endif
#ifdef FAULT_exit_late
  if (t > 0.5) _exit(3);
#endif
#ifdef FAULT_corrupt
  memset((char*)self - 32, 0x41, 4096);
  free(self);
#endif
#ifdef FAULT_nonsense
  y[0] = NAN;
#endif
#ifdef FAULT_past_state
  y[n] = 1;
#endif
#ifdef FAULT_ignore_budget
  for (;;) the_system->rhs(the_system->data, t, y, k);
#endif
#ifdef FAULT_fail
  free(k);
  return 7;
#endif
  free(k);
  return spent;
}

static int solve(void* self, double* t, double stop, double tolerance, double* y) {
  (void)tolerance;
  const int answer = step(self, *t, stop - *t, y);
#ifdef FAULT_backwards
  *t -= 1;
#else
  *t = stop;
#endif
  return answer;
}

static int rhs(void* data, double t, const double* y, double* dydt) {
  (void)data, (void)t;
  dydt[0] = -y[0];
#ifdef FAULT_bad_rhs
  dydt[0] = NAN;
#endif
#ifdef FAULT_rhs_crash
  if (t > 1.8) abort();
#endif
#ifdef FAULT_rhs_hang
  if (t > 1.8) pause();
#endif
  return 0;
}
static int exact(void* data, double t, double* y) {
  (void)data;
  y[0] = exp(-t);
#ifdef FAULT_bad_exact
  y[0] = 1 - t;
#endif
  return 0;
}

static const double start[] = {1}, stops[] = {1, 2};
static const odeum_problem problem = {.name = "decay",
                                      .dimension = 1,
                                      .y0 = start,
                                      .stops = stops,
                                      .stop_count = 2,
                                      .rhs = rhs,
                                      .exact = exact};
#define SOLVER \
  { .name = "euler", .order = 1, .create = create, .step = step, .solve = solve }
static const odeum_solver solvers[] = {SOLVER, SOLVER};
static const odeum_plugin plugin = {
#ifdef FAULT_bad_version
    .version = 99,
#else
    .version = ODEUM_PLUGIN_VERSION,
#endif
#if defined FAULT_no_name
    .name = NULL,
#elif defined FAULT_taken_name
    .name = "cvode",
#else
    .name = "bad",
#endif
#ifdef FAULT_twice
    .solver_count = 2,
#else
    .solver_count = 1,
#endif
    .solvers = solvers,
    .problem_count = 1,
    .problems = &problem};

#ifdef FAULT_crash_on_load
__attribute__((constructor)) static void on_load(void) { abort(); }
#endif
#ifndef FAULT_no_entry
const odeum_plugin* odeum_plugin_entry(void) {
#ifdef FAULT_null_plugin
  return NULL;
#endif
  return &plugin;
}
#endif
