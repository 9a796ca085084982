// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/report/chart.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum::report {

/// Most curves that one plot shows: as many as there are colours and markers.
inline constexpr std::size_t curves_per_panel = chart_styles;

/// Solvers of one library that are drawn together; the n-th has the n-th colour and marker.
struct Panel {
  std::string library;
  std::string contents = {};  ///< families and orders, in words
  std::vector<const SolverInfo*> solvers = {};
};

/// Every solver in one panel each: by library, and within it by family and order, so that what
/// should look alike stands together. Points into `solvers`.
std::vector<Panel> make_panels(const std::vector<SolverInfo>& solvers);

}  // namespace odeum::report
