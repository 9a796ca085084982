// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "odeum/fem/quadrature.hpp"
#include "odeum/fem/triangle_mesh.hpp"
#include "odeum/linear/sparse_matrix.hpp"

/// -div(a grad u) = f by linear elements on triangles (Braess, Finite Elements, chapter II;
/// Johnson, Numerical Solution of Partial Differential Equations by the Finite Element Method).
namespace odeum::fem {

/// A symmetric 2 x 2 tensor.
struct Tensor {
  double xx = 1, xy = 0, yy = 1;
};

struct EllipticProblem {
  std::function<double(Point)> load;            ///< f
  std::function<Tensor(Point)> diffusion = {};  ///< a; empty: the identity
  /// Whether u is given (Dirichlet) on the boundary edge with this middle; empty: everywhere.
  std::function<bool(Point)> is_dirichlet = {};
  std::function<double(Point)> boundary_value = {};  ///< u there; empty: 0
  /// n . a grad u on the other edges (Neumann), with their outer normal; empty: 0.
  std::function<double(Point, Point normal)> flux = {};
};

/// A problem that cannot be solved as it is given, with the place where that was found.
class ProblemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The linear system of the nodes where u is not given.
struct EllipticSystem {
  linear::SparseMatrix matrix;
  std::vector<double> right;
  std::vector<int> unknown;   ///< by node: its unknown, -1 where u is given
  std::vector<double> given;  ///< by node: u where given, else 0
  /// With `mean_zero`: what load and flux add up to, against their absolute values; it was
  /// subtracted, evenly over the region.
  double imbalance = 0;

  /// Nodal values from a solution of the system.
  std::vector<double> nodal(const std::vector<double>& x) const;
};

/// What the system does with a problem whose solution is determined up to a constant, since u is
/// given nowhere.
enum class Undetermined {
  refuse,
  /// Takes the solution of mean 0: node 0 is held at 0, and `nodal_of_mean_zero` shifts the result.
  mean_zero
};

/// The stiffness matrix and the load. a is taken in the middle of each triangle, which keeps the
/// orders 1 in H1 and 2 in L2. Throws MeshError (see `check`), and ProblemError where f, a, a
/// boundary value or a flux is not finite, a is not positive definite, or u is given nowhere (with
/// `mean_zero`: where load and flux do not add up to 0 within 1 %, which quadrature on a coarse
/// mesh may miss). Several threads call f and a at once; the system is the same bits.
EllipticSystem assemble(const TriangleMesh& mesh, const EllipticProblem& problem, const Rule& load,
                        Undetermined undetermined = Undetermined::refuse, std::size_t threads = 1);

/// The solution shifted to a mean of 0 over the mesh.
std::vector<double> nodal_of_mean_zero(const TriangleMesh& mesh, const EllipticSystem& system,
                                       const std::vector<double>& x);

/// Integrals of products of the basis functions over the mesh, all nodes.
linear::SparseMatrix mass_matrix(const TriangleMesh& mesh);

/// Interpolation between the unknowns of a mesh and its refinement, by their edges' middles.
linear::SparseMatrix prolongation(const Refined& refined, const EllipticSystem& coarse,
                                  const EllipticSystem& fine);

/// Errors of a nodal solution, by the rule of degree 5 on each triangle.
struct FieldErrors {
  double l2 = 0, h1 = 0;  ///< of the value and of the gradient, root of the integral of the square
  double maximum = 0;     ///< at the nodes and the points of the rule
};
FieldErrors field_errors(const TriangleMesh& mesh, const std::vector<double>& nodal,
                         const std::function<double(Point)>& value,
                         const std::function<Point(Point)>& gradient);

}  // namespace odeum::fem
