// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "odeum/fem/elliptic.hpp"
#include "odeum/linear/multigrid.hpp"

namespace odeum::fem {

/// One problem on meshes of which each is a refinement of the one before.
class Levels {
 public:
  /// `problem` and `rule` must outlive the object.
  Levels(const EllipticProblem& problem, const Rule& rule,
         Undetermined undetermined = Undetermined::refuse)
      : problem_(problem), rule_(rule), undetermined_(undetermined) {}

  struct Level {
    TriangleMesh mesh;
    EllipticSystem system;
  };
  /// Assembles. Throws as `assemble`.
  void add(TriangleMesh coarsest) {
    EllipticSystem system = assemble(coarsest, problem_, rule_, undetermined_);
    levels_.push_back({std::move(coarsest), std::move(system)});
  }
  /// A refinement of the finest mesh.
  void add(Refined finer) {
    EllipticSystem system = assemble(finer.mesh, problem_, rule_, undetermined_);
    prolongations_.push_back(prolongation(finer, levels_.back().system, system));
    levels_.push_back({std::move(finer.mesh), std::move(system)});
  }

  std::size_t size() const { return levels_.size(); }
  const Level& operator[](std::size_t level) const { return levels_[level]; }
  const Level& finest() const { return levels_.back(); }
  /// A V-cycle for the system of a level. The object and the levels must outlive it.
  linear::Multigrid multigrid(std::size_t level, std::size_t threads = 1) const {
    return linear::Multigrid(
        levels_[level].system.matrix,
        {prolongations_.rend() - static_cast<long>(level), prolongations_.rend()}, threads);
  }

 private:
  const EllipticProblem& problem_;
  const Rule& rule_;
  Undetermined undetermined_;
  std::vector<Level> levels_;
  std::vector<linear::SparseMatrix> prolongations_;  ///< from level i to i + 1
};

}  // namespace odeum::fem
