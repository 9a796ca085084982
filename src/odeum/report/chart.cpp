// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"

namespace odeum::report {
namespace {

// Fewer decades than this, and powers of ten are too few ticks.
constexpr double short_axis = 2;

std::vector<double> logarithmic_ticks(const Axis& axis, int most) {
  std::vector<double> ticks;
  const double decades = std::log10(axis.high / axis.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / most)));
  for (int k = static_cast<int>(std::floor(std::log10(axis.low))); std::pow(10.0, k) <= axis.high;
       ++k)
    for (const int m : {1, 2, 5})
      if (k % every == 0 && (m == 1 || decades < short_axis))
        ticks.push_back(m * std::pow(10.0, k));
  return ticks;
}

// At multiples of 1, 2 or 5 times a power of ten.
std::vector<double> linear_ticks(const Axis& axis, int most) {
  const double least = (axis.high - axis.low) / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const int m : {5, 2, 1})
    if (m * power >= least) step = m * power;
  std::vector<double> ticks;
  for (double k = std::ceil(axis.low / step); k * step <= axis.high; ++k)
    ticks.push_back(k * step + 0.0);  // no -0
  return ticks;
}

std::vector<double> ticks_of(const Axis& axis, double length, double spacing) {
  const int most = std::max(2, static_cast<int>(length / spacing));
  std::vector<double> ticks =
      axis.logarithmic ? logarithmic_ticks(axis, most) : linear_ticks(axis, most);
  std::erase_if(ticks, [&](double value) { return value < axis.low || value > axis.high; });
  return ticks;
}

// Markup for the number beside a tick.
std::string tick_text(const Axis& axis, double value) {
  if (!axis.logarithmic || axis.high / axis.low < std::pow(10, short_axis))
    return show_number(value);
  return fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{:.0f}</tspan>", std::log10(value));
}

// Where a value lies between the ends of an axis, 0 to 1.
double share(const Axis& axis, double value) {
  return axis.logarithmic ? std::log(value / axis.low) / std::log(axis.high / axis.low)
                          : (value - axis.low) / (axis.high - axis.low);
}

// A tenth of a unit is less than a pixel.
std::string shortest(double coordinate) {
  std::string text = fmt::format("{:.1f}", coordinate);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string text_at(double x, double y, const char* attributes, const std::string& markup) {
  return fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>", shortest(x), shortest(y), attributes,
                     markup);
}

std::string title_element(std::string_view title) {
  return title.empty() ? "" : "<title>" + escape(title) + "</title>";
}

std::string attribute(const char* name, std::string_view value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, value);
}

}  // namespace

void Axis::include(double value) {
  if (!std::isfinite(value) || value <= 0) return;
  low = low > 0 ? std::min(low, value) : value;
  high = std::max(high, value);
}

Chart::Chart(const ChartSize& size, const Axis& x, const Axis& y, ChartWords words)
    : size_(size), x_(x), y_(y), words_(std::move(words)) {}

double Chart::x(double value) const {
  return size_.left + (size_.width - size_.left - size_.right) * share(x_, value);
}

double Chart::y(double value) const {
  return size_.height - size_.bottom - (size_.height - size_.top - size_.bottom) * share(y_, value);
}

std::string Chart::path(const std::vector<ChartPoint>& points) const {
  std::string d;
  for (const auto& [px, py] : points)
    d += (d.empty() ? "M" : "L") + shortest(x(px)) + " " + shortest(y(py));
  return d;
}

void Chart::line(const std::vector<ChartPoint>& points, std::string_view style,
                 std::string_view title) {
  if (points.size() < 2) return;
  empty_ = false;
  drawn_ += fmt::format("<path class=\"{}\" d=\"{}\">{}</path>", style, path(points),
                        title_element(title));
}

void Chart::curve(const std::vector<ChartPoint>& points, std::size_t style, bool dashed) {
  if (points.empty()) return;
  empty_ = false;
  if (points.size() == 1)  // a path of one point has no markers
    return mark(points.front(), style);
  drawn_ +=
      fmt::format("<path class=\"c{}{}\" d=\"{}\"/>", style, dashed ? " dashed" : "", path(points));
}

void Chart::stairs(const std::vector<ChartPoint>& points, std::string_view style) {
  if (points.empty()) return;
  empty_ = false;
  std::string d = fmt::format("M{} {}", shortest(x(points.front().first)), size_.top);
  for (const auto& [px, py] : points) d += "H" + shortest(x(px)) + "V" + shortest(y(py));
  drawn_ += fmt::format("<path class=\"{}\" d=\"{}H{}\"/>", style, d, size_.width - size_.right);
}

void Chart::mark(const ChartPoint& point, std::size_t style, std::string_view classes,
                 std::string_view title) {
  empty_ = false;
  drawn_ += fmt::format("<use href=\"#m{}\" x=\"{}\" y=\"{}\"{}>{}</use>", style,
                        shortest(x(point.first)), shortest(y(point.second)),
                        attribute("class", classes), title_element(title));
}

void Chart::level(double value, std::string_view text) {
  if (!(value > y_.low && value < y_.high)) return;
  const double right = size_.width - size_.right;
  guides_ += fmt::format("<path class=\"guide dotted\" d=\"M{} {}H{}\"/>", size_.left,
                         shortest(y(value)), right) +
             text_at(right - 2, y(value) - 4, " class=\"label end\"", escape(text));
}

