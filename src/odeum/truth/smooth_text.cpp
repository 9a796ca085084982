// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/smooth_text.hpp"

#include <memory>
#include <stdexcept>

#include "odeum/formula/series.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/linear/pattern_lu.hpp"

namespace odeum::truth {
namespace {

using formula::TextOde;

/// Gives the system the Jacobian's entries where that takes less than a full matrix, or a full one
/// would take too long. False: there are too many.
bool take_entries(const std::shared_ptr<const TextOde>& ode, System& system) {
  if (!ode->view().sparsity) return false;
  const Sparsity& pattern = ode->sparsity();
  const linear::Band band = linear::band_of(pattern, linear::reverse_cuthill_mckee(pattern));
  constexpr std::size_t widest_band = 200;  // the product of its widths
  const bool is_narrow = band.lower * band.upper <= widest_band;
  // A multiplication at a place that is looked up takes as long as three others.
  const auto n = static_cast<double>(ode->size());
  constexpr double most = 2e6;
  const double affordable =
      is_narrow ? n * static_cast<double>((band.lower + 1) * (band.lower + band.upper + 1)) / 3
      : ode->size() <= most_in_matrix ? n * n * n / 9
                                      : most;
  if (ode->size() <= linear::Elimination::largest) {
    try {
      system.elimination = std::make_shared<const linear::Elimination>(pattern, affordable);
    } catch (const std::length_error&) {
      if (!is_narrow) return false;
    }
  }
  if (!is_narrow && !system.elimination) return false;
  system.sparsity = {ode, &pattern};
  system.entries = [ode](Real t, const Real* y, Real* v) { ode->entries_extended(t, y, v); };
  return true;
}

}  // namespace

System smooth_system(const std::shared_ptr<const TextOde>& ode) {
  const formula::Problem& problem = ode->problem();
  System system;
  system.states = ode->size();
  system.t0 = problem.t0;
  system.y0 = problem.y0;
  system.smooth = ode->analysis().structure.smooth;
  system.concurrent = true;
  system.rhs = [ode](Real t, const Real* y, Real* f) { ode->rhs_extended(t, y, f); };
  if (!take_entries(ode, system) && ode->size() <= most_in_matrix)
    system.jacobian = [ode](Real t, const Real* y, Real* j) { ode->jacobian_extended(t, y, j); };
  system.work = static_cast<double>(problem.graph.needed(problem.equations).size());
  if (const auto& plan = ode->analysis().series) {
    const auto series =
        std::make_shared<formula::Series<Real>>(problem.graph, *plan, system.states);
    system.taylor = [series](Real t, const Real* y, int order, Real* c) {
      (*series)(t, y, order, c);
    };
  }
  return system;
}

}  // namespace odeum::truth
