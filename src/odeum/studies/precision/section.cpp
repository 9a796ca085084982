// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/studies/precision/speed_diagram.hpp"

namespace odeum::report {
namespace {

using study::PrecisionRow;
using study::PrecisionSummary;

// More diagrams than this would make the page heavy; each case's own page has its diagram anyway.
constexpr std::size_t most_diagrams = 8;

// Errors beyond it tell nothing but that the run went astray.
double worst_of(const CaseFacts& c) { return 10 * c.scale; }

// Those that were timed; Odeum first, so that it has the first colour whoever takes part.
std::vector<std::string> libraries_of(const ReportData& data) {
  std::set<std::string> timed;
  for (const PrecisionRow& row : data.precision.rows)
    if (row.repetitions > 0) timed.insert(row.library);
  std::vector<std::string> names(timed.begin(), timed.end());
  std::stable_partition(names.begin(), names.end(), [](const auto& n) { return n == "odeum"; });
  return names;
}

std::vector<PrecisionRow> rows_of(const ReportData& data, const std::string& case_id) {
  std::vector<PrecisionRow> rows;
  for (const PrecisionRow& row : data.precision.rows)
    if (row.case_id == case_id) rows.push_back(row);
  return rows;
}

// When a case was measured, and what the calibration said: a mark where the machine was disturbed.
std::string conditions(const std::vector<PrecisionRow>& rows) {
  const auto timed = std::find_if(rows.begin(), rows.end(),
                                  [](const PrecisionRow& row) { return row.repetitions > 0; });
  if (timed == rows.end()) return "<span class=\"dim\">nothing could be timed</span>";
  const bool disturbed = study::disturbed(timed->drift, timed->processor_share);
  return fmt::format(
      "<span class=\"{}\">{}drift {:+.1f} %, processor {:.0f} %</span> <span "
      "class=\"dim\">{}</span>",
      disturbed ? "chip lower" : "dim", disturbed ? "⚠ disturbed: " : "", 100 * timed->drift,
      100 * timed->processor_share, escape(timed->measured));
}

// Faster or slower only where the whole interval says so.
const char* colour_of(const PrecisionSummary& line) {
  if (!line.reason.empty())
    return line.peer.empty() == line.own.empty() ? "zero"
           : line.peer.empty()                   ? "confirmed"
                                                 : "lower";
  return line.ratio_low > 1 ? "confirmed" : line.ratio_high < 1 ? "lower" : "undetermined";
}

std::string short_ratio(const PrecisionSummary& line) {
  if (line.reason.empty())
    return line.ratio < 9.95 ? fmt::format("{:.1f}", line.ratio)
                             : fmt::format("{:.0f}", line.ratio);
  return line.own.empty() && line.peer.empty() ? "·" : line.peer.empty() ? "own" : "peer";
}

std::string ratio_cell(const PrecisionSummary& line) {
  const std::string title =
      line.reason.empty() ? fmt::format("{} {} against {} {}: {:.2f} ({:.2f} to {:.2f})", line.own,
                                        show_time(line.own_ns), line.peer, show_time(line.peer_ns),
                                        line.ratio, line.ratio_low, line.ratio_high)
                          : line.reason;
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", colour_of(line), escape(title),
                     short_ratio(line));
}

std::string fastest_table(const ReportData& data, const std::string& case_id) {
  std::string rows;
  for (const PrecisionSummary& line : data.precision.summary) {
    if (line.case_id != case_id) continue;
    const std::string interval =
        line.reason.empty() ? fmt::format("{:.2f} … {:.2f}", line.ratio_low, line.ratio_high)
                            : escape(line.reason);
    rows += fmt::format(
        "<tr><th>{:.0e}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td>"
        "<td>{}</td></tr>\n",
        line.error, line.own.empty() ? "–" : escape(line.own), show_time(line.own_ns),
        line.peer.empty() ? "–" : escape(line.peer), show_time(line.peer_ns), colour_of(line),
        line.reason.empty() ? fmt::format("{:.2f}", line.ratio) : "–", interval);
  }
  if (rows.empty()) return {};
  return "<div class=\"wide\"><table class=\"numbers fastest\"><thead><tr><th>error</th>"
         "<th>fastest own</th><th>time</th><th>fastest peer</th><th>time</th><th>peer / own</th>"
         "<th>interval</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

// All cases against all errors: who is faster, and by how much.
std::string ratios_table(const PageContext& page, const std::vector<std::size_t>& measured) {
  std::string html = "<div class=\"wide\"><table class=\"numbers ratios\"><thead><tr><th>case</th>";
  for (int exponent = 2; exponent <= 12; ++exponent)
    html += fmt::format("<th>1e-{:02}</th>", exponent);
  html += "<th>calibration</th></tr></thead><tbody>\n";
  for (const std::size_t i : measured) {
    const CaseFacts& c = page.data.cases[i];
    html += fmt::format("<tr><th><a href=\"{}#precision\"><code>{}</code></a></th>",
                        page.case_address(i), escape(c.id));
    for (const PrecisionSummary& line : page.data.precision.summary)
      if (line.case_id == c.id) html += ratio_cell(line);
    html += "<td>" + conditions(rows_of(page.data, c.id)) + "</td></tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

constexpr const char* tolerances_text =
    "<p>What solvers that choose their own steps achieve of the tolerance that they are given: "
    "log<sub>10</sub> of achieved over requested, +1 meaning ten times the tolerance. A tolerance "
    "bounds the error of a step and the error is that at the end, so that zero is no duty; an even "
    "row is worth more. Of a group its median; pointing at a cell gives the range.</p>\n";

}  // namespace

std::string precision_part(const PageContext& page, const CaseFacts& c) {
  const std::vector<PrecisionRow> rows = rows_of(page.data, c.id);
  if (rows.empty()) return {};
  const std::vector<std::string> libraries = libraries_of(page.data);
  const std::string diagram = speed_diagram(rows, libraries, c.timed_floor, worst_of(c));
  std::string html =
      fmt::format("<section id=\"precision\"><h2>Speed against error</h2>\n<p>At t = {}. {}</p>\n",
                  show_number(c.timed_end, 6), conditions(rows));
  html += diagram.empty()
              ? "<p class=\"missing\">nothing to draw</p>\n"
              : "<figure class=\"speed\">" + diagram + speed_legend(libraries) + "</figure>\n";
  html += "<h3>Fastest at an error</h3>\n" + fastest_table(page.data, c.id);
  if (const std::string table = tolerance_table(page, rows, true); !table.empty())
    html += std::string("<h3>Tolerance requested and achieved</h3>\n") + tolerances_text + table;
  return html + "</section>\n";
}

std::string precision_section(const PageContext& page) {
  const ReportData& data = page.data;
  std::string html = "<section id=\"precision\">\n<h2>Speed against error</h2>\n";
  if (!data.precision_problem.empty())
    html += fmt::format("<p class=\"missing\">{}</p>\n", escape(data.precision_problem));
  std::vector<std::size_t> measured;
  for (std::size_t i = 0; i < data.cases.size(); ++i)
    if (std::any_of(data.precision.rows.begin(), data.precision.rows.end(),
                    [&](const PrecisionRow& row) { return row.case_id == data.cases[i].id; }))
      measured.push_back(i);
  if (measured.empty())
    return html +
           "<p>Not measured in this run: a full <code>odeum report</code> times a few cases, "
           "<code>odeum precision</code> into the same folder all of them.</p>\n</section>\n";
  html +=
      "<p>Time per solve, set-up included, with the plain right-hand side, on one processor: the "
      "least of interleaved repetitions. Compared is the time to reach the same error, absolute, "
      "never that at the same tolerance. <strong>Times are of this machine alone: another program "
      "running at the same time distorts them.</strong> The last column tells: how a fixed piece "
      "of "
      "arithmetic drifted from before the case to after it, and for what part of the time the "
      "timed "
      "runs had the processor. A case is marked as disturbed where the first is beyond 5 %, or the "
      "second below 95 %; cases of another date are of an earlier run.</p>\n";
  if (data.precision_seconds_limit > 0)
    html += fmt::format(
        "<p>To keep a report short, a solve was given up after {:g} ms and repeated a few times "
        "only; <code>odeum precision</code> takes longer and measures every case.</p>\n",
        1e3 * data.precision_seconds_limit);
  html +=
      "<h3>Fastest peer over fastest own</h3>\n<p>The quotient of the times to reach an error. "
      "Above 1 Odeum is faster; coloured where the whole interval is on one side of 1. \"own\" or "
      "\"peer\": only one side reaches the error.</p>\n" +
      ratios_table(page, measured);
  const std::vector<std::string> libraries = libraries_of(data);
  if (measured.size() <= most_diagrams) {
    html += "<h3>Diagrams</h3>\n" + speed_legend(libraries) + "<div class=\"speeds\">\n";
    for (const std::size_t i : measured) {
      const CaseFacts& c = data.cases[i];
      html += fmt::format(
          "<figure><figcaption><a href=\"{}#precision\"><code>{}</code></a> {}, t = {}"
          "</figcaption>{}</figure>\n",
          page.case_address(i), escape(c.id), escape(c.title), show_number(c.timed_end, 6),
          speed_diagram(rows_of(data, c.id), libraries, c.timed_floor, worst_of(c)));
    }
    html += "</div>\n";
  }
  html += std::string("<h3>Tolerance requested and achieved</h3>\n") + tolerances_text;
  for (const std::size_t i : measured)
    html += fmt::format("<details{}><summary><code>{}</code></summary>{}</details>\n",
                        i == measured.front() ? " open" : "", escape(data.cases[i].id),
                        tolerance_table(page, rows_of(data, data.cases[i].id), false));
  return html + "</section>\n";
}

}  // namespace odeum::report
