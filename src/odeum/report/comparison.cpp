// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/report/html.hpp"
#include "odeum/report/texts.hpp"

namespace odeum::report {
namespace {

constexpr ChartSize size{460, 300, 66, 10, 10, 40};

constexpr const char* style_of_lines =
    ".plot .line { fill: none; stroke-width: 1.5; stroke-linejoin: round; }\n"
    // Wide and pale, so that it shows beside the lines that lie on it.
    ".plot .exact, .legend .exact { stroke: var(--ink); stroke-opacity: 0.3; stroke-width: 5; "
    "fill: "
    "none; }\n"
    ".exact-mark { color: var(--ink); }\n"
    ".figures { display: grid; gap: 1rem 1.5rem; grid-template-columns: "
    "repeat(auto-fill, minmax(min(100%, 27rem), 1fr)); }\n"
    ".figures figure { margin: 0; min-width: 0; }\n"
    ".replays { display: grid; gap: 0.6rem; grid-template-columns: "
    "repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); }\n"
    ".replays figure { margin: 0; } .replays iframe { width: 100%; height: 30rem; border: 0; }\n"
    "#together { display: flex; flex-wrap: wrap; gap: 0.3rem 1rem; align-items: center; margin: "
    "0.5rem 0; } #together input[type=range] { flex: 1; min-width: 10rem; }\n";

std::string colours_of_lines() {
  std::string css;
  for (std::size_t i = 0; i < chart_styles; ++i)
    css += fmt::format(".plot .line{0}, .legend .line{0} {{ stroke: var(--s{0}); }}\n", i);
  return css;
}

std::string classes_of(const FigureLine& line) {
  return (line.style == exact_style ? std::string("line exact")
                                    : fmt::format("line line{}", line.style % chart_styles)) +
         (line.dashed ? " dashed" : "");
}

bool shows(const Figure& figure, const ChartPoint& point) {
  if (!std::isfinite(point.first) || !std::isfinite(point.second)) return false;
  if (figure.logarithmic && !(point.second > 0)) return false;
  return !figure.y_range ||
         (point.second >= (*figure.y_range)[0] && point.second <= (*figure.y_range)[1]);
}

// The interval that the values take, with a margin; of one value, an interval around it.
Axis spanned(const Figure& figure, bool across) {
  Axis axis;
  axis.logarithmic = !across && figure.logarithmic;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const FigureLine& line : figure.lines)
    for (const ChartPoint& point : line.points) {
      if (!shows(figure, point)) continue;
      low = std::min(low, across ? point.first : point.second);
      high = std::max(high, across ? point.first : point.second);
    }
  if (!across && figure.y_range) return {(*figure.y_range)[0], (*figure.y_range)[1], false};
  if (!(low <= high)) low = high = axis.logarithmic ? 1 : 0;
  if (axis.logarithmic) return {low / 1.5, high * 1.5, true};
  // Differences of rounding size are no curve: the axis spans at least a part in 1e9.
  const double least = std::max(1e-9 * std::max(std::abs(low), std::abs(high)), 1e-300);
  const double margin = std::max(across ? 0 : 0.04 * (high - low), high - low < least ? least : 0);
  axis.low = low - margin;
  axis.high = high + margin;
  return axis;
}

// The parts of a line that lie in the figure.
void draw(Chart& chart, const Figure& figure, const FigureLine& line) {
  std::vector<ChartPoint> part;
  for (const ChartPoint& point : line.points) {
    if (shows(figure, point)) {
      if (line.marks_only)
        chart.mark(point, line.style % chart_styles, line.style == exact_style ? "exact-mark" : "",
                   line.name);
      else
        part.push_back(point);
      continue;
    }
    chart.line(part, classes_of(line), line.name);
    part.clear();
  }
  chart.line(part, classes_of(line), line.name);
}

std::string svg_of(const Figure& figure) {
  Chart chart(size, spanned(figure, true), spanned(figure, false),
              {.x = figure.x, .y = figure.y, .description = figure.title, .x_tick = {}});
  for (const FigureLine& line : figure.lines) draw(chart, figure, line);
  return chart.svg();
}

std::string html_of(const Figure& figure) {
  std::vector<Key> keys;
  for (const FigureLine& line : figure.lines)
    if (!line.points.empty())
      keys.push_back(line.marks_only ? Key{.text = line.name, .style = 0}
                                     : Key{.text = line.name, .line = classes_of(line)});
  return fmt::format("<figure><figcaption><strong>{}</strong></figcaption>{}{}</figure>\n",
                     escape(figure.title), svg_of(figure), legend(keys));
}

// Moves all replays in step, with one camera.
constexpr const char* script = R"js(<script>
'use strict';
const frames = [...document.querySelectorAll('.replays iframe')], byId = (id) => document.getElementById(id);
let duration = 0, time = 0, playing = false, before = null, camera = null;
const ready = new Set();
const tell = (message, except) => { for (const f of frames) if (f.contentWindow !== except) f.contentWindow.postMessage(message, '*'); };
const show = () => {
  byId('time').value = time;
  byId('now').textContent = `t = ${time.toFixed(3)} s`;
  const message = { odeum: 'time', time };
  for (const id of ['trails', 'springs', 'surface', 'arrows']) message[id] = byId(id).checked;
  tell(message);
};
addEventListener('message', (event) => {
  const from = frames.findIndex((f) => f.contentWindow === event.source);
  if (from < 0 || !event.data) return;
  if (event.data.odeum === 'ready') {
    ready.add(from);
    duration = Math.max(duration, event.data.duration);
    byId('time').max = duration;
    document.documentElement.dataset.ready = ready.size;
    if (camera) tell({ odeum: 'camera', camera });
    show();
  }
  // At first the view of the first replay, later that of the one that was turned.
  if (event.data.odeum === 'camera' && (camera || from === 0)) {
    camera = event.data.camera;
    tell({ odeum: 'camera', camera }, event.source);
  }
});
byId('play').onclick = () => { playing = !playing; byId('play').textContent = playing ? 'Pause' : 'Play'; };
byId('time').oninput = () => { time = Number(byId('time').value); show(); };
for (const id of ['trails', 'springs', 'surface', 'arrows']) byId(id).onchange = show;
const tick = (now) => {
  if (playing && before !== null) {
    time += Math.min((now - before) / 1000, 0.1) * Number(byId('rate').value);
    if (time > duration) time = 0;
    show();
  }
  before = now;
  requestAnimationFrame(tick);
};
requestAnimationFrame(tick);
</script>
)js";

