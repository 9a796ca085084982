// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/material/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odeum::study {
namespace {

// Times in periods of the slowest mode.
constexpr double periods_a_round = 4, periods_swinging = 5;

// Each round of settling starts at rest at the mean of the one before, which removes most of the
// swing: this many suffice unless the rest position drifts.
constexpr int most_rounds = 12;
constexpr double settled_swing = 1e-3;  // of the sag

// A swing that grows by this factor is unstable.
constexpr double grown = 100;

/// Heights of the masses (the fixed point left out) after each step.
struct Run {
  Outcome outcome;
  std::vector<std::vector<double>> heights;
};

Run run(const Specimen& specimen, const SceneStage& stage, const Entrant& entrant, double step,
        const Iterations& iterations, std::uint64_t steps) {
  Request request;
  request.steps = steps;
  iterations.ask(request);
  for (std::uint64_t i = 1; i <= steps; ++i) request.stops.push_back(static_cast<double>(i) * step);
  request.budget.evaluations = 1'000 * steps;
  Run result;
  result.outcome = entrant.solve(request);
  if (result.outcome.status != Status::ok) return result;
  const std::size_t n = stage.y0->size();
  for (std::uint64_t k = 0; k < steps; ++k) {
    std::vector<double> heights;
    for (std::size_t i = 1; i <= specimen.masses; ++i)
      heights.push_back(result.outcome.states[k * n + 3 * i + 1]);
    result.heights.push_back(std::move(heights));
  }
  return result;
}

bool unstable(const Outcome& outcome) { return outcome.status == Status::non_finite; }

MaterialRow failed(MaterialRow row, const Outcome& outcome) {
  row.status = unstable(outcome) ? "unstable" : to_string(outcome.status);
  row.detail = unstable(outcome) ? "grows without bound" : outcome.detail;
  return row;
}

/// Sets the start to heights, at rest.
void start_from(const SceneStage& stage, const std::vector<double>& heights) {
  std::vector<double>& y = *stage.y0;
  std::ranges::fill(y, 0);
  for (std::size_t i = 0; i < heights.size(); ++i) y[3 * (i + 1) + 1] = heights[i];
}

/// Range of the lowest mass over a run, and mean positions of all.
struct Swing {
  std::vector<double> mean;
  double half;  ///< half the distance from highest to lowest, m
};

Swing swing_of(const Run& run) {
  Swing swing{std::vector<double>(run.heights.front().size(), 0), 0};
  double low = run.heights.front().back(), high = low;
  for (const auto& heights : run.heights) {
    for (std::size_t i = 0; i < heights.size(); ++i) swing.mean[i] += heights[i];
    low = std::min(low, heights.back()), high = std::max(high, heights.back());
  }
  for (double& height : swing.mean) height /= static_cast<double>(run.heights.size());
  swing.half = (high - low) / 2;
  return swing;
}

/// The steps of a run of so many periods of the slowest mode.
std::uint64_t steps_of(const Specimen& specimen, double periods, double step) {
  const double period = 2 * std::numbers::pi / specimen.frequency();
  return static_cast<std::uint64_t>(std::ceil(std::max(60.0, periods * period / step)));
}

/// The specimen at rest under gravity.
struct Rest {
  std::vector<double> heights;
  double sag = 0, swing = 0;  ///< of the lowest mass; half of what is left of its motion, m
};

/// Lets the specimen settle, each round from the mean of the one before. None where it does not;
/// the row then says why.
std::optional<Rest> settle(const Specimen& specimen, const SceneStage& stage,
                           const Entrant& entrant, const Iterations& iterations, MaterialRow& row) {
  Rest rest;
  const scene::Scene scene = specimen.scene();
  for (std::size_t i = 1; i <= specimen.masses; ++i)
    rest.heights.push_back(scene.particles[i].position[1]);
  for (int round = 0; round < most_rounds; ++round) {
    start_from(stage, rest.heights);
    const std::uint64_t count = steps_of(specimen, periods_a_round, row.step);
    const Run settling = run(specimen, stage, entrant, row.step, iterations, count);
    if (settling.outcome.status != Status::ok) {
      row = failed(row, settling.outcome);
      return std::nullopt;
    }
    const Swing seen = swing_of(settling);
    if (!(seen.half < grown * specimen.sag())) {
      row.status = "unstable";
      remark(row, "moves away from rest");
      return std::nullopt;
    }
    rest.heights = seen.mean;
    rest.sag = -seen.mean.back() - static_cast<double>(specimen.masses) * specimen.length;
    rest.swing = seen.half;
    if (rest.swing <= settled_swing * std::abs(rest.sag)) break;
  }
  return rest;
}

/// The static stiffness, from the sag.
void measure_rest(const Specimen& specimen, const Rest& rest, MaterialRow& row) {
  if (std::abs(rest.sag) < 1e-9 * specimen.sag())
    remark(row, "no sag under gravity, to rounding");
  else
    row.static_stiffness_ratio = specimen.sag() / rest.sag;
  if (rest.sag <= -1e-9 * specimen.sag()) remark(row, "hangs higher than without gravity");
  if (rest.swing > 10 * settled_swing * std::abs(rest.sag) && rest.swing > 1e-9 * specimen.sag())
    remark(row, fmt::format("not settled: rest is the mean of an oscillation of {:.2g} of the sag",
                            rest.swing / std::abs(rest.sag)));
}

/// The component of a motion about the rest in the slowest mode, over time, from `amplitude` on; a
/// scalar product, since masses are equal.
std::vector<double> slowest_mode(const Run& swung, const std::vector<double>& shape,
                                 const std::vector<double>& rest, double amplitude) {
  double norm = 0;
  for (const double x : shape) norm += x * x;
  std::vector<double> z{amplitude};
  for (const auto& at : swung.heights) {
    double sum = 0;
    for (std::size_t i = 0; i < shape.size(); ++i) sum += shape[i] * (at[i] - rest[i]);
    z.push_back(sum / norm);
  }
  return z;
}

/// The dynamic stiffness and the damping, from the slowest mode.
void measure_swing(const Specimen& specimen, const SceneStage& stage, const Entrant& entrant,
                   const Iterations& iterations, const Rest& rest, MaterialRow& row) {
  const std::vector<double> shape = specimen.shape();
  const double amplitude = std::max(specimen.sag(), rest.sag) / 10;
  std::vector<double> heights = rest.heights;
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += amplitude * shape[i];
  start_from(stage, heights);
  const std::uint64_t steps = steps_of(specimen, periods_swinging, row.step);
  const Run swung = run(specimen, stage, entrant, row.step, iterations, steps);
  if (swung.outcome.status != Status::ok) {
    row = failed(row, swung.outcome);
    return;
  }
  const std::vector<double> z = slowest_mode(swung, shape, rest.heights, amplitude);
  if (!(std::abs(z.back()) < grown * amplitude)) {
    row.status = "unstable";
    remark(row, "the oscillation grows");
    return;
  }
  const Vibration found = fit_vibration(z, row.step);
  if (found.reason.empty()) {
    const double w = specimen.frequency(), nominal = specimen.damping_ratio();
    row.dynamic_stiffness_ratio = found.omega_squared / (w * w);
    row.damping = nominal > 0 ? found.decay / (2 * nominal * w) : nan;
    row.added_damping_ratio = found.decay / (2 * std::sqrt(found.omega_squared)) - nominal;
  } else {
    remark(row, found.reason);
  }
  if (std::isnan(row.static_stiffness_ratio) || std::isnan(row.dynamic_stiffness_ratio))
    row.status = "unmeasured";
}

}  // namespace

