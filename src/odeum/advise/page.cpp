// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/answer_parts.hpp"
#include "odeum/record/rows.hpp"
#include "odeum/report/report.hpp"
#include "odeum/trajectories/run_page.hpp"

namespace odeum::advise {
namespace {

/// A run of the race, with the times of the bare runs where it was timed: a line of race.csv.
struct RaceRow : measure::RunRecord, study::WallTimes {
  double guarded_ns = nan;  ///< less what the guard takes

  static constexpr const char* file = "race.csv";
  ODEUM_COLUMNS(library, solver, status, column("setting_kind", PhraseColumn{mode, "step", "tol"}),
                setting, error, guarded_ns, wall_ns_min, wall_ns_median, repetitions,
                counters.rhs_evaluations, counters.jacobian_evaluations, counters.steps,
                counters.rejected_steps)
};

/// The rows of the race: what was timed comes first, the fastest at the head.
std::vector<RaceRow> rows_of(const Advice& advice) {
  std::vector<RaceRow> rows;
  const auto add = [&](const Candidate& candidate, bool timed) {
    for (const Trial& trial : candidate.trials) {
      const bool has_time = timed && candidate.found && trial.fineness == candidate.found->fineness;
      RaceRow& row = rows.emplace_back(
          RaceRow{trial.parts.front(), has_time ? candidate.times.columns() : study::WallTimes(),
                  trial.ns});
      row.status = to_string(trial.status);
      row.error = trial.status == Status::ok ? trial.state_error() : nan;
    }
  };
  for (const std::size_t k : advice.timed) add(advice.candidates[k], true);
  each_dropped(advice, [&](const Candidate& candidate) { add(candidate, false); });
  return rows;
}

}  // namespace

std::string csv_of(const Advice& advice) { return record::csv_text(rows_of(advice)); }

bool write_page(const record::OutputFolder& folder, const Advice& advice, const Case& c,
                const Asked& asked) {
  folder.write("advice.json", json_of(advice, c, asked).dump(2) + "\n");
  report::Facts facts{.cases = {}, .solvers = {}, .libraries = all_libraries()};
  for (const Candidate& candidate : advice.candidates)
    facts.solvers.push_back(candidate.entrant->info);
  report::Report page(std::move(facts), folder);
  const std::vector<RaceRow> rows = rows_of(advice);
  record::write_rows(rows, folder);
  page.rows("runs", rows);
  trajectories::RunTexts texts{.title = c.title, .lead = c.id, .facts = {{"Equation", c.equation}}};
  const std::string text = text_of(advice, c, asked);
  const std::size_t first = text.find('\n');
  texts.facts.emplace_back("Answer", text.substr(0, first));
  trajectories::add_lines(texts, text.substr(first + 1));
  nlohmann::ordered_json json = trajectories::page_facts("advice", texts);
  json["error"] = advice.run_ns > 0 ? 0 : advice.wishes.error;
  json["time_ns"] = advice.run_ns;
  json["floor"] = advice.floor;
  json["winner"] = advice.failure.empty() ? winner_of(advice).entrant->info.id() : "";
  page.fact("runs", json);
  return page.write({.command_line = "odeum advise " + asked.problem + asked.more});
}

}  // namespace odeum::advise
