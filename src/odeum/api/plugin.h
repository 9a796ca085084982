/* SPDX-License-Identifier: BSD-3-Clause */
/* Plug-ins of Odeum: problems and solvers in a shared object, in C or any language that can call C.
 *
 *     cc -shared -fPIC -o libmine.so mine.c
 *     odeum converge --plugin ./libmine.so --solver 'mine/?*' --case rc_circuit
 *
 * The shared object exports one function, `odeum_plugin_entry`, which returns a description that
 * stays valid. Names are of a-z, 0-9 and _. Times and states are double, states have `dimension`
 * numbers, matrices are row-major unless it is said otherwise. Callbacks that return int return 0
 * on success. A solver's step() or solve() that returns another number ends its run as `refused`,
 * with that number in its detail. Every solve is made in a process of its own, a copy (fork) of one
 * that has called odeum_plugin_entry: what is changed there is not seen by another solve, and no two
 * threads of a process call back at once.
 */
#ifndef ODEUM_PLUGIN_H
#define ODEUM_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header. Plug-ins of versions 1 and 2 are taken, of others refused. Version 2 added
 * odeum_system::absolute_tolerances. */
#define ODEUM_PLUGIN_VERSION 2

/* ---- A solver ---- */

/* The problem as a solver sees it. A callback that does not return 0 ends the solve: return at
 * once. */
typedef struct odeum_system {
  size_t dimension;
  void* data; /* the first argument of every callback */
  int (*rhs)(void* data, double t, const double* y, double* dydt);
  /* df/dy, dense; by differences where the problem has none. */
  int (*jacobian)(void* data, double t, const double* y, double* j);
  /* df/dt; zero where the problem does not depend on t. */
  int (*time_derivative)(void* data, double t, const double* y, double* dfdt);
  /* q'' = a(t, q, v) with y = [q, v]: dimension / 2 and a; 0 and null for other problems. */
  size_t degrees_of_freedom;
  int velocity_dependent;
  int (*acceleration)(void* data, double t, const double* q, const double* v, double* a);
  /* Since version 2: for solve(), the absolute tolerance of each component; null at fixed steps. */
  const double* absolute_tolerances;
} odeum_system;

/* What a solver needs of a problem; it is run on those that have it. */
#define ODEUM_NEEDS_JACOBIAN 1u     /* few enough unknowns for a dense one */
#define ODEUM_NEEDS_SECOND_ORDER 2u /* q'' = a(t, q, v) */
#define ODEUM_NEEDS_SEPARABLE 4u    /* q'' = a(t, q) */

typedef struct odeum_solver {
  const char* name;
  const char* family; /* explicit_rk, multistep, ...; may be null */
  const char* source; /* where the method is published; may be null */
  double order;       /* claimed; NaN where it varies */
  uint32_t needs;
  /* Before the first step of a solve, with the initial state. `system` stays valid until destroy.
   * Null: the solver fails. */
  void* (*create)(const odeum_system* system, double t0, const double* y0);
  /* y at t becomes y at t + h. Null: it does not run at fixed steps. */
  int (*step)(void* self, double t, double h, double* y);
  /* y at *t becomes y at `stop`, and *t becomes stop, to the relative tolerance `tolerance` and the
   * system's absolute ones (version 1 has no such ones: take `tolerance` for both). Null: it does
   * not run to a tolerance. */
  int (*solve)(void* self, double* t, double stop, double tolerance, double* y);
  /* The number of steps that solve() has accepted; null: not known, and no order is measured. */
  uint64_t (*steps)(const void* self);
  void (*destroy)(void* self); /* may be null */
} odeum_solver;

/* ---- A problem ---- */

typedef struct odeum_problem {
  const char* name;
  const char* title; /* may be null, as the two below */
  const char* equation;
  const char* source;
  size_t dimension;
  double t0;
  const double* y0;
  const double* stops; /* ascending, after t0: where errors are measured; the last is the horizon */
  size_t stop_count;
  void* data; /* the first argument of every callback */
  int (*rhs)(void* data, double t, const double* y, double* dydt);
  /* Null, or df/dy in one of three forms. */
  int (*jacobian)(void* data, double t, const double* y, double* j); /* dense */
  /* Banded: row i, column k with -lower <= k - i <= upper is j[i * (lower + upper + 1) + k - i +
   * lower]. */
  size_t lower, upper;
  int (*banded_jacobian)(void* data, double t, const double* y, double* j);
  /* Sparse: value[n] stands at row[n], column[n], for n < entries. */
  size_t entries;
  const size_t *row, *column;
  int (*sparse_jacobian)(void* data, double t, const double* y, double* value);
  /* df/dt; null: f does not depend on t. */
  int (*time_derivative)(void* data, double t, const double* y, double* dfdt);
  /* Null, or a(t, q, v) of q'' = a with y = [q, v]. */
  int (*acceleration)(void* data, double t, const double* q, const double* v, double* a);
  int velocity_dependent;
  int (*energy)(void* data, const double* y, double* energy); /* may be null */
  int (*exact)(void* data, double t, double* y);              /* the solution; may be null */
} odeum_problem;

typedef struct odeum_plugin {
  uint32_t version; /* ODEUM_PLUGIN_VERSION */
  const char* name; /* the first part of its solvers' ids, mine/my_solver; no library has it */
  size_t solver_count;
  const odeum_solver* solvers;
  size_t problem_count;
  const odeum_problem* problems; /* their case ids are mine_my_problem */
} odeum_plugin;

#define ODEUM_PLUGIN_ENTRY "odeum_plugin_entry"
const odeum_plugin* odeum_plugin_entry(void);

#ifdef __cplusplus
}
#endif
#endif
