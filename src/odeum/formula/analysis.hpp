// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/formula/series.hpp"

namespace odeum::formula {

/// What was found in the equations of a problem.
struct Structure {
  std::size_t states = 0, entries = 0;  ///< entries: of the Jacobian that are not zero by form
  std::size_t lower = 0, upper = 0;     ///< its bandwidths
  bool autonomous = true, linear = true, smooth = true;
  bool steep = false;            ///< an operation may have a derivative that is infinite, or none
  bool infinite_slopes = false;  ///< a root, or a power below 1, of what may become 0
  bool second_order = false, velocity_dependent = false;
  /// The equations would be of second order if the states stood in another order.
  bool second_order_in_other_order = false;
  std::size_t with_implicit_part = 0;  ///< equations that have one

  /// Sparse factors pay: few unknowns are solved for faster by dense matrices made for their
  /// number.
  bool is_sparse() const;
};

/// The derivatives of a problem and its structure.
struct Analysis {
  Structure structure;
  std::vector<std::vector<Entry>> jacobian;           ///< by row
  std::vector<std::vector<Entry>> implicit_jacobian;  ///< of the implicit part, likewise
  std::vector<Id> time_derivative;                    ///< by state; empty where autonomous
  std::optional<SeriesPlan> series;                   ///< none where not smooth, or too large
};

/// Adds the derivatives to the problem's graph. Throws std::length_error where they are too many.
Analysis analyse(Problem& problem);

/// The entries of a Jacobian, row by row.
std::vector<Id> jacobian_roots(const std::vector<std::vector<Entry>>& jacobian);
inline std::vector<Id> jacobian_roots(const Analysis& analysis) {
  return jacobian_roots(analysis.jacobian);
}

/// The structure in words, a line each.
std::vector<std::string> describe(const Structure& structure);

}  // namespace odeum::formula
