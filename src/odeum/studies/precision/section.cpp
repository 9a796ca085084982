// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "odeum/core/machine.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/html.hpp"
#include "odeum/studies/questions.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {
namespace {

using report::CaseFacts;
using report::Cell;
using report::escape;
using report::show_number;
using report::show_time;

// More diagrams than this would make the page heavy; each case's own page has its diagram anyway.
constexpr std::size_t most_diagrams = 8;

// An error beyond it only says that the run diverged.
double worst_of(const CaseFacts& c) { return 10 * c.scale; }

/// What there is of one case.
struct Measured {
  const CaseFacts* c = nullptr;
  std::size_t index = 0;  ///< of the case
  std::vector<PrecisionRow> rows;
  std::vector<const PrecisionSummary*> summary;
};

std::vector<Measured> by_case(const report::Facts& facts, const PrecisionResult& result) {
  std::map<std::string, Measured> sorted;
  for (const PrecisionRow& row : result.rows) sorted[row.case_id].rows.push_back(row);
  for (const PrecisionSummary& line : result.summary) sorted[line.case_id].summary.push_back(&line);
  std::vector<Measured> measured;
  for (std::size_t i = 0; i < facts.cases.size(); ++i)
    if (const auto found = sorted.find(facts.cases[i].id);
        found != sorted.end() && !found->second.rows.empty()) {
      measured.push_back(found->second);
      measured.back().c = &facts.cases[i];
      measured.back().index = i;
    }
  return measured;
}

// When a case was measured, and what the calibration said: a mark where the machine was disturbed.
std::string conditions(const std::vector<PrecisionRow>& rows) {
  const auto timed = std::find_if(rows.begin(), rows.end(),
                                  [](const PrecisionRow& row) { return row.repetitions > 0; });
  if (timed == rows.end()) return "<span class=\"dim\">nothing could be timed</span>";
  const bool marked = disturbed(timed->drift, timed->processor_share);
  return fmt::format(
      "<span class=\"{}\">{}drift {:+.1f} %, processor {:.0f} %</span> <span "
      "class=\"dim\">{}</span>",
      marked ? "chip lower" : "dim", marked ? "⚠ disturbed: " : "", 100 * timed->drift,
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

Cell ratio_cell(const PrecisionSummary& line) {
  return {.text = short_ratio(line),
          .style = colour_of(line),
          .title = !line.reason.empty()
                       ? line.reason
                       : fmt::format("{} {} against {} {}: {:.2f} ({:.2f} to {:.2f})", line.own,
                                     show_time(line.own_ns), line.peer, show_time(line.peer_ns),
                                     line.ratio, line.ratio_low, line.ratio_high)};
}

std::string fastest_table(const std::vector<const PrecisionSummary*>& summary) {
  report::Table table("numbers fastest");
  table.head({{"error"},
              {"fastest own"},
              {"time"},
              {"fastest peer"},
              {"time"},
              {"peer / own"},
              {"interval"}});
  for (const PrecisionSummary* line : summary) {
    const bool compared = line->reason.empty();
    table.row(
        {fmt::format("{:.0e}", line->error)},
        {{line->own.empty() ? "–" : line->own},
         {show_time(line->own_ns)},
         {line->peer.empty() ? "–" : line->peer},
         {show_time(line->peer_ns)},
         {.text = compared ? fmt::format("{:.2f}", line->ratio) : "–", .style = colour_of(*line)},
         {compared ? fmt::format("{:.2f} … {:.2f}", line->ratio_low, line->ratio_high)
                   : line->reason}});
  }
  return table.html();
}

// All cases against all errors: who is faster, and by how much.
std::string ratios_table(const std::vector<Measured>& measured) {
  report::Table table("numbers ratios");
  std::vector<Cell> head{{"case"}};
  for (int exponent = 2; exponent <= 12; ++exponent)
    head.push_back({fmt::format("1e-{:02}", exponent)});
  head.push_back({"calibration"});
  table.head(head);
  for (const Measured& each : measured) {
    std::vector<Cell> cells;
    for (const PrecisionSummary* line : each.summary) cells.push_back(ratio_cell(*line));
    cells.push_back({.markup = conditions(each.rows)});
    table.row({.markup = report::case_link(*each.c, "precision")}, cells);
  }
  return table.html();
}

constexpr const char* tolerances_text =
    "<h3>Tolerance requested and achieved</h3>\n<p>What solvers that choose their own steps "
    "achieve "
    "of the tolerance that they are given: log<sub>10</sub> of achieved over requested, +1 meaning "
    "ten times the tolerance. A tolerance bounds the error of a step and this is the error at the "
    "end, so that zero is not to be expected; an even row matters more. Of a group its median; the "
    "tooltip of a cell gives the range. ✗: some answers are wrong, their errors larger than "
    "tolerance, steps and the amplification of errors by the case explain.</p>\n";

constexpr const char* times_text =
    "<p>Time per solve, set-up included, with the plain right-hand side, on one processor: the "
    "minimum of interleaved repetitions; what cannot be the fastest of its library at its error is "
    "timed once, several at a time, or by the run that gave its error. Compared is the time to "
    "reach the same error, absolute, "
    "never that at the same tolerance. <strong>Times are of this machine alone: another program "
    "running at the same time distorts them.</strong> The last column tells: how the speed of a "
    "fixed piece of arithmetic drifted from before the case to after it, and for what part of the "
    "time the timed runs had the processor. A case is marked as disturbed where the first is "
    "beyond "
    "5 %, or the second below 95 %; cases of another date are of an earlier run. A report gives "
    "each solve little time, to stay short; <code>odeum precision</code> takes longer and measures "
    "every case.</p>\n<h3>Fastest peer over fastest own</h3>\n<p>The quotient of the times to "
    "reach "
    "an error. Above 1 Odeum is faster; coloured where the whole interval is on one side of 1. "
    "\"own\" or \"peer\": only one side reaches the error.</p>\n";

/// Which builds of the peers a time is of; empty where none of them is a library of its own.
std::string builds_text() {
  std::string files;
  for (const std::string& file :
       loaded_libraries({"libsundials_cvode.", "libgsl.", "libBulletDynamics"}))
    files += (files.empty() ? "" : ", ") + ("<code>" + escape(file) + "</code>");
  if (files.empty()) return {};
  return "<p class=\"dim\">Own solvers and odeint are compiled for this processor. The other "
         "libraries are as loaded: " +
         files +
         ". Debian's own are for any processor of the kind, and its SUNDIALS 6.4.1 is compiled "
         "without "
         "optimisation: built for the processor (<code>scripts/sundials</code>) it takes a fifth "
         "to a "
         "third of the time.</p>\n";
}

std::string case_html(const report::Facts& facts, const Measured& each,
                      const std::vector<std::string>& libraries) {
  const CaseFacts& c = *each.c;
  const std::string diagram = speed_diagram(each.rows, libraries, c.timed_floor, worst_of(c));
  const std::string table = tolerance_table(facts, each.rows, true);
  return fmt::format("<p>At t = {}. {}</p>\n", show_number(c.timed_end, 6), conditions(each.rows)) +
         (diagram.empty() ? "<p class=\"missing\">nothing to draw</p>\n"
                          : "<figure class=\"speed\">" + diagram + speed_legend(libraries) +
                                "</figure>\n" + builds_text()) +
         (each.rows.front().jacobian == "differenced"
              ? "<p>The equation has no Jacobian: every implicit solver differences its right-hand "
                "side.</p>\n"
              : "") +
         "<h3>Fastest at an error</h3>\n" + fastest_table(each.summary) +
         (table.empty() ? "" : tolerances_text + table);
}

std::string diagrams(const std::vector<Measured>& measured,
                     const std::vector<std::string>& libraries) {
  if (measured.size() > most_diagrams) return {};
  std::string html =
      "<h3>Diagrams</h3>\n" + speed_legend(libraries) + builds_text() + "<div class=\"speeds\">\n";
  for (const auto& [c, index, rows, summary] : measured)
    html += fmt::format("<figure><figcaption>{} {}, t = {}</figcaption>{}</figure>\n",
                        report::case_link(*c, "precision"), escape(c->title),
                        show_number(c->timed_end, 6),
                        speed_diagram(rows, libraries, c->timed_floor, worst_of(*c)));
  return html + "</div>\n";
}

// The questions of the first page with who is fastest, and the timed runs of every case, for the
// page's scripts.
void add_answers(report::Page& page, const std::vector<Measured>& measured) {
  nlohmann::ordered_json asked = nlohmann::ordered_json::array();
  for (const Question& question : questions)
    asked.push_back({{"title", question.title}, {"case", question.case_id}});
  page.data("index", "questions", asked.dump());
  std::vector<FastestRow> best;
  for (const Measured& each : measured) {
    page.case_data(each.index, "timed",
                   report::columns_of(
                       each.rows, {"library", "solver", "setting_kind", "status", "detail",
                                   "setting", "options", "error", "wall_ns_min", "wall_ns_median",
                                   "repetitions", "rhs_evaluations", "jacobian_evaluations",
                                   "steps", "pareto", "drift", "processor_share", "measured"}));
    // From the rows, which may be of an earlier run that left no fastest.csv.
    const std::vector<FastestRow> of_case = fastest(each.rows, each.c->timed_floor);
    best.insert(best.end(), of_case.begin(), of_case.end());
  }
  page.data("index", "fastest",
            report::columns_of(best, {"case", "error", "library", "solver", "setting_kind",
                                      "setting", "wall_ns_min", "wall_ns_median"}));
}

}  // namespace

void add_section(report::Page& page, const PrecisionResult& result, const Origin& origin) {
  const std::vector<Measured> measured = by_case(page.facts(), result);
  // All of them, so that a library has the same colour on every page.
  const std::vector<std::string> libraries = page.facts().library_names();
  std::string html = origin_text(origin, measured.empty());
  if (!measured.empty())
    html += times_text + ratios_table(measured) + diagrams(measured, libraries) + tolerances_text;
  for (const Measured& each : measured) {
    html += report::details("<code>" + escape(each.c->id) + "</code>",
                            tolerance_table(page.facts(), each.rows, false),
                            &each == &measured.front());
    page.case_part(each.index, {.id = "precision",
                                .title = "Speed against error",
                                .place = 30,
                                .html = case_html(page.facts(), each, libraries)});
  }
  add_answers(page, measured);
  page.section({.id = "precision",
                .title = "Speed against error",
                .place = origin.place,
                .html = html,
                .short_title = "Speed"});
}

}  // namespace odeum::study
