// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/brought/judgement.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/record/table.hpp"

namespace odeum::brought {
namespace {

std::string text_of_order(const SeriesRow& row) {
  if (std::isnan(row.measured_order))
    return row.verdict == judge::Verdict::not_applicable ? "none" : to_string(row.verdict);
  std::string text = fmt::format("{:.2f}", row.measured_order);
  if (std::isfinite(row.order_low))
    text += fmt::format(", between {:.2f} and {:.2f}", row.order_low, row.order_high);
  if (row.verdict != judge::Verdict::not_applicable)
    text += fmt::format(": {}", to_string(row.verdict));
  return text;
}

std::string text_of_claim(const SeriesRow& row) {
  std::string claimed;
  if (!row.method.empty()) claimed = row.method;
  if (!std::isnan(row.claimed_order))
    claimed += fmt::format("{}order {:g}", claimed.empty() ? "" : ", ", row.claimed_order);
  return fmt::format("claim   {}: {}\n", claimed, to_string(row.claim));
}

std::string note(const FileRow& row, const std::string& sentence) {
  return fmt::format("note    {}: {}\n", row.path, sentence);
}

/// How the error of the finest run at its end lies to the solution's path.
std::string text_of_lag(const FileRow& row) {
  if (!std::isfinite(row.lag)) return {};
  return note(
      row, fmt::format("at t = {:.6g} it is {} the truth by {:.3g} in time, which leaves an "
                       "error of {:.2e} aside of the path",
                       row.end, row.lag > 0 ? "behind" : "ahead of", std::abs(row.lag), row.aside));
}

}  // namespace

std::string text_of(const Judgement& judgement, const Case& c) {
  std::string text = fmt::format("case    {}: {}\ntruth   {}\nerrors  {}\n", c.id, c.equation,
                                 c.truth.source, judge::unit_text(c));
  for (const SeriesRow& row : judgement.series) {
    text += fmt::format("\nseries  {}\n", row.series);
    if (row.claim != Claimed::not_applicable) text += text_of_claim(row);
    text += fmt::format("order   {}\n", text_of_order(row));
    if (!row.reason.empty()) text += fmt::format("reason  {}\n", row.reason);
    std::vector<FileRow> files;
    for (const FileRow& file : judgement.files)
      if (file.series == row.series) files.push_back(file);
    for (const FileRow& file : files) {
      if (!file.remarks.empty()) text += note(file, file.remarks);
      if (file.outside > 0)
        text += note(file, fmt::format("{:.3g} % of the times compared lie outside of the tube",
                                       100 * file.outside));
    }
    text += text_of_lag(files.back());
    const bool alone = std::ranges::none_of(
        files, [](double rows) { return rows > 0; }, &FileRow::rows);
    text += record::table_of(files, alone ? FileRow::shown_alone : FileRow::shown).text();
  }
  return text;
}

}  // namespace odeum::brought
