// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/panels.hpp"

namespace odeum::report {
namespace {

// Colours that gnuplot is given and tidy_svg turns into names of the style sheet.
std::string code_of(std::size_t number) { return fmt::format("#0101{:02x}", number); }
constexpr std::size_t guide_code = 0xfe;

// Ticks at powers of ten, at most about six of them; lines where there would be too few.
std::string log_axis(const char* axis, const LogRange& range, const char* label) {
  const double decades = std::log10(range.high / range.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 6)));
  const bool short_axis = decades < 1.5;
  std::string text = fmt::format("set {0}range [{1}:{2}]\nset {0}label \"{3}\"\n", axis, range.low,
                                 range.high, label);
  if (!short_axis)
    return text + fmt::format("set {0}tics 1e{1} format \"10^{{%L}}\"\n", axis, every);
  std::string ticks;
  for (int k = static_cast<int>(std::floor(std::log10(range.low))); std::pow(10, k) < range.high;
       ++k)
    for (const int m : {1, 2, 5}) ticks += fmt::format("{}{}e{}", ticks.empty() ? "" : ",", m, k);
  return text + fmt::format("set {}tics ({}) format \"%g\"\n", axis, ticks);
}

struct Reference {
  std::string lines, labels;
};

// Lines from near the upper right corner; each is named where it leaves the plot.
Reference slope_lines(const LogPlot& plot) {
  Reference reference;
  const double x_far = plot.x.high / 1.1, top = plot.y.high / 2;
  const double left = plot.x.low * 1.1, bottom = plot.y.low * 2;
  for (const int slope : plot.slopes) {
    const double at_left = top * std::pow(left / x_far, slope);
    const bool through_left = at_left >= bottom;
    const double x = through_left ? left : x_far * std::pow(bottom / top, 1.0 / slope);
    const double y = through_left ? at_left : bottom;
    reference.lines += fmt::format("{} {}\n{} {}\n\n", x_far, top, x, y);
    reference.labels += fmt::format(
        "set label '{}' at {},{} {} textcolor rgb '{}' font ',9' front\n", slope, x, y,
        through_left ? "left offset 0,0.5" : "right offset -0.5,0.3", code_of(guide_code));
  }
  return reference;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  if (text.find(from) == std::string::npos) return;
  std::string replaced;
  replaced.reserve(text.size());
  std::size_t begin = 0;
  for (std::size_t at; (at = text.find(from, begin)) != std::string::npos;
       begin = at + from.size()) {
    replaced.append(text, begin, at - begin);
    replaced += to;
  }
  text = replaced.append(text, begin);
}

// Removes every part from an opening text to a closing one, both included.
void cut_all(std::string& text, std::string_view open, std::string_view close) {
  for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos;) {
    const auto end = text.find(close, at + open.size());
    if (end == std::string::npos) return;
    text.erase(at, end + close.size() - at);
  }
}

// A curve's markers are drawn by the page (marker-mid and its like), so gnuplot's go; only where
// there is no line, for a single point, is its marker kept, as a use of a symbol of the page.
void drop_markers(std::string& text) {
  constexpr std::string_view open = "<use xlink:href='#gpPt", shift = "' transform='translate(";
  const std::string_view all = text;
  std::string kept;
  std::size_t begin = 0;
  bool on_line = false;
  for (std::size_t at; (at = all.find(open, begin)) != std::string::npos;) {
    const std::string_view between = all.substr(begin, at - begin);
    if (const auto tag = between.rfind('<'); tag != std::string::npos)
      on_line = between.substr(tag).starts_with("<path");
    kept += between;
    const auto number = at + open.size(), moved = all.find(shift, number);
    const auto x = moved + shift.size(), y = all.find(',', x) + 1, end = all.find(')', y);
    if (!on_line)
      kept +=
          fmt::format("<use href=\"#m{}\" x=\"{}\" y=\"{}\"/>", all.substr(number, moved - number),
                      all.substr(x, y - 1 - x), all.substr(y, end - y));
    begin = all.find("/>", end) + 2;
  }
  kept += all.substr(begin);
  text = std::move(kept);
}

