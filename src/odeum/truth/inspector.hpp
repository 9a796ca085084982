// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

#include "odeum/formula/interval.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// Looks into steps of a smooth right-hand side for what its samples may have missed: a pulse
/// between them, or a condition that holds for a short while. The step's path, a cubic through its
/// ends with a tube around it, is cut into cells, over which interval arithmetic bounds the
/// argument of every function: where that varies by no more than a part of the function's own
/// scale, nothing is hidden between the samples of a method.
class Inspector {
 public:
  /// `conditions` are positive as long as they hold. `span`: what is far shorter is not looked for.
  Inspector(const formula::Graph& graph, const std::vector<formula::Id>& equations,
            const std::vector<formula::Id>& conditions, Real t0, Real span);

  /// `slope`, `next_slope`: of the solution at both ends.
  Inside look(Real t, Real h, const State& y, const State& slope, const State& next,
              const State& next_slope);
  /// How much the equations may vary over the box between both ends of the step; where they have no
  /// bound there, how much they vary at samples of it.
  State spread(Real t, Real h, const State& y, const State& next);
  /// Bounds of the rounding of the equations in extended precision.
  void rounding(Real t, const State& y, State& bound);

 private:
  /// Values over the cells of a part of the step.
  const std::vector<formula::Intervals>& over_cells(Real from, Real to);
  /// Whether a condition changes or may change in each cell.
  std::array<bool, formula::lanes> undecided(const std::vector<formula::Intervals>& values) const;
  /// The first cell of a part at whose right end a condition has changed; all: none.
  std::size_t first_changed(Real from, Real to);
  /// Looks for changes in a part of the step; `cells` counts them.
  Inside find_change(Real from, Real to, int& cells);
  Real at(Real part, std::size_t i) const;

  formula::Enclosure enclosure_;
  std::vector<std::uint32_t> functions_, conditions_;
  Real t0_, span_;
  // The step: cubic polynomials of the part, and the tube in its middle.
  Real t_ = 0, h_ = 0;
  std::vector<std::array<Real, 4>> path_;
  State tube_;
  formula::Intervals time_{};
  std::vector<formula::Intervals> states_;
};

/// The least part of the span for which steps are cut.
inline constexpr Real shortest_inspected = 0x1p-40L;

}  // namespace odeum::truth
