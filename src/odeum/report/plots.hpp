// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "odeum/report/chart.hpp"
#include "odeum/report/gnuplot.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::report {

/// An interval of a logarithmic axis.
struct LogRange {
  double low = 0, high = 0;

  bool empty() const { return !(low > 0 && high > 0); }
  /// Widens it to hold a value; zero, negative and non-finite values are passed over.
  void include(double value);
  /// The same with a margin on either side, a factor.
  LogRange widened(double factor) const { return {low / factor, high * factor}; }
};

/// One curve; `style` (0 to 7) is its colour and marker, dashes mean an adaptive run.
struct Curve {
  std::size_t style = 0;
  bool dashed = false;
  std::vector<std::pair<double, double>> points;
};

/// Curves on doubly logarithmic axes. Labels are our own words (see Picture).
struct LogPlot {
  LogRange x, y;
  const char* x_label = "";
  const char* y_label = "";
  std::vector<Curve> curves;
  std::vector<int> slopes;  ///< reference lines y ~ x^slope, from the upper right corner
  double floor = 0;         ///< a level below which errors say nothing; 0: none
};

Picture draw(const LogPlot& plot);

/// What gnuplot wrote as an <svg> for the page: a tenth of its size, without its own definitions
/// and identifiers. Curves get the classes c0 to c7 and guide, which the style sheet colours and
/// gives the markers of marker_symbols. `description` is what a screen reader says.
std::string tidy_svg(const std::string& gnuplot_svg, const std::string& description);

/// A region of stability: growth of at most 1 shaded, its boundary, some levels around it.
Picture draw(const study::StabilityRegion& region);

}  // namespace odeum::report
