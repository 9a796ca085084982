// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/hierarchy.hpp"

#include <utility>

namespace odeum::fem {

void Levels::add(TriangleMesh coarsest) {
  EllipticSystem system = assemble(coarsest, problem_, rule_, undetermined_);
  levels_.push_back({std::move(coarsest), std::move(system)});
}

void Levels::add(Refined finer) {
  EllipticSystem system = assemble(finer.mesh, problem_, rule_, undetermined_);
  prolongations_.push_back(prolongation(finer, levels_.back().system, system));
  levels_.push_back({std::move(finer.mesh), std::move(system)});
}

linear::Multigrid Levels::multigrid(std::size_t level, std::size_t threads) const {
  return linear::Multigrid(
      levels_[level].system.matrix,
      {prolongations_.rend() - static_cast<long>(level), prolongations_.rend()}, threads);
}

}  // namespace odeum::fem
