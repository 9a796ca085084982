// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: the adapter parts that need an older standard (uBLAS) include this header too.
#include <cstddef>
#include <cstdint>

namespace odeum {

class ShiftedSolver;
struct Sparsity;

/// A problem behind function pointers, for libraries whose own interface asks for them.
/// Arrays are `dimension` doubles; `jacobian` fills a dense row-major dimension x dimension matrix.
/// A null pointer means that the problem does not offer it. The problem must outlive the view.
struct OdeView {
  const void* problem = nullptr;
  std::size_t dimension = 0;
  void (*rhs)(const void* problem, double t, const double* y, double* dydt) = nullptr;
  void (*jacobian)(const void* problem, double t, const double* y, double* jacobian) = nullptr;
  /// Product of the Jacobian with a vector, for matrix-free (Krylov) solvers.
  void (*jacobian_times)(const void* problem, double t, const double* y, const double* x,
                         double* product) = nullptr;
  /// The structure of a sparse or banded Jacobian, see problem/sparsity.hpp, and the values of its
  /// entries; null pointers for a dense one, and for values that are to be formed by differences.
  const Sparsity* sparsity = nullptr;
  void (*jacobian_entries)(const void* problem, double t, const double* y,
                           double* values) = nullptr;
  /// df/dt; null for autonomous problems, where it is zero.
  void (*time_derivative)(const void* problem, double t, const double* y, double* dfdt) = nullptr;

  /// The problem's own solver of (I - gamma_h J) x = r, owned by the caller; see
  /// problem/shifted_solver.hpp.
  ShiftedSolver* (*shifted_solver)(const void* problem) = nullptr;

  /// The coefficients of the solution's Taylor series at (t, y), see WithTaylorSeries.
  void (*taylor)(const void* problem, double t, const double* y, int order, double* c) = nullptr;
  /// Linear problems with constant coefficients: the matrix, see LinearConstant.
  void (*linear_matrix)(const void* problem, double* a) = nullptr;

  /// Second-order problems q'' = a(t, q, q') have y = [q, q'] and degrees_of_freedom = dimension/2.
  std::size_t degrees_of_freedom = 0;
  bool velocity_dependent = false;  ///< whether a depends on q'
  void (*acceleration)(const void* problem, double t, const double* q, const double* v,
                       double* a) = nullptr;

  /// Damping apart from the other forces, see WithDamping.
  void (*undamped_acceleration)(const void* problem, double t, const double* q,
                                double* a) = nullptr;
  std::uint64_t (*damp)(const void* problem, double t, const double* q, double h, double* v,
                        double relative) = nullptr;

  bool second_order() const { return degrees_of_freedom != 0; }
};

}  // namespace odeum
