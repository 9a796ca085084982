// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/fem/hierarchy.hpp"

namespace odeum::study {

/// A problem with a known solution, and the orders that theory gives it.
struct ModelProblem {
  struct Claim {
    const char* norm;  ///< l2, h1, max, max_by_log, centre
    double order;
    std::string theory;
  };
  std::string id, title, equation, truth;
  fem::EllipticProblem problem;
  const fem::Rule* rule = &fem::degree_5_rule();
  std::function<double(fem::Point)> value = {};  ///< of the solution; empty: the centre's alone
  std::function<fem::Point(fem::Point)> gradient = {};
  double scale = 1;           ///< largest |u|
  double centre_value = nan;  ///< u(1/2, 1/2)
  fem::TriangleMesh coarsest;
  std::size_t divisions = 2;  ///< of a unit length in the coarsest mesh
  std::function<fem::Point(fem::Point)> onto_boundary = {};
  fem::Undetermined undetermined = fem::Undetermined::refuse;
  std::vector<Claim> claims;
  bool pictured = false;  ///< on the page
};

std::vector<ModelProblem> model_problems();
/// The first of them: u = exp(x - y) sin(pi x) sin(2 pi y) on the unit square, a = 1.
ModelProblem smooth_problem(const fem::Rule& rule = fem::degree_5_rule());
/// div grad u = 0 stretched: a = [[1, c], [c, 1]] with c = -0.95, for which Jacobi's iteration
/// diverges on triangles with diagonals along (1, 1).
ModelProblem skewed_problem();

/// The meshes of a problem, each with half the mesh size of the one before.
class Hierarchy {
 public:
  /// Goes as far as `most` divisions. `problem` must outlive the object.
  Hierarchy(const ModelProblem& problem, std::size_t most);

  const fem::Levels& levels() const { return levels_; }
  const fem::Levels::Level& finest() const { return levels_.finest(); }
  std::size_t divisions(std::size_t level) const { return problem_.divisions << level; }
  std::size_t finest_divisions() const { return divisions(levels_.size() - 1); }
  /// A V-cycle for the system of the finest mesh.
  linear::Multigrid multigrid() const { return levels_.multigrid(levels_.size() - 1); }
  /// Values at the nodes of a level from the solution of its system.
  std::vector<double> nodal(const fem::Levels::Level& level, const std::vector<double>& x) const;

 private:
  const ModelProblem& problem_;
  fem::Levels levels_;
};

}  // namespace odeum::study
