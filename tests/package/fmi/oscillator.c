/* SPDX-License-Identifier: BSD-3-Clause */
/* x' = v, v' = mu (1 - x^2) v - x + a sin t as a binary of FMI 2.0, or of 3.0 with -DFMI=3: what an
 * importer for Model Exchange calls, and one for co-simulation, where each communication step is one
 * of the explicit midpoint rule. The parameter `fault` chooses what goes wrong. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define EXPORT __attribute__((visibility("default")))
#define OK 0
#define ERROR 3

enum fault {
  none,
  nan_at_once,
  nan_later,
  crash_later,
  hang_later,
  exit_later,
  time_event,
  no_start,
  step_event,
  crash_at_start,
  error_later
};
typedef struct {
  double t, x, v, mu, a;
  int fault;
} model;
static model self = {.x = 2, .mu = 1};

static int set_real(unsigned reference, double value) {
  double* const at[] = {&self.t, &self.x, NULL, &self.v, NULL, &self.mu, &self.a};
  if (reference >= sizeof at / sizeof *at || !at[reference]) return ERROR;
  *at[reference] = value;
  return OK;
}

static int derivatives(double* d, size_t n) {
  if (n != 2) return ERROR;
  d[0] = self.v;
  d[1] = self.mu * (1 - self.x * self.x) * self.v - self.x;
  if (self.a != 0) d[1] += self.a * sin(self.t);
  if (self.fault == nan_at_once || (self.fault == nan_later && self.x < 1)) d[1] = NAN;
  if (self.fault == crash_later && self.x < 1) abort();
  while (self.fault == hang_later && self.x < 1) pause();
  if (self.fault == exit_later && self.x < 1) _exit(0);
  if (self.fault == error_later && self.x < 1) return ERROR;
  return OK;
}

static int get_real(unsigned reference, double* value) {
  const double* const at[] = {&self.t, &self.x, NULL, &self.v, NULL, &self.mu, &self.a};
  if (reference >= sizeof at / sizeof *at || !at[reference]) return ERROR;
  *value = *at[reference];
  return OK;
}

static int midpoint_step(double t, double h) {
  const double x = self.x, v = self.v;
  double d[2];
  self.t = t;
  if (derivatives(d, 2) != OK) return ERROR;
  self.t = t + h / 2;
  self.x = x + h / 2 * d[0];
  self.v = v + h / 2 * d[1];
  if (derivatives(d, 2) != OK) return ERROR;
  self.t = t + h;
  self.x = x + h * d[0];
  self.v = v + h * d[1];
  return OK;
}

/* The unknowns are der(x) and der(v), the known is x or v. */
static int directional(const unsigned* unknown, size_t unknowns, const unsigned* known,
                       size_t knowns, const double* seed, double* out) {
  for (size_t i = 0; i < unknowns; ++i) {
    out[i] = 0;
    for (size_t k = 0; k < knowns; ++k) {
      const bool by_x = known[k] == 1;
      const double of_x = by_x ? 0 : 1;
      const double of_v =
          by_x ? -2 * self.mu * self.x * self.v - 1 : self.mu * (1 - self.x * self.x);
      out[i] += seed[k] * (unknown[i] == 2 ? of_x : of_v);
    }
  }
  return OK;
}

