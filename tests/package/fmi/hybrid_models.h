/* SPDX-License-Identifier: BSD-3-Clause */
/* Models with events, of which the token chooses one; all of their variables are numbers. */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

enum { most = 32 };
typedef struct {
  bool more, terminate, states, has_next;
  double next;
} event_info;

/* Values by reference: 0 is the time, states follow, then the others. */
typedef struct model model;
typedef struct {
  const char* token;
  size_t states, indicators;
  double start[most];
  void (*initialise)(model*, event_info*);
  void (*derivatives)(const model*, double* d);
  void (*indicators_at)(const model*, double* z);
  void (*event)(model*, event_info*);
  bool (*completed)(model*);
  void (*outputs)(model*);
} kind;
struct model {
  const kind* kind;
  double x[most];
  long double exact[most]; /* the same, of 64 bits */
  double memory[4];        /* what only the model knows */
  enum { instantiated, initialising, event_mode, continuous, fresh } mode;
  double since, next;
  bool has_next;
  char resources[500];
};
static model self;

/* A ball (h, v; g, e, v_min, bounces): h' = v, v' = g; below a speed it rests. */
static void fall(const model* m, double* d) {
  d[0] = m->x[2];
  d[1] = m->memory[0] != 0 ? 0 : m->x[3];
}
static void height(const model* m, double* z) { z[0] = m->x[1]; }
static void bounce(model* m, event_info* info) {
  if (!(m->x[1] <= 0 && m->x[2] < 0)) return;
  m->x[1] = DBL_MIN;
  m->x[2] *= -m->x[4];
  m->x[6] += 1;
  if (m->x[2] < m->x[5]) m->x[2] = 0, m->memory[0] = 1;
  info->states = true;
}

/* A stair (counter): one more each second; the model ends itself at 10. */
static void first_stair(model* m, event_info* info) {
  info->has_next = true;
  info->next = m->x[0] + 1;
}
static void next_stair(model* m, event_info* info) {
  if (m->has_next && m->x[0] >= m->next) m->x[1] += 1, m->next += 1;
  info->has_next = true;
  info->next = m->next;
  info->terminate = m->x[1] >= 10;
}

/* Outputs from 17 on are the inputs from 1 on. */
static void feed(model* m) {
  for (int k = 1; k < most / 2; ++k) m->exact[most / 2 + k] = m->exact[k];
}

/* The first character of a file (1). */
static void read_resource(model* m, event_info* info) {
  (void)info;
  char path[600];
  snprintf(path, sizeof path, "%s/letter.txt", m->resources);
  FILE* const file = fopen(path, "r");
  m->x[1] = file ? fgetc(file) : -1;
  if (file) fclose(file);
}

/* Two clocks (ticks of one each second, ticks of another at 0, 1, 8 and 9, of both; the time of the
 * last fifth tick). */
static void tick(model* m, event_info* info) {
  const int t = (int)floor(m->x[0] + 0.5);
  if (!m->has_next || m->x[0] >= m->next) {
    const int ticks = 1 + (t <= 1 || (t >= 8 && t <= 9));
    m->x[1] += 1;
    m->x[2] += ticks - 1;
    for (int k = 0; k < ticks; ++k)
      if (fmod(m->x[3] += 1, 5) == 0) m->x[4] = m->x[0];
    m->next = t + 1;
  }
  info->has_next = true;
  info->next = m->next;
}

/* A room (temperature; heater, switches): T' = 10 heater - T, which is on from 4 down, off from 6
 * up. */
static void room(const model* m, double* d) { d[0] = 10 * m->x[2] - m->x[1]; }
static void room_limits(const model* m, double* z) {
  z[0] = m->x[2] != 0 ? 6 - m->x[1] : m->x[1] - 4;
}
static void thermostat(model* m, event_info* info) {
  (void)info;
  double z;
  room_limits(m, &z);
  if (z <= 0) m->x[2] = 1 - m->x[2], m->x[3] += 1;
}

/* x' = u - x, with an input u (2). */
static void follow(const model* m, double* d) { d[0] = m->x[2] - m->x[1]; }

/* x' = -x; at the end of a step below 1/2 it asks for an event, which adds 1 (2: how often; 3:
 * steps). */
static void decay(const model* m, double* d) { d[0] = -m->x[1]; }
static bool low(model* m) {
  m->x[3] += 1;
  return m->x[1] < 0.5;
}
static void lift(model* m, event_info* info) {
  if (m->x[1] >= 0.5) return;
  m->x[1] += 1;
  m->x[2] += 1;
  info->states = true;
}

/* A switch (x; side): x' = -1 from x > 0, else 1: it chatters at zero. */
static void relay(const model* m, double* d) { d[0] = m->x[2] != 0 ? -1 : 1; }
static void sign(const model* m, double* z) { z[0] = m->x[1]; }
static void flip(model* m, event_info* info) {
  (void)info;
  m->x[2] = m->x[1] > 0;
}

/* What is wrong (x; fault): an event that asks for another without end, a time event that does not
 * go on, an error in event mode, an end in it, a crash in it. */
static void faulty(model* m, event_info* info) {
  info->has_next = true;
  info->next = m->x[0] >= 1 && m->x[2] != 2 ? 100 : 1;
  if (m->x[0] < 1) return;
  info->more = m->x[2] == 1;
  info->terminate = m->x[2] == 4;
  if (m->x[2] == 5) abort();
}

static const kind kinds[] = {
    {.token = "{ball}",
     .states = 2,
     .indicators = 1,
     .start = {0, 1, 0, -9.81, 0.7, 0.1, 0},
     .derivatives = fall,
     .indicators_at = height,
     .event = bounce},
    {.token = "{stair}", .start = {0, 1}, .initialise = first_stair, .event = next_stair},
    {.token = "{feed}", .outputs = feed},
    {.token = "{resource}", .initialise = read_resource},
    {.token = "{clocks}", .initialise = tick, .event = tick},
    {.token = "{thermostat}",
     .states = 1,
     .indicators = 1,
     .start = {0, 5, 1, 0},
     .derivatives = room,
     .indicators_at = room_limits,
     .event = thermostat},
    {.token = "{follow}", .states = 1, .start = {0, 0, 1}, .derivatives = follow},
    {.token = "{steps}",
     .states = 1,
     .start = {0, 1},
     .derivatives = decay,
     .completed = low,
     .event = lift},
    {.token = "{relay}",
     .states = 1,
     .indicators = 1,
     .start = {0, 0.5, 1},
     .derivatives = relay,
     .indicators_at = sign,
     .event = flip},
    {.token = "{fault}",
     .states = 1,
     .start = {0, 1},
     .derivatives = decay,
     .initialise = faulty,
     .event = faulty},
};