std::string html_of(const std::vector<ReplayFrame>& replays) {
  if (replays.empty()) return "";
  std::string html =
      "<h2>Replays in step</h2>\n<div id=\"together\"><button id=\"play\" type=\"button\">Play"
      "</button><input id=\"time\" type=\"range\" min=\"0\" value=\"0\" step=\"any\" "
      "aria-label=\"time\"><output id=\"now\"></output><label>speed <select id=\"rate\"><option "
      "value=\"0.1\">1/10</option><option value=\"0.5\">1/2</option><option value=\"1\" "
      "selected>1</option><option value=\"2\">2</option></select></label>";
  for (const auto& [id, text] : {std::pair{"trails", "trails"},
                                 {"springs", "springs"},
                                 {"surface", "cloth"},
                                 {"arrows", "velocities"}})
    html += fmt::format("<label><input id=\"{}\" type=\"checkbox\"{}> {}</label>", id,
                        std::string_view(id) == "arrows" ? "" : " checked", text);
  html += "</div>\n<div class=\"replays\">\n";
  for (const ReplayFrame& replay : replays)
    html += fmt::format(
        "<figure><figcaption><a href=\"{0}\"><code>{1}</code></a></figcaption><iframe "
        "src=\"{0}\" title=\"{1}\"></iframe></figure>\n",
        as_address(replay.address), escape(replay.solver));
  return html + "</div>\n" + script;
}

/// Of a curve, in the style sheet's colours for light pages, which come first.
std::string_view light_colour(std::size_t style) {
  const std::string name = fmt::format("--s{}: ", style);
  return page_style().substr(page_style().find(name) + name.size(), 7);
}

}  // namespace

std::string comparison_page(const Comparison& comparison) {
  std::string facts;
  for (const auto& [name, text] : comparison.facts)
    facts += fmt::format("<dt>{}</dt><dd>{}</dd>", escape(name), escape(text));
  std::string figures;
  for (const Figure& figure : comparison.figures) figures += html_of(figure);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{0} – Odeum</title>\n"
      "<style>\n{1}{2}{3}</style>\n</head>\n<body>\n{4}<main>\n<h1>{0}</h1>\n<p "
      "class=\"lead\"><code>"
      "{5}</code></p>\n<dl class=\"facts\">{6}</dl>\n{7}<div class=\"figures\">\n{8}</div>\n{9}"
      "</main>\n</body>\n</html>\n",
      escape(comparison.title), page_style(), style_of_lines, colours_of_lines(), marker_symbols(),
      escape(comparison.lead), facts, comparison.table.html(), figures,
      html_of(comparison.replays));
}

std::string figure_file(const Figure& figure) {
  std::string style =
      ".plot { font: 11px sans-serif; fill: none; stroke: #1d2126; } .plot text { fill: #1d2126; "
      "stroke: none; } .grid { stroke: #dfe3e8; } .end { text-anchor: end; } .middle { "
      "text-anchor: "
      "middle; } .dashed { stroke-dasharray: 6 4; } .line { stroke-width: 1.5; } .exact { "
      "stroke-opacity: 0.3; "
      "stroke-width: 5; }";
  for (std::size_t i = 0; i < chart_styles; ++i)
    style += fmt::format(" .line{} {{ stroke: {}; }}", i, light_colour(i));
  std::string svg = svg_of(figure);
  const std::size_t end = svg.find('>');
  svg.insert(end + 1, "<style>" + style + "</style>");
  svg.insert(4, fmt::format(" xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\"",
                            size.width, size.height));
  return svg + "\n";
}

}  // namespace odeum::report
