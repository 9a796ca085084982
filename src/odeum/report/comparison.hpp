// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/report/chart.hpp"
#include "odeum/report/table.hpp"

/// The page on which the runs of several solvers on one problem are drawn together.
namespace odeum::report {

/// How a line is drawn: the exact solution in the colour of text, solvers in colours of their own.
inline constexpr std::size_t exact_style = chart_styles;

struct FigureLine {
  std::string name;
  std::size_t style = exact_style;  ///< colour; those beyond the last begin again
  std::vector<ChartPoint> points = {};
  bool dashed = false;
  bool marks_only = false;  ///< points that are too far apart to be joined
};

struct Figure {
  std::string title, x = {}, y = {};
  bool logarithmic = false;  ///< of y; values that are not positive are left out
  std::vector<FigureLine> lines = {};
  std::optional<std::array<double, 2>> y_range = {};  ///< empty: what the lines take
};

/// A replay page that is shown in a frame.
struct ReplayFrame {
  std::string solver, address;
};

struct Comparison {
  std::string title, lead;
  std::vector<std::pair<std::string, std::string>> facts;
  Table table{"numbers"};  ///< a row for each solver
  std::vector<Figure> figures;
  std::vector<ReplayFrame> replays;
};

/// The whole page, with nothing from elsewhere but the replays. Texts are escaped here.
std::string comparison_page(const Comparison& comparison);

/// One figure as an SVG file that stands alone.
std::string figure_file(const Figure& figure);

}  // namespace odeum::report
