/* SPDX-License-Identifier: BSD-3-Clause */
/* SciPy's solvers as a plug-in, whose functions are Python's (odeum/_scipy_plugin.py): the
   interpreter is loaded in the process of a solve, and calls the compiled right-hand side by its
   pointer. */
#define _GNU_SOURCE /* dladdr */
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "odeum/plugin.h"

/* Where Python puts the description. */
static const odeum_plugin* made;

static const char script[] =
    "import ctypes, sys\n"
    "sys.path[:0] = ['%s/../python3/dist-packages', '" ODEUM_PYTHON_SOURCE
    "']\n"
    "sys.path.append('" ODEUM_PYTHON_PACKAGES
    "')\n"
    "from odeum import _scipy_plugin\n"
    "ctypes.c_void_p.from_address(%llu).value = ctypes.addressof(_scipy_plugin.PLUGIN)\n";

const odeum_plugin* odeum_plugin_entry(void) {
  if (made) return made;
  setenv("OPENBLAS_NUM_THREADS", "1", 0);     /* a run is one thread */
  setenv("PYTHONHOME", ODEUM_PYTHON_HOME, 1); /* not that of the first python3 on the path */
  /* Modules of Python look for its functions among those of the program. */
  void* python = dlopen(ODEUM_LIBPYTHON, RTLD_NOW | RTLD_GLOBAL);
  if (!python) return NULL;
  /* POSIX has an object's pointer in place of a function's here. */
  void (*initialise)(int) = NULL;
  int (*run)(const char*, void*) = NULL;
  void* (*leave)(void) = NULL;
  *(void**)&initialise = dlsym(python, "Py_InitializeEx");
  *(void**)&run = dlsym(python, "PyRun_SimpleStringFlags");
  *(void**)&leave = dlsym(python, "PyEval_SaveThread");
  Dl_info self;
  if (!initialise || !run || !leave || !dladdr((void*)(uintptr_t)odeum_plugin_entry, &self))
    return NULL;
  char folder[4096];
  snprintf(folder, sizeof folder, "%s", self.dli_fname);
  char* const slash = strrchr(folder, '/');
  if (slash) *slash = 0;
  char text[sizeof script + sizeof folder + 32];
  snprintf(text, sizeof text, script, folder, (unsigned long long)(uintptr_t)&made);
  initialise(0); /* without Python's handlers of signals */
  if (run(text, NULL) != 0) made = NULL;
  leave(); /* callbacks take the interpreter's lock themselves */
  return made;
}