void Chart::slopes(const std::vector<int>& slopes) {
  const double far = x_.high / 1.1, top = y_.high / 2, near = x_.low * 1.1, bottom = y_.low * 2;
  for (const int slope : slopes) {
    const double at_left = top * std::pow(near / far, slope);
    const bool leaves_left = at_left >= bottom;
    const double end_x = leaves_left ? near : far * std::pow(bottom / top, 1.0 / slope);
    const double end_y = leaves_left ? at_left : bottom;
    guides_ +=
        fmt::format("<path class=\"guide\" d=\"{}\"/>", path({{far, top}, {end_x, end_y}})) +
        text_at(x(end_x) - (leaves_left ? 0 : 3), y(end_y) - 3,
                leaves_left ? " class=\"label\"" : " class=\"label end\"", std::to_string(slope));
  }
}

std::string Chart::x_ticks() const {
  std::string lines, labels;
  const double bottom = size_.height - size_.bottom;
  for (const double value : ticks_of(x_, size_.width - size_.left - size_.right, 44)) {
    lines += fmt::format("M{} {}V{}", shortest(x(value)), size_.top, bottom);
    labels += text_at(x(value), bottom + 14, " class=\"middle\"",
                      words_.x_tick ? escape(words_.x_tick(value)) : tick_text(x_, value));
  }
  return "<path class=\"grid\" d=\"" + lines + "\"/>" + labels;
}

std::string Chart::y_ticks() const {
  std::string lines, labels;
  for (const double value : ticks_of(y_, size_.height - size_.top - size_.bottom, 30)) {
    lines += fmt::format("M{} {}H{}", size_.left, shortest(y(value)), size_.width - size_.right);
    labels += text_at(size_.left - 5, y(value) + 4, " class=\"end\"", tick_text(y_, value));
  }
  return "<path class=\"grid\" d=\"" + lines + "\"/>" + labels;
}

std::string Chart::svg() const {
  const double bottom = size_.height - size_.bottom, right = size_.width - size_.right;
  std::string text =
      fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                  size_.width, size_.height, escape(words_.description));
  text += x_ticks() + y_ticks() +
          fmt::format("<path d=\"M{} {}V{}H{}\"/>", size_.left, size_.top, bottom, right);
  text += guides_ + drawn_;
  if (!words_.x.empty())
    text +=
        text_at((size_.left + right) / 2, size_.height - 6, " class=\"middle\"", escape(words_.x));
  if (!words_.y.empty())
    text +=
        fmt::format("<text transform=\"translate(12,{}) rotate(-90)\" class=\"middle\">{}</text>",
                    (size_.top + bottom) / 2, escape(words_.y));
  return text + "</svg>";
}

std::string legend(const std::vector<Key>& keys) {
  std::string html = "<ul class=\"legend\">";
  for (const Key& key : keys) {
    const bool marked = key.style < chart_styles;
    html += fmt::format(
        "<li><svg viewBox=\"-9 -5 18 10\"{} aria-hidden=\"true\">{}{}</svg>{}</li>",
        marked ? fmt::format(" style=\"color:var(--s{})\"", key.style) : "",
        key.line.empty() ? "" : fmt::format("<path class=\"{}\" d=\"M-9 0H9\"/>", key.line),
        marked ? fmt::format("<use href=\"#m{}\"/>", key.style) : "", escape(key.text));
  }
  return html + "</ul>";
}

std::string figure_of(const Curves& curves, const ChartWords& words, double margin,
                      const Guides& guides) {
  Axis across, up;
  for (const auto& [name, points] : curves)
    for (const auto& [x, y] : points) across.include(x), up.include(y);
  if (across.empty() || up.empty()) return {};
  up.include(guides.level);
  Chart chart(large_chart, across.widened(margin), up.widened(1.3), words);
  chart.slopes(guides.slopes);
  if (guides.level > 0) chart.level(guides.level, guides.level_text);
  std::vector<Key> keys;
  for (const auto& [name, points] : curves) {
    keys.push_back({.text = name, .style = keys.size() % chart_styles});
    chart.curve(points, keys.back().style);
  }
  return "<figure>" + chart.svg() + legend(keys) + "</figure>\n";
}

std::string marker_symbols() {
  constexpr const char* shapes[chart_styles] = {
      R"svg(<circle r="2.4" fill="currentColor"/>)svg",
      R"svg(<rect x="-2.1" y="-2.1" width="4.2" height="4.2" fill="currentColor"/>)svg",
      R"svg(<path d="M0-3 2.8 2H-2.8z" fill="currentColor"/>)svg",
      R"svg(<path d="M0-3.2 3.2 0 0 3.2-3.2 0z" fill="currentColor"/>)svg",
      R"svg(<circle r="2.4" fill="var(--paper)" stroke="currentColor"/>)svg",
      R"svg(<rect x="-2.1" y="-2.1" width="4.2" height="4.2" fill="var(--paper)" stroke="currentColor"/>)svg",
      R"svg(<path d="M0 3 2.8-2H-2.8z" fill="currentColor"/>)svg",
      R"svg(<path d="M-2.4-2.4 2.4 2.4M-2.4 2.4 2.4-2.4" stroke="currentColor" stroke-width="1.3"/>)svg"};
  std::string text = "<svg width=\"0\" height=\"0\" class=\"symbols\" aria-hidden=\"true\"><defs>";
  for (std::size_t i = 0; i < chart_styles; ++i)
    text += fmt::format(
        "<g id=\"m{0}\">{1}</g><marker id=\"k{0}\" style=\"color:var(--s{0})\" "
        "markerUnits=\"userSpaceOnUse\" overflow=\"visible\"><use href=\"#m{0}\"/></marker>",
        i, shapes[i]);
  return text + "</defs></svg>\n";
}

}  // namespace odeum::report
