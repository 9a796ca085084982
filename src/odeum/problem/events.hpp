// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace odeum {

/// What happens to a solution at times, and where functions of the time and of it cross zero.
/// Times and states are in the problem's units; y has the problem's size. Several threads may call
/// the functions at once.
struct Events {
  /// Events at times, ascending.
  struct Timed {
    double t;
    std::vector<std::size_t> events;
  };
  /// One that happens where a function crosses zero: rising (1), falling (-1), or either (0).
  struct Crossed {
    std::size_t event;
    int sense;
  };
  std::vector<std::string> names;  ///< of all events, for people
  std::vector<bool> stops;         ///< by event: the solution stays as it is from then on
  std::vector<Timed> timed;
  std::vector<Crossed> crossed;
  /// Fills values with the function of each of `crossed`.
  std::function<void(double t, const double* y, double* values)> functions;
  /// Gives y the values after events that happen at once at t; a sentence where they contradict
  /// each other or a value is not finite, else empty.
  std::function<std::string(double t, const std::vector<std::size_t>& events, double* y)> apply;
};

}  // namespace odeum
