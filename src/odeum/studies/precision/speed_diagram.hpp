// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/studies/precision/precision.hpp"

namespace odeum::report {

/// Nanoseconds for a reader: "850 ns", "12.3 µs", "4.56 ms", "1.2 s".
std::string show_time(double ns);

/// The rows of one case as points of error (up) against time per solve (across), both logarithmic,
/// as an <svg>: own solvers in the first colour and marker, those of each peer in the next, in the
/// order of `libraries`; the Pareto front as a line, that of the peers dashed. Each point names
/// its solver when pointed at, which is why gnuplot does not draw it: names may not go there.
/// Errors beyond `worst` are not drawn. Empty where there is nothing to draw.
std::string speed_diagram(const std::vector<study::PrecisionRow>& rows,
                          const std::vector<std::string>& libraries, double floor, double worst);

/// What its colours and lines mean, as a list.
std::string speed_legend(const std::vector<std::string>& libraries);

}  // namespace odeum::report