MaterialRow measure_response(const Specimen& specimen, const SceneStage& stage,
                             const Entrant& entrant, double step, const Iterations& iterations) {
  auto row = named_row<MaterialRow>(entrant.info);
  row.scene = specimen.name;
  row.step = step;
  row.sweeps = iterations.sweeps;
  row.newton = iterations.newton;
  row.phase = step * specimen.frequency();
  row.status = to_string(Status::ok);
  if (!entrant.unfit.empty()) return not_applicable(row, entrant.unfit);
  if (const auto rest = settle(specimen, stage, entrant, iterations, row)) {
    measure_rest(specimen, *rest, row);
    measure_swing(specimen, stage, entrant, iterations, *rest, row);
  }
  return row;
}

MaterialResult measure_material(const Options& options, const Runner& runner) {
  constexpr double steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 960};
  constexpr std::uint64_t counts[] = {1, 2, 4, 8, 16, 32};
  struct Task {
    Specimen specimen;
    std::string id;
    Iterations iterations;
  };
  std::vector<Task> tasks;
  for (const Specimen& specimen : {one_mass(), hanging_chain()}) {
    const SceneStage stage(specimen.scene());
    for (const Entrant& entrant : stage.entrants) {
      const SolverInfo& info = entrant.info;
      const std::string id = info.id();
      if (!is_compared(info, options)) continue;
      tasks.push_back({specimen, id, {}});
      // The default is one sweep, or one Newton iteration.
      for (const std::uint64_t count : counts) {
        // Conjugate gradients need at most as many iterations as there are masses.
        const bool newton = info.options.contains("newton");
        if (info.options.contains("sweeps") && (newton ? count < 2 * specimen.masses : count > 1))
          tasks.push_back({specimen, id, {.sweeps = count}});
        if (newton && count == 4) tasks.push_back({specimen, id, {.newton = count}});
      }
    }
  }
  const auto key = [](const Task& task) {
    return fmt::format("{} {} {} {}", task.specimen.name, task.id, task.iterations.sweeps,
                       task.iterations.newton);
  };
  return runner.run("material", tasks, key, [&](const Task& task) {
    const SceneStage stage(
        task.specimen.scene());  // one per task, since its initial state is changed
    MaterialResult result;
    for (const double step : steps)
      result.rows.push_back(measure_response(
          task.specimen, stage, find_solver(stage.entrants, task.id), step, task.iterations));
    return result;
  });
}

}  // namespace odeum::study
