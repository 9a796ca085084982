/* SPDX-License-Identifier: BSD-3-Clause */
/* A function of Python as a plug-in's problem: it stays in a process of Python (odeum/_served.py),
 * which answers calls over a socket, so that any function can be called: a closure, one of a
 * notebook. Each process that calls it has a connection, and a process of Python, of its own. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "odeum/plugin.h"

/* What Python sends first; t0, y0 and the stops follow. */
typedef struct {
  int64_t dimension, stops;
  char name[64];
} Header;

typedef struct {
  int socket;
  pid_t owner;     /* the connection is this process's */
  size_t n;        /* unknowns */
  double* message; /* the seconds that the call before took, t, y; or a status and the rates */
} Connection;

static int receive(int socket, void* to, size_t bytes) {
  return recv(socket, to, bytes, MSG_WAITALL) == (ssize_t)bytes;
}

static int connected(void) {
  const char* const path = getenv("ODEUM_PYTHON_FUNCTION");
  struct sockaddr_un at = {.sun_family = AF_UNIX};
  if (!path || strlen(path) >= sizeof at.sun_path) return -1;
  strcpy(at.sun_path, path);
  const int made = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (made >= 0 && connect(made, (const struct sockaddr*)&at, sizeof at) == 0) return made;
  if (made >= 0) close(made);
  return -1;
}

/* The description that every connection begins with; null where it does not arrive. */
static double* described(int socket, Header* header) {
  if (!receive(socket, header, sizeof *header)) return NULL;
  header->name[sizeof header->name - 1] = 0;
  if (header->dimension < 1 || header->dimension > 1000000 || header->stops < 1 ||
      header->stops > 1000000)
    return NULL;
  const size_t count = 1 + (size_t)header->dimension + (size_t)header->stops;
  double* const numbers = malloc(count * sizeof(double));
  if (numbers && receive(socket, numbers, count * sizeof(double))) return numbers;
  free(numbers);
  return NULL;
}

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int rhs(void* data, double t, const double* y, double* dydt) {
  Connection* const c = data;
  if (c->owner != getpid()) {
    /* A copy of the process that connected. */
    Header header;
    c->socket = connected();
    c->owner = getpid();
    double* const numbers = c->socket >= 0 ? described(c->socket, &header) : NULL;
    if (!numbers && c->socket >= 0) {
      close(c->socket);
      c->socket = -1;
    }
    free(numbers);
  }
  if (c->socket < 0) return 1;
  const double before = seconds();
  const size_t bytes = c->n * sizeof(double);
  c->message[1] = t;
  memcpy(c->message + 2, y, bytes);
  const size_t whole = bytes + 2 * sizeof(double);
  if (send(c->socket, c->message, whole, MSG_NOSIGNAL) != (ssize_t)whole ||
      !receive(c->socket, c->message, bytes + sizeof(double))) {
    close(c->socket);
    c->socket = -1;
    return 1;
  }
  const int failed = c->message[0] != 0;
  memcpy(dydt, c->message + 1, bytes);
  c->message[0] = seconds() - before;
  return failed;
}

const odeum_plugin* odeum_plugin_entry(void) {
  static Connection connection;
  static Header header;
  static odeum_problem problem;
  static const odeum_plugin plugin = {
      .version = ODEUM_PLUGIN_VERSION, .name = "python", .problem_count = 1, .problems = &problem};
  if (problem.name) return &plugin;
  connection.socket = connected();
  connection.owner = getpid();
  if (connection.socket < 0) return NULL;
  const double* const numbers = described(connection.socket, &header);
  if (!numbers) return NULL;
  connection.n = (size_t)header.dimension;
  connection.message = calloc(connection.n + 2, sizeof(double));
  if (!connection.message) return NULL;
  problem.title = "a function of Python";
  problem.equation = "a function of Python, which is called";
  problem.source = "Python";
  problem.dimension = connection.n;
  problem.t0 = numbers[0];
  problem.y0 = numbers + 1;
  problem.stops = numbers + 1 + connection.n;
  problem.stop_count = (size_t)header.stops;
  problem.data = &connection;
  problem.rhs = rhs;
  problem.name = header.name;
  return &plugin;
}
