// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/record/table.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/html.hpp"

namespace odeum::study {
namespace {

using judge::Verdict;
using report::Cell;
using report::show_number;

std::string two_digits(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.2f}", value);
}

// A cell is one sign wide, so that every case fits on a screen: the order to the nearest whole
// number where it is confirmed, else the verdict's sign. The title holds the rest; why a solver
// does not fit stands once, under "skipped", not in thousands of titles.
Cell matrix_cell(const OrderRow& row) {
  const judge::OrderFit& fit = row.fit;
  const bool fitted = !std::isnan(fit.order);
  std::string title = to_string(fit.verdict);
  if (const OrderClass* const known = class_of(fit)) title += fmt::format(", {}", known->name);
  if (fitted)
    title += fmt::format(": measured {:.2f} [{:.2f}, {:.2f}] over {}, claimed {}", fit.order,
                         fit.low, fit.high, report::show_count(fit.points, "point"),
                         show_number(row.claimed_order));
  if (!fit.reason.empty()) title += ". " + fit.reason;
  const bool confirmed = fit.verdict == Verdict::confirmed && fitted;
  return {
      .text = confirmed ? fmt::format("{:.0f}", fit.order) : report::style_of(fit.verdict).glyph,
      .style = to_string(fit.verdict),
      .title = fit.verdict == Verdict::not_applicable ? "does not apply" : title};
}

std::string matrix(const report::Facts& facts, const std::vector<OrderRow>& orders, Mode mode) {
  const auto rows = by_pair(orders);
  // A report of a part has no columns for what it did not try.
  std::vector<const report::CaseFacts*> cases;
  for (const report::CaseFacts& c : facts.cases)
    if (is_measured(orders, c.id)) cases.push_back(&c);
  std::vector<Cell> head{{.text = "claimed", .style = "claim"}};
  for (const report::CaseFacts* c : cases) head.push_back(report::case_head(*c));
  const auto cells = [&](const SolverInfo& solver) {
    std::vector<Cell> row;
    if (!(mode == Mode::fixed ? solver.fixed : solver.adaptive)) return row;
    row.push_back({.text = std::isnan(solver.order) ? "varies" : show_number(solver.order),
                   .style = "claimed"});
    for (const report::CaseFacts* c : cases) {
      const auto found = rows.find({c->id, solver.id(), mode});
      row.push_back(found == rows.end() ? Cell() : matrix_cell(*found->second.front()));
    }
    return row;
  };
  return report::solver_tables(facts, "matrix", head, cells, mode == Mode::fixed);
}

std::string orders_of_case(const std::vector<const OrderRow*>& rows) {
  report::Table table("numbers orders");
  table.head({{"solver"},
              {"mode"},
              {"claimed"},
              {"measured"},
              {"95 % interval"},
              {"window, h"},
              {"points"},
              {"floor"},
              {"verdict"},
              {"reason"}});
  for (const OrderRow* row : rows) {
    const judge::OrderFit& fit = row->fit;
    if (fit.verdict == Verdict::not_applicable && std::isnan(fit.order)) continue;
    table.row({row->library + "/" + row->solver},
              {{to_string(row->mode)},
               {show_number(row->claimed_order)},
               {two_digits(fit.order)},
               {two_digits(fit.low) + " … " + two_digits(fit.high)},
               {show_number(fit.step_coarsest) + " … " + show_number(fit.step_finest)},
               {std::to_string(fit.points)},
               {show_number(fit.floor)},
               {.markup = report::verdict_chip(fit.verdict)},
               {.text = fit.reason, .style = "reason"}});
  }
  return table.html();
}

// "12 unstable at every step tried, 3 over budget at every setting": the largest first.
std::string words_of_classes(const std::vector<const OrderRow*>& rows) {
  std::map<std::string_view, std::size_t> counts;
  for (const OrderRow* row : rows)
    if (const OrderClass* const known = class_of(row->fit)) ++counts[known->name];
  std::vector<std::pair<std::string_view, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string words;
  for (const auto& [name, count] : sorted)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, name);
  return report::escape(words);
}

void add_orders_of_cases(report::Page& page, const std::vector<OrderRow>& orders) {
  auto by_case = report::group_by(orders, &OrderRow::case_id);
  for (std::size_t i = 0; i < page.facts().cases.size(); ++i) {
    const auto& rows = by_case[page.facts().cases[i].id];
    VerdictCounts counts{};
    for (const OrderRow* row : rows) ++of(counts, row->fit.verdict);
    page.case_fact(i, "Orders", verdict_bar(counts) + " " + verdict_words(counts));
    if (const std::string why = words_of_classes(rows); !why.empty())
      page.case_fact(i, "Without an order", why);
    if (const std::string table = orders_of_case(rows); !table.empty())
      page.case_part(i, {.id = "orders", .title = "Orders", .place = 40, .html = table});
  }
}

std::string summary_html(const std::vector<LibrarySummary>& summary) {
  report::Table table("numbers");
  std::vector<Cell> head{{"library"}, {"solvers"}, {"pairs"}};
  for (const auto& style : report::verdict_styles)
    head.push_back({.markup = report::verdict_chip(style.verdict)});
  table.head(head);
  for (const LibrarySummary& entry : summary) {
    std::vector<Cell> cells{{std::to_string(entry.solvers)}, {std::to_string(entry.pairs)}};
    for (const std::size_t count : entry.verdicts)
      cells.push_back({.text = std::to_string(count), .style = count == 0 ? "zero" : ""});
    table.row({entry.library}, cells);
  }
  return table.html();
}

