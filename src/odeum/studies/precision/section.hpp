// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/report/page.hpp"
#include "odeum/studies/precision/precision.hpp"

namespace odeum::study {

/// What the page shows of a result: time against error, of all cases on index.html, and of each on
/// its own page.
void add_section(report::Page& page, const PrecisionResult& result, const Origin& origin);

/// The rows of one case as points of error against time per solve: own solvers in the first colour
/// and marker, those of each peer in the next, in the order of `libraries`; the Pareto front as a
/// line, that of the peers dashed. Each point names its solver when pointed at. Errors beyond
/// `worst` are not drawn. Empty where there is nothing to draw.
std::string speed_diagram(const std::vector<PrecisionRow>& rows,
                          const std::vector<std::string>& libraries, double floor, double worst);
std::string speed_legend(const std::vector<std::string>& libraries);

/// What adaptive solvers achieve of a tolerance, by group; with `each_solver`, by solver as well.
std::string tolerance_table(const report::Facts& facts, const std::vector<PrecisionRow>& rows,
                            bool each_solver);

}  // namespace odeum::study