// Coordinates to a tenth of a unit of the picture, which is less than a pixel. Only within tags:
// the labels of ticks keep their digits.
void shorten_coordinates(std::string& text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string shorter;
  shorter.reserve(text.size());
  bool in_tag = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<' || text[i] == '>') in_tag = text[i] == '<';
    shorter += text[i];
    if (!in_tag || text[i] != '.' || i == 0 || !is_digit(text[i - 1])) continue;
    std::size_t end = i + 1;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end == i + 1) continue;
    if (text[i + 1] == '0')
      shorter.pop_back();
    else
      shorter += text[i + 1];
    i = end - 1;
  }
  text = std::move(shorter);
}

}  // namespace

void LogRange::include(double value) {
  if (!std::isfinite(value) || value <= 0) return;
  low = low > 0 ? std::min(low, value) : value;
  high = std::max(high, value);
}

Picture draw(const LogPlot& plot) {
  Picture picture{.kind = Picture::Kind::svg, .width = 290, .height = 215};
  std::string& text = picture.commands;
  text =
      "set logscale xy\nset border 3\nset tics nomirror scale 0.6\nunset mxtics\nunset mytics\n"
      "unset key\nset lmargin 8\nset rmargin 1.5\nset tmargin 0.6\nset bmargin 3.2\n"
      "set xlabel offset 0,0.4\nset ylabel offset 0.8,0\n";
  text += log_axis("x", plot.x, plot.x_label) + log_axis("y", plot.y, plot.y_label);
  const Reference reference = slope_lines(plot);
  text += reference.labels;
  const std::string guide = code_of(guide_code);
  if (plot.floor > plot.y.low)
    text += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead lc rgb '{1}' dt 3\n"
        "set label 'truth' at graph 1, first {0} right offset 0,0.5 textcolor rgb '{1}' font "
        "',9'\n",
        plot.floor, guide);
  std::string curves, data;
  if (!plot.slopes.empty()) {
    curves += fmt::format("'-' with lines lc rgb '{}' lw 0.8", guide);
    data += reference.lines + "e\n";
  }
  for (const Curve& curve : plot.curves) {
    curves += fmt::format("{}'-' with linespoints lc rgb '{}' lw 1.2 pt {} ps 0.5{}",
                          curves.empty() ? "" : ", ", code_of(curve.style), curve.style + 1,
                          curve.dashed ? " dt (6,4)" : "");
    for (const auto& [x, y] : curve.points) data += fmt::format("{} {}\n", x, y);
    data += "e\n";
  }
  text += "plot " + curves + "\n" + data;
  return picture;
}

std::string tidy_svg(const std::string& gnuplot_svg, const std::string& description) {
  const auto begin = gnuplot_svg.find("</defs>");
  const auto end = gnuplot_svg.rfind("</g>");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  std::string text = gnuplot_svg.substr(begin + 7, end - begin - 7);
  cut_all(text, "<title>", "</title>");
  cut_all(text, " id=\"gnuplot_plot", "\"");
  drop_markers(text);
  for (std::size_t i = 0; i < curves_per_panel; ++i)
    replace_all(text, fmt::format("stroke='rgb(  1,   1, {:3})'", i),
                fmt::format("class=\"c{}\"", i));
  replace_all(text, fmt::format("stroke='rgb(  1,   1, {})'", guide_code), "class=\"guide\"");
  replace_all(text, fmt::format("\"rgb(1,1,{})\"", guide_code), "\"var(--guide)\"");
  for (const auto& [from, to] :
       {std::pair{"\n", " "},
        {"\t", " "},
        {"  ", " "},
        {"> <", "><"},
        {" '/>", "'/>"},
        {" font-family=\"sans\"", ""},
        {" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", ""},
        {" stroke='black'", ""},
        {" color=\"white\"", ""},
        {"\"black\"", "\"currentColor\""},
        {" color=\"currentColor\"", ""},
        {" font-size=\"11.00\"", ""},
        {"<tspan font-size=\"11.0\" dy=\"5.50\"></tspan>", ""},
        {"<tspan >", "<tspan>"},
        // What most groups say is said once, by the style sheet.
        {"<g fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.00\">", "<g>"},
        {"<g fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.20\">", "<g>"},
        {"<g >", "<g>"},
        {"<g></g>", ""}})
    replace_all(text, from, to);
  shorten_coordinates(text);
  return "<svg class=\"plot\" viewBox=\"0 0 290 215\" role=\"img\" aria-label=\"" +
         escape(description) + "\">" + text + "</svg>";
}

}  // namespace odeum::report