nlohmann::ordered_json summary_json(const std::vector<LibrarySummary>& summary) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const LibrarySummary& entry : summary) {
    list.push_back(
        {{"library", entry.library}, {"solvers", entry.solvers}, {"pairs", entry.pairs}});
    for (std::size_t i = 0; i < entry.verdicts.size(); ++i)
      list.back()[to_string(report::verdict_styles[i].verdict)] = entry.verdicts[i];
  }
  return list;
}

std::string guide() {
  std::string html =
      "<p>A solver is run on a case with smaller and smaller steps. Where its error falls as a "
      "power of the step, the power is its measured order: the slope of a line through the points "
      "of the asymptotic window, with a 95 % interval. A claimed order and a measured one give a "
      "verdict; a pair is a solver on a case in one mode (fixed step, or the solver's own choice "
      "of it).</p>\n<ul class=\"key\">\n";
  for (const auto& style : report::verdict_styles)
    html += fmt::format("<li>{} {}</li>\n", report::verdict_chip(style.verdict), style.meaning);
  return html + "</ul>\n";
}

constexpr const char* matrix_text =
    "<p>The measured order of every solver on every case. A number, the order to the nearest whole "
    "one, confirms the claim; any other sign is the verdict. The tooltip of a cell gives the order "
    "in full, its interval and the reason; the page of a case has them as a table.</p>\n"
    "<h3>At a fixed step</h3>\n";
constexpr const char* adaptive_text =
    "<h3>At a step of the solver's own choice</h3>\n<p>The order here is the slope against the "
    "mean step as the tolerance falls, a less strict measure.</p>\n";

// The runs and orders of every case, for the view that compares solvers.
void add_data(report::Page& page, const ConvergenceResult& result) {
  auto runs = report::group_by(result.rows, &ConvergenceRow::case_id);
  auto orders = report::group_by(result.orders, &OrderRow::case_id);
  for (std::size_t i = 0; i < page.facts().cases.size(); ++i) {
    const std::string& id = page.facts().cases[i].id;
    if (runs[id].empty()) continue;
    page.case_data(i, "runs",
                   report::columns_of(
                       runs[id], {"library", "solver", "mode", "status", "detail", "step",
                                  "tolerance", "steps", "rejected_steps", "error_max", "error_rms",
                                  "energy_error", "rhs_evaluations", "jacobian_evaluations"}));
    page.case_data(i, "orders",
                   report::columns_of(
                       orders[id], {"library", "solver", "mode", "claimed_order", "measured_order",
                                    "order_low", "order_high", "step_coarsest", "step_finest",
                                    "floor", "verdict", "reason"}));
  }
}

}  // namespace

bool is_measured(const std::vector<OrderRow>& orders, const std::string& case_id) {
  return std::any_of(orders.begin(), orders.end(),
                     [&](const OrderRow& row) { return row.case_id == case_id; });
}

std::vector<LibrarySummary> summarise(const report::Facts& facts,
                                      const std::vector<OrderRow>& orders) {
  std::vector<LibrarySummary> list;
  for (const std::string& name : facts.library_names()) list.push_back({.library = name});
  LibrarySummary all{.library = "all"};
  const auto count = [&](const std::string& library, auto&& add) {
    for (LibrarySummary& entry : list)
      if (entry.library == library) add(entry);
    add(all);
  };
  for (const SolverInfo& solver : facts.solvers)
    count(solver.library, [](LibrarySummary& entry) { ++entry.solvers; });
  for (const OrderRow& row : orders)
    count(row.library, [&](LibrarySummary& entry) {
      ++entry.pairs;
      ++of(entry.verdicts, row.fit.verdict);
    });
  list.push_back(all);
  return list;
}

std::string summary_text(const report::Facts& facts, const std::vector<OrderRow>& orders) {
  record::Table table{{{"library"}, {"solvers", true}, {"pairs", true}}, {}};
  for (const auto& style : report::verdict_styles)
    table.columns.push_back({to_string(style.verdict), true});
  for (const LibrarySummary& entry : summarise(facts, orders)) {
    std::vector<std::string> row{report::plain(entry.library), std::to_string(entry.solvers),
                                 std::to_string(entry.pairs)};
    for (const std::size_t count : entry.verdicts) row.push_back(std::to_string(count));
    table.rows.push_back(std::move(row));
  }
  return table.text();
}

void add_section(report::Page& page, const ConvergenceResult& result, const Origin& origin) {
  const report::Facts& facts = page.facts();
  const std::vector<LibrarySummary> summary = summarise(facts, result.orders);
  page.headline(summary_html(summary));
  page.guide(guide());
  page.manifest("verdicts", summary_json(summary));
  for (const ConvergenceRow& row : result.rows)
    page.count_row(row.status, row.status == "not_applicable" ? row.detail : "");
  page.section({.id = "overview",
                .title = "Cases",
                .place = 0,
                .html = overview(facts, result.orders),
                .short_title = "Cases"});
  page.section({.id = "orders",
                .title = "Orders, solver by solver",
                .place = origin.place,
                .html = matrix_text + matrix(facts, result.orders, Mode::fixed) + adaptive_text +
                        matrix(facts, result.orders, Mode::adaptive),
                .short_title = "Orders"});
  add_verdicts(page, result);
  add_plots(page, result);
  add_orders_of_cases(page, result.orders);
  add_data(page, result);
}

}  // namespace odeum::study
