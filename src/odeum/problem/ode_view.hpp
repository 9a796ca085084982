// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: the adapter parts that need an older standard (uBLAS) include this header too.
#include <cstddef>

#include "odeum/problem/capabilities.hpp"

namespace odeum {

struct Sparsity;

/// A problem behind function pointers, for libraries whose own interface asks for them: `rhs`, and
/// a pointer for each capability (capabilities.hpp), null where the problem does not offer it.
/// Arrays are `dimension` doubles. The problem must outlive the view.
struct OdeView {
  const void* problem = nullptr;
  std::size_t dimension = 0;
  void (*rhs)(const void* problem, double t, const double* y, double* dydt) = nullptr;
#define ODEUM_POINTER(concept_name, function, charge, ...) \
  typename capability::Pointer<capability::function<double>>::type function = nullptr;
  ODEUM_CAPABILITIES(ODEUM_POINTER)
#undef ODEUM_POINTER

  /// The structure of a sparse or banded Jacobian, see problem/sparsity.hpp; null: dense.
  const Sparsity* sparsity = nullptr;
  /// Second-order problems q'' = a(t, q, q') have y = [q, q'] and degrees_of_freedom = dimension/2.
  std::size_t degrees_of_freedom = 0;
  bool velocity_dependent = false;  ///< whether a depends on q'

  bool second_order() const { return degrees_of_freedom != 0; }
};

}  // namespace odeum