#if FMI == 3
#define NAME(name) fmi3##name
EXPORT const char* fmi3GetVersion(void) { return "3.0"; }
typedef void (*logger)(void*, int, const char*, const char*);
EXPORT void* fmi3InstantiateModelExchange(const char* name, const char* token,
                                          const char* resources, bool visible, bool logging,
                                          void* environment, logger log) {
  (void)name, (void)resources, (void)visible, (void)logging;
  if (strcmp(token, "{oscillator}") == 0) return &self;
  log(environment, ERROR, "error", "the token is another");
  return NULL;
}
EXPORT void* fmi3InstantiateCoSimulation(const char* name, const char* token, const char* resources,
                                         bool visible, bool logging, bool event_mode,
                                         bool early_return, const unsigned* intermediate,
                                         size_t n, void* environment, logger log, void* update) {
  (void)event_mode, (void)early_return, (void)intermediate, (void)n, (void)update;
  return fmi3InstantiateModelExchange(name, token, resources, visible, logging, environment, log);
}
EXPORT int fmi3DoStep(void* s, double t, double h, bool no_return, bool* event, bool* terminate,
                      bool* early, double* reached) {
  (void)s, (void)no_return;
  *event = *terminate = *early = false;
  *reached = t + h;
  return midpoint_step(t, h);
}
EXPORT int fmi3GetFloat64(void* s, const unsigned* references, size_t n, double* values,
                          size_t n_values) {
  (void)s;
  return n == 1 && n_values == 1 ? get_real(*references, values) : ERROR;
}
EXPORT int fmi3EnterInitializationMode(void* s, bool defined, double tolerance, double start,
                                       bool ends, double stop) {
  (void)s, (void)defined, (void)tolerance, (void)ends, (void)stop;
  self.t = start;
  if (self.fault == crash_at_start) abort();
  return self.fault == no_start ? ERROR : OK;
}
EXPORT int fmi3UpdateDiscreteStates(void* s, bool* more, bool* terminate, bool* nominals,
                                    bool* states, bool* defined, double* next) {
  (void)s;
  *more = *terminate = *nominals = *states = false;
  *defined = self.fault == time_event;
  *next = 1;
  return OK;
}
EXPORT int fmi3CompletedIntegratorStep(void* s, bool no_return, bool* event, bool* terminate) {
  (void)s, (void)no_return;
  *event = self.fault == step_event;
  *terminate = false;
  return OK;
}
EXPORT int fmi3SetFloat64(void* s, const unsigned* references, size_t n, const double* values,
                          size_t n_values) {
  (void)s;
  return n == 1 && n_values == 1 ? set_real(*references, *values) : ERROR;
}
EXPORT int fmi3SetInt32(void* s, const unsigned* references, size_t n, const int32_t* values,
                        size_t n_values) {
  (void)s, (void)references;
  if (n != 1 || n_values != 1) return ERROR;
  self.fault = *values;
  return OK;
}
EXPORT int fmi3GetNumberOfContinuousStates(void* s, size_t* n) {
  (void)s;
  *n = 2;
  return OK;
}
EXPORT int fmi3GetContinuousStateDerivatives(void* s, double* d, size_t n) {
  (void)s;
  return derivatives(d, n);
}
EXPORT int fmi3GetDirectionalDerivative(void* s, const unsigned* unknown, size_t unknowns,
                                        const unsigned* known, size_t knowns, const double* seed,
                                        size_t seeds, double* out, size_t outs) {
  (void)s;
  return seeds == knowns && outs == unknowns
             ? directional(unknown, unknowns, known, knowns, seed, out)
             : ERROR;
}
#else
#define NAME(name) fmi2##name
typedef struct {
  void (*log)(void*, const char*, int, const char*, const char*, ...);
  void *allocate, *free, *finished, *environment;
} callbacks;
typedef struct {
  int more, terminate, nominals, states, defined;
  double next;
} event_info;
EXPORT const char* fmi2GetVersion(void) { return "2.0"; }
EXPORT void* fmi2Instantiate(const char* name, int type, const char* guid, const char* resources,
                             const callbacks* back, int visible, int logging) {
  (void)resources, (void)visible, (void)logging;
  if ((type == 0 || type == 1) && strcmp(guid, "{oscillator}") == 0) return &self;
  back->log(back->environment, name, ERROR, "error", "the guid %s is another", guid);
  return NULL;
}
EXPORT int fmi2DoStep(void* s, double t, double h, int no_return) {
  (void)s, (void)no_return;
  return midpoint_step(t, h);
}
EXPORT int fmi2GetReal(void* s, const unsigned* references, size_t n, double* values) {
  (void)s;
  return n == 1 ? get_real(*references, values) : ERROR;
}
EXPORT int fmi2SetupExperiment(void* s, int defined, double tolerance, double start, int ends,
                               double stop) {
  (void)s, (void)defined, (void)tolerance, (void)ends, (void)stop;
  self.t = start;
  return OK;
}
EXPORT int fmi2EnterInitializationMode(void* s) {
  (void)s;
  if (self.fault == crash_at_start) abort();
  return self.fault == no_start ? ERROR : OK;
}
EXPORT int fmi2NewDiscreteStates(void* s, event_info* info) {
  (void)s;
  const event_info said = {.defined = self.fault == time_event, .next = 1};
  *info = said;
  return OK;
}
EXPORT int fmi2CompletedIntegratorStep(void* s, int no_return, int* event, int* terminate) {
  (void)s, (void)no_return;
  *event = self.fault == step_event;
  *terminate = 0;
  return OK;
}
EXPORT int fmi2SetReal(void* s, const unsigned* references, size_t n, const double* values) {
  (void)s;
  return n == 1 ? set_real(*references, *values) : ERROR;
}
EXPORT int fmi2SetInteger(void* s, const unsigned* references, size_t n, const int* values) {
  (void)s, (void)references;
  if (n != 1) return ERROR;
  self.fault = *values;
  return OK;
}
#ifndef WITHOUT_DERIVATIVES
EXPORT int fmi2GetDerivatives(void* s, double* d, size_t n) {
  (void)s;
  return derivatives(d, n);
}
#endif
EXPORT int fmi2GetDirectionalDerivative(void* s, const unsigned* unknown, size_t unknowns,
                                        const unsigned* known, size_t knowns, const double* seed,
                                        double* out) {
  (void)s;
  return directional(unknown, unknowns, known, knowns, seed, out);
}
#endif

EXPORT int NAME(ExitInitializationMode)(void* s) {
  (void)s;
  return OK;
}
EXPORT int NAME(EnterContinuousTimeMode)(void* s) {
  (void)s;
  return OK;
}
EXPORT int NAME(SetTime)(void* s, double t) {
  (void)s;
  self.t = t;
  return OK;
}
EXPORT int NAME(SetContinuousStates)(void* s, const double* y, size_t n) {
  (void)s;
  if (n != 2) return ERROR;
  self.x = y[0];
  self.v = y[1];
  return OK;
}
EXPORT int NAME(GetContinuousStates)(void* s, double* y, size_t n) {
  (void)s;
  if (n != 2) return ERROR;
  y[0] = self.x;
  y[1] = self.v;
  return OK;
}
