// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy/campaign.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "odeum/judge/amplification.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"

namespace odeum::tests {
namespace {

struct Point {
  double wrong, right;  ///< errors in the same steps
  double certain;       ///< an error above it is more than rounding
};

/// Right errors by mean step, between which they are a power of the step; NaN outside.
double error_at(const std::vector<study::ConvergenceRow>& rows, double step) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto &coarse = rows[i], &fine = rows[i + 1];
    if (!(step <= coarse.step * 1.01 && step >= fine.step * 0.99) || fine.step == coarse.step)
      continue;
    const double share = std::log(step / coarse.step) / std::log(fine.step / coarse.step);
    return coarse.error_rms * std::pow(fine.error_rms / coarse.error_rms, share);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Point> side_by_side(const Case& c, double gain,
                                const std::vector<study::ConvergenceRow>& wrong,
                                const std::vector<study::ConvergenceRow>& right) {
  const double scale = judge::Judge(c, c.stops).scale();
  std::vector<Point> points;
  for (const study::ConvergenceRow& row : wrong) {
    judge::ErrorPoint rounding;
    rounding.steps = static_cast<double>(row.steps);
    rounding.rounding_unit = 0x1p-53 * gain;
    const double error = error_at(right, row.step);
    if (error < 0.01 * scale && std::isfinite(row.error_rms))
      points.push_back({row.error_rms, error, rounding.certain_error()});
  }
  return points;
}

bool visible(const std::vector<Point>& points, double times) {
  if (points.empty()) return false;
  double low = std::max(1.0, points.front().wrong / points.front().right), high = 0;
  for (std::size_t i = points.size() / 2; i < points.size(); ++i) {
    if (points[i].wrong <= points[i].certain) continue;
    const double ratio = points[i].wrong / points[i].right;
    low = std::min(low, ratio);
    high = std::max(high, ratio);
  }
  return high > times * low;
}

}  // namespace

bool denies(judge::Verdict verdict) {
  return verdict != judge::Verdict::confirmed && verdict != judge::Verdict::higher;
}

Trial tried(const WrongSolver& solver, const Case& c) {
  const Mode mode = solver.adaptive() ? Mode::adaptive : Mode::fixed;
  study::CaseMeasures measures{.gain = judge::perturbation_gain(c)};
  if (mode == Mode::adaptive) measures.amplification = judge::measure_amplification(c, c.stops);
  const auto study_of = [&](bool with_fault) {
    const Entrant entrant = entrant_of(solver, with_fault, c);
    return study::converge_pair({&c, &entrant, mode}, measures, false);
  };
  const study::ConvergenceResult wrong = study_of(true);
  const std::vector<Point> points =
      side_by_side(c, measures.gain, wrong.rows, study_of(false).rows);
  return {wrong.orders.front().fit, visible(points, mode == Mode::fixed ? 4 : 10)};
}

std::vector<WrongSolver> all_wrong() {
  std::vector<WrongSolver> all = wrong_coefficients();
  for (const auto& more :
       {wrong_explicit_steps(), wrong_implicit_steps(), wrong_tableaus(), wrong_adaptive()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<WrongSolver> all_right() {
  std::vector<WrongSolver> all = right_tableaus();
  for (const WrongSolver& solver : all_wrong()) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const WrongSolver& each) {
      return solver.name.starts_with(each.name.substr(0, each.name.find(',')));
    });
    if (known || solver.adaptive()) continue;
    WrongSolver right = solver;
    right.name = solver.name.substr(0, solver.name.find(','));
    right.wrong = solver.right;
    all.push_back(right);
  }
  for (const WrongSolver& solver : right_adaptive()) all.push_back(solver);
  return all;
}

}  // namespace odeum::tests
