// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odeum::report {

/// As many colours and markers as the style sheet has for curves.
inline constexpr std::size_t chart_styles = 8;

/// An interval of an axis. Of a logarithmic one both ends are positive; 0 and 0 is empty.
struct Axis {
  double low = 0, high = 0;
  bool logarithmic = true;

  bool empty() const { return !(high > low || high > 0); }
  /// Widens a logarithmic axis to hold a value; zero, negative and non-finite values are ignored.
  void include(double value);
  /// The same with a margin on either side, a factor.
  Axis widened(double factor) const { return {low / factor, high * factor, logarithmic}; }
};

/// Width and height in units of a pixel or so, and the margins around the field.
struct ChartSize {
  double width, height, left, right, top, bottom;
};
inline constexpr ChartSize small_chart{290, 215, 48, 8, 8, 38};
inline constexpr ChartSize large_chart{640, 400, 62, 14, 10, 44};

struct ChartWords {
  std::string x = {}, y = {};    ///< along the axes
  std::string description = {};  ///< for those who cannot see it
  /// What stands beside a tick across; empty: powers of ten on a long logarithmic axis, else
  /// numbers.
  std::function<std::string(double value)> x_tick = {};
};

using ChartPoint = std::pair<double, double>;

/// A line chart as an <svg> that the style sheet colours. Texts are escaped.
class Chart {
 public:
  Chart(const ChartSize& size, const Axis& x, const Axis& y, ChartWords words);

  /// A polygonal line of the classes `style`; `title` is shown when pointed at.
  void line(const std::vector<ChartPoint>& points, std::string_view style,
            std::string_view title = {});
  /// The same with a marker at each point, in colour and shape number `style`.
  void curve(const std::vector<ChartPoint>& points, std::size_t style, bool dashed = false);
  /// The level of the fastest so far: from the upper edge down to each point in turn, and on to the
  /// right edge. Points by rising x.
  void stairs(const std::vector<ChartPoint>& points, std::string_view style);
  /// One marker.
  void mark(const ChartPoint& point, std::size_t style, std::string_view classes = {},
            std::string_view title = {});
  /// A level across the whole field, drawn only where it is in it.
  void level(double value, std::string_view text);
  /// Lines y ~ x^slope from the upper right corner, each named where it leaves the field.
  void slopes(const std::vector<int>& slopes);

  /// Where nothing was drawn but axes, levels and slopes.
  bool empty() const { return empty_; }
  std::string svg() const;

 private:
  double x(double value) const;
  double y(double value) const;
  std::string path(const std::vector<ChartPoint>& points) const;
  std::string x_ticks() const;
  std::string y_ticks() const;

  ChartSize size_;
  Axis x_, y_;
  ChartWords words_;
  std::string guides_, drawn_;
  bool empty_ = true;
};

/// What a colour, marker or line means.
struct Key {
  std::string text;
  std::size_t style = chart_styles;  ///< colour and marker; chart_styles: none
  std::string line = {};             ///< classes of a line; empty: none
};
std::string legend(const std::vector<Key>& keys);

/// Lines that curves are compared with, see Chart.
struct Guides {
  std::vector<int> slopes = {};
  double level = 0;  ///< 0 or NaN: none
  std::string level_text = {};
};

/// A <figure> of curves by name, on logarithmic axes that are wider than the curves by a factor
/// (`margin` across), and its legend. Nothing where there is nothing to draw.
using Curves = std::map<std::string, std::vector<ChartPoint>>;
std::string figure_of(const Curves& curves, const ChartWords& words, double margin = 1.1,
                      const Guides& guides = {});

/// A hidden <svg> that defines the markers: symbols #m0 to #m7, line markers #k0 to #k7; once a
/// page.
std::string marker_symbols();

}  // namespace odeum::report
