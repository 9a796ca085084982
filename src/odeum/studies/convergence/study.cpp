// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "odeum/record/table.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/convergence/section.hpp"
#include "odeum/studies/questions.hpp"

namespace odeum::study {
namespace {

std::string table(const ConvergenceResult& result) {
  const auto wrong = std::count_if(
      result.rows.begin(), result.rows.end(),
      [](const ConvergenceRow& row) { return row.judged.answer == judge::Answer::wrong; });
  const std::string text = record::table_of(result.orders, {{"case", "{case}"},
                                                            {"solver", "{library}/{solver}"},
                                                            {"mode", "{mode}"},
                                                            {"claimed", "{claimed_order:.3g}"},
                                                            {"measured", "{measured_order:.3f}"},
                                                            {"verdict", "{verdict}: {reason}"}})
                               .text();
  if (wrong == 0) return text;
  return text + fmt::format("{} {} ok with a wrong answer: column answer of {}\n", wrong,
                            wrong == 1 ? "run ended" : "runs ended", ConvergenceRow::file);
}

}  // namespace

std::unique_ptr<Study> make_convergence() {
  std::vector<std::string> quick = quick_cases();
  std::erase(quick, long_orders);
  return make_study<ConvergenceResult>(
      {.name = "converge",
       .help = "error against step, and the measured order",
       .place = 20,
       .quick_help = "fewer step sizes",
       .options = {{.name = "mode",
                    .help = "fixed or adaptive; default: both",
                    .words = {"fixed", "adaptive"}}},
       .quick_report = {{.cases = quick}}},
      {.measure = converge, .table = table, .section = add_section});
}

}  // namespace odeum::study
