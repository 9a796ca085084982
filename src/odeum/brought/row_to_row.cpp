// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/row_to_row.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "odeum/judge/errors.hpp"
#include "odeum/measure/recording.hpp"

namespace odeum::brought {
namespace {

using State = std::vector<double>;

/// The state at the next row's time by a solver; empty where it does not get there.
State solved_to(const measure::Recording& from, const char* solver, double t) {
  const Entrant* const entrant = from.solver(solver);
  if (!entrant || !entrant->solve || !entrant->unfit.empty()) return {};
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = 1e-12;
  request.stops = {t};
  request.budget.evaluations = 200'000;
  request.budget.seconds = 5;
  Outcome outcome = entrant->solve(request);
  return outcome.status == Status::ok ? std::move(outcome.states) : State();
}

/// The solution from a row to the next, where two methods of different families agree on it to a
/// tenth of the row's error; else empty.
State solution_between(const Case& c, const Trajectory& run, std::size_t row) {
  const std::size_t n = c.y0.size();
  const State y(run.state(row), run.state(row) + n);
  const measure::Recording from(c, run.times[row], y);
  const double t = run.times[row + 1];
  State implicit = solved_to(from, "odeum/radau_iia5", t);
  if (implicit.size() != n) return {};
  const double error = judge::error_of(c, run.state(row + 1), implicit.data());
  for (const char* other : {"odeum/dormand_prince853", "odeum/rodas4", "cvode/bdf"}) {
    const State second = solved_to(from, other, t);
    if (second.size() == n && judge::error_of(c, second.data(), implicit.data()) <= 0.1 * error)
      return implicit;
  }
  return {};
}

void find_change(const Case& c, const Trajectory& run, RowToRow& found) {
  std::vector<Invariant> all = c.invariants;
  if (c.energy) all.push_back({"energy", c.energy});
  for (const Invariant& each : all) {
    const double start = each.value(run.state(0));
    double size = std::abs(start), change = 0;
    for (std::size_t row = 0; row < run.rows(); ++row) {
      const double value = each.value(run.state(row));
      size = std::max(size, std::abs(value));
      change = std::max(change, std::abs(value - start));
    }
    if (!(size > 0) || !std::isfinite(change)) continue;
    if (!(change / size <= found.change)) {
      found.change = change / size;
      found.invariant = each.name;
    }
  }
}

}  // namespace

RowToRow row_to_row(const Case& c, const Trajectory& run, const std::vector<std::size_t>& rows) {
  RowToRow found;
  if (!run.is_whole(c) || run.rows() < 2) return found;
  find_change(c, run, found);
  constexpr std::size_t most_rows = 24;
  const std::size_t count = std::min(most_rows, rows.size()), n = c.y0.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = rows[k * rows.size() / count];
    if (row + 1 >= run.rows()) break;
    const double* const next = run.state(row + 1);
    if (!is_finite(run.state(row), n) || !is_finite(next, n)) break;
    const State exact = solution_between(c, run, row);
    if (exact.empty()) continue;
    const double apart = run.times[row + 1] - run.times[row];
    State moved = exact;
    for (std::size_t i = 0; i < n; ++i) moved[i] += run.half_place(row + 1)[i];
    ++found.rows;
    found.gain = std::fmax(found.gain, judge::error_of(c, next, exact.data()) / apart);
    found.written =
        std::fmax(found.written, judge::error_of(c, moved.data(), exact.data()) / apart);
  }
  return found;
}

std::vector<std::vector<std::size_t>> rows_of_near_states(const Case& c, const Series& series) {
  constexpr double near = 0.05;
  std::vector<std::vector<std::size_t>> rows(series.runs.size(), {0});
  if (!series.common) return rows;
  const Case seen = seen_by(c, *series.runs.back());
  const State zero(c.y0.size());
  double size = 0;
  for (std::size_t k = 0; k < series.rows.back().size(); ++k) {
    const double* const fine = series.runs.back()->state(series.rows.back()[k]);
    size = std::fmax(size, judge::error_of(seen, fine, zero.data()));
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (!(judge::error_of(seen, series.runs[r]->state(series.rows[r][k]), fine) <= near * size))
        return rows;
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r].push_back(series.rows[r][k]);
  }
  return rows;
}

}  // namespace odeum::brought
