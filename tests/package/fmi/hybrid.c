/* SPDX-License-Identifier: BSD-3-Clause */
/* The models of hybrid_models.h as a binary of FMI 2.0, or of 3.0 with -DFMI=3: what an importer
 * for Model Exchange calls, with its states: a call out of place is an error. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "hybrid_models.h"

#define EXPORT __attribute__((visibility("default")))
#define OK 0
#define ERROR 3

static model* instantiate(const char* token, const char* resources) {
  const model none = {0};
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) {
    if (strcmp(kinds[k].token, token) != 0) continue;
    self = none;
    self.kind = &kinds[k];
    memcpy(self.x, kinds[k].start, sizeof self.x);
    if (strncmp(resources, "file://", 7) == 0) resources += 7;
    snprintf(self.resources, sizeof self.resources, "%s", resources);
    return &self;
  }
  return NULL;
}
static int update(model* m, event_info* info) {
  const event_info none = {0};
  *info = none;
  if (m->mode != event_mode && m->mode != fresh) return ERROR;
  void (*const act)(model*, event_info*) = m->mode == fresh ? m->kind->initialise : m->kind->event;
  m->mode = event_mode;
  if (m->kind == &kinds[9] && m->x[2] == 3 && m->x[0] >= 1) return ERROR;
  if (act) act(m, info);
  m->has_next = info->has_next;
  m->next = info->next;
  return OK;
}
/* Discrete variables are set in event mode alone. */
static int set(model* m, unsigned reference, long double value, bool discrete) {
  if (reference == 0 || reference >= most || (discrete && m->mode == continuous)) return ERROR;
  m->x[reference] = (double)value;
  m->exact[reference] = value;
  return OK;
}
static long double get(model* m, unsigned reference) {
  if (m->kind->outputs) m->kind->outputs(m);
  if (reference >= most) reference = 0;
  return m->kind->outputs ? m->exact[reference] : m->x[reference];
}
static int change_mode(model* m, int from, int to) {
  if ((int)m->mode != from) return ERROR;
  m->mode = to;
  m->since = m->x[0];
  return OK;
}

#if FMI == 3
#define NAME(name) fmi3##name
typedef void (*logger)(void*, int, const char*, const char*);
EXPORT const char* fmi3GetVersion(void) { return "3.0"; }
EXPORT void* fmi3InstantiateModelExchange(const char* name, const char* token,
                                          const char* resources, bool visible, bool logging,
                                          void* environment, logger log) {
  (void)name, (void)visible, (void)logging, (void)environment, (void)log;
  return instantiate(token, resources);
}
EXPORT int fmi3EnterInitializationMode(void* s, bool defined, double tolerance, double start,
                                       bool ends, double stop) {
  (void)defined, (void)tolerance, (void)ends, (void)stop;
  ((model*)s)->x[0] = start;
  return change_mode(s, instantiated, initialising);
}
EXPORT int fmi3UpdateDiscreteStates(void* s, bool* more, bool* terminate, bool* nominals,
                                    bool* states, bool* defined, double* next) {
  event_info info;
  const int status = update(s, &info);
  *more = info.more, *terminate = info.terminate, *nominals = false;
  *states = info.states, *defined = info.has_next, *next = info.next;
  return status;
}
EXPORT int fmi3CompletedIntegratorStep(void* s, bool no_return, bool* event, bool* terminate) {
  model* const m = s;
  (void)no_return;
  *event = m->kind->completed && m->kind->completed(m);
  *terminate = false;
  return m->mode == continuous ? OK : ERROR;
}
#define ACCESS(type, number, discrete)                                                        \
  EXPORT int fmi3Set##type(void* s, const unsigned* reference, size_t n, const number* value, \
                           size_t values) {                                                   \
    return n == 1 && values == 1 ? set(s, *reference, (long double)*value, discrete) : ERROR; \
  }                                                                                           \
  EXPORT int fmi3Get##type(void* s, const unsigned* reference, size_t n, number* value,       \
                           size_t values) {                                                   \
    *value = (number)get(s, *reference);                                                      \
    return n == 1 && values == 1 ? OK : ERROR;                                                \
  }
ACCESS(Float64, double, false)
ACCESS(Float32, float, false)
ACCESS(Int8, int8_t, true)
ACCESS(UInt8, uint8_t, true)
ACCESS(Int16, int16_t, true)
ACCESS(UInt16, uint16_t, true)
ACCESS(Int32, int32_t, true)
ACCESS(UInt32, uint32_t, true)
ACCESS(Int64, int64_t, true)
ACCESS(UInt64, uint64_t, true)
ACCESS(Boolean, bool, true)
EXPORT int fmi3GetNumberOfContinuousStates(void* s, size_t* n) {
  *n = ((model*)s)->kind->states;
  return OK;
}
EXPORT int fmi3GetNumberOfEventIndicators(void* s, size_t* n) {
  *n = ((model*)s)->kind->indicators;
  return OK;
}
#define DERIVATIVES fmi3GetContinuousStateDerivatives
#else
#define NAME(name) fmi2##name
typedef struct {
  int more, terminate, nominals, states, defined;
  double next;
} said;
EXPORT const char* fmi2GetVersion(void) { return "2.0"; }
EXPORT void* fmi2Instantiate(const char* name, int type, const char* guid, const char* resources,
                             const void* callbacks, int visible, int logging) {
  (void)name, (void)type, (void)callbacks, (void)visible, (void)logging;
  return instantiate(guid, resources);
}
EXPORT int fmi2SetupExperiment(void* s, int defined, double tolerance, double start, int ends,
                               double stop) {
  (void)defined, (void)tolerance, (void)ends, (void)stop;
  ((model*)s)->x[0] = start;
  return OK;
}
EXPORT int fmi2EnterInitializationMode(void* s) {
  return change_mode(s, instantiated, initialising);
}
EXPORT int fmi2NewDiscreteStates(void* s, said* to) {
  event_info info;
  const int status = update(s, &info);
  const said all = {info.more, info.terminate, 0, info.states, info.has_next, info.next};
  *to = all;
  return status;
}
EXPORT int fmi2CompletedIntegratorStep(void* s, int no_return, int* event, int* terminate) {
  model* const m = s;
  (void)no_return;
  *event = m->kind->completed && m->kind->completed(m);
  *terminate = 0;
  return m->mode == continuous ? OK : ERROR;
}
#define ACCESS(type, number, discrete)                                                          \
  EXPORT int fmi2Set##type(void* s, const unsigned* reference, size_t n, const number* value) { \
    return n == 1 ? set(s, *reference, (long double)*value, discrete) : ERROR;                  \
  }                                                                                             \
  EXPORT int fmi2Get##type(void* s, const unsigned* reference, size_t n, number* value) {       \
    *value = (number)get(s, *reference);                                                        \
    return n == 1 ? OK : ERROR;                                                                 \
  }
ACCESS(Real, double, false)
ACCESS(Integer, int, true)
ACCESS(Boolean, int, true)
#define DERIVATIVES fmi2GetDerivatives
#endif

EXPORT void NAME(FreeInstance)(void* s) { ((model*)s)->kind = NULL; }
EXPORT int NAME(ExitInitializationMode)(void* s) { return change_mode(s, initialising, fresh); }
EXPORT int NAME(EnterContinuousTimeMode)(void* s) { return change_mode(s, event_mode, continuous); }
EXPORT int NAME(EnterEventMode)(void* s) { return change_mode(s, continuous, event_mode); }
EXPORT int NAME(SetTime)(void* s, double t) {
  model* const m = s;
  if (m->mode != continuous || t < m->since) return ERROR;
  m->x[0] = t;
  return OK;
}
EXPORT int NAME(SetContinuousStates)(void* s, const double* y, size_t n) {
  model* const m = s;
  if (n != m->kind->states || m->mode != continuous) return ERROR;
  memcpy(m->x + 1, y, n * sizeof *y);
  return OK;
}
EXPORT int NAME(GetContinuousStates)(void* s, double* y, size_t n) {
  model* const m = s;
  if (n != m->kind->states) return ERROR;
  memcpy(y, m->x + 1, n * sizeof *y);
  return OK;
}
EXPORT int DERIVATIVES(void* s, double* d, size_t n) {
  model* const m = s;
  if (n != m->kind->states || !m->kind->derivatives) return ERROR;
  m->kind->derivatives(m, d);
  return OK;
}
EXPORT int NAME(GetEventIndicators)(void* s, double* z, size_t n) {
  model* const m = s;
  if (n != m->kind->indicators || !m->kind->indicators_at) return ERROR;
  m->kind->indicators_at(m, z);
  return OK;
}
