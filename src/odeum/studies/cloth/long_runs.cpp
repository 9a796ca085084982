// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/reference.hpp"
#include "odeum/cases/square_cloth.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/scene/model/momentum.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/studies/cloth/cloth.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::study {
namespace {

constexpr std::size_t side = cloth_side;
constexpr double horizon = 10, between = 0.5;  // s
constexpr double steps[] = {1.0 / 60, 1.0 / 240};
constexpr double tolerance = 1e-6;
constexpr const char* reference_file = "cloth11_two_way_long";

/// The cloth of the cases without fixed particles, gravity and dampers; dampers of the whole
/// relative velocity would change its angular momentum.
scene::Scene free_cloth() {
  scene::Scene scene = cases::square_cloth(side, 10);
  scene.gravity = {};
  for (scene::Particle& particle : scene.particles) particle.fixed = false;
  for (scene::Spring& spring : scene.springs) spring.damping = 0;
  return scene;
}

double change(const scene::Vec3& now, const scene::Vec3& first) {
  double difference = 0, size = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    difference += (now[d] - first[d]) * (now[d] - first[d]);
    size += first[d] * first[d];
  }
  return std::sqrt(difference / size);
}

struct Stage {
  const char* name;
  scene::Scene scene;
  SceneStage solvers{scene};
  scene::SceneProblem problem{scene};
  std::vector<double> times{};
  std::vector<double> reference{};               ///< states at the times; empty: none
  std::vector<std::string> reference_sources{};  ///< by time
  std::string reference_problem{};
};

/// The states at the times by a method of the truth, in extended precision on forces that are
/// rounded to double; empty where it does not reach the last one.
std::vector<double> states_by(truth::Method method, const Stage& stage) {
  const std::size_t n = stage.solvers.y0->size();
  std::vector<double> y(n), f(n);
  truth::System system;
  system.states = n;
  system.y0.assign(stage.solvers.y0->begin(), stage.solvers.y0->end());
  system.rounding = 0x1p-53L;
  system.rhs = [&](truth::Real t, const truth::Real* state, truth::Real* slope) {
    std::copy_n(state, n, y.begin());
    stage.problem.rhs(static_cast<double>(t), y.data(), f.data());
    std::copy_n(f.begin(), n, slope);
  };
  const truth::Run run = method(system, {stage.times.begin(), stage.times.end()},
                                {.tolerance = 1e-11L, .budget = 1e9});
  std::vector<double> states;
  if (run.end.empty())
    for (const truth::State& at : run.states) states.insert(states.end(), at.begin(), at.end());
  return states;
}

/// The reference file knows the hanging cloth up to 2 s. Later states are those of two methods of
/// different families that take no part, which have to agree with each other and before 2 s with
/// the file.
void find_reference(Stage& stage) {
  stage.reference = states_by(truth::verner_run, stage);
  const std::vector<double> other = states_by(truth::extrapolation_run, stage);
  const Truth file = cases::reference_truth(reference_file, 4e-17);
  const std::size_t n = stage.solvers.y0->size();
  double apart = 0;
  const auto compare = [&](std::size_t k, const double* y) {
    for (std::size_t i = 0; i < n / 2; ++i)
      apart = std::max(apart, std::abs(stage.reference[k * n + i] - y[i]));
  };
  const bool complete =
      stage.reference.size() == stage.times.size() * n && other.size() == stage.reference.size();
  std::vector<double> exact(n);
  for (std::size_t k = 0; complete && k < stage.times.size(); ++k) {
    compare(k, other.data() + k * n);
    const bool known = file.at(stage.times[k], exact.data());
    if (known) {
      compare(k, exact.data());
      std::ranges::copy(exact, stage.reference.data() + k * n);
    }
    stage.reference_sources.emplace_back(
        known ? reference_file : "Verner's pair 9(8) and Gragg's extrapolation agree");
  }
  if (complete && apart < 1e-6) return;
  stage.reference.clear();
  stage.reference_sources.assign(stage.times.size(), "none");
  stage.reference_problem =
      fmt::format("no reference: two computed ones and the file are {:.1e} m apart", apart);
}

struct Quantity {
  const char* name;
  double value, reference;
};

/// The shape of the hanging cloth.
std::vector<Quantity> shape_of(const Stage& stage, const double* y, const double* exact) {
  const std::size_t particles = stage.scene.size();
  const auto lowest = [&](const double* at) {
    double low = at[1];
    for (std::size_t i = 0; i < particles; ++i) low = std::min(low, at[3 * i + 1]);
    return low;
  };
  double apart = nan;
  if (exact)
    apart = rms_distance({y, y + 3 * particles}, {exact, exact + 3 * particles}, particles);
  return {{"energy", stage.problem.energy(y), exact ? stage.problem.energy(exact) : nan},
          {"drape", apart, 0},
          {"lowest", lowest(y), exact ? lowest(exact) : nan}};
}

/// The momenta of the free cloth.
std::vector<Quantity> momenta_of(const Stage& stage, const double* y) {
  std::vector<double> masses;
  for (const scene::Particle& particle : stage.scene.particles) masses.push_back(particle.mass);
  const double* const start = stage.solvers.y0->data();
  const auto changed = [&](auto of) { return change(of(masses, y), of(masses, start)); };
  return {{"linear_momentum", changed(scene::linear_momentum), 0},
          {"angular_momentum", changed(scene::angular_momentum), 0}};
}

std::vector<LongRunRow> run(const Stage& stage, const Entrant& entrant, Mode mode, double setting) {
  auto blank = named_row<LongRunRow>(entrant.info);
  blank.scene = stage.name;
  blank.setting_kind = setting_kind(mode);
  blank.setting = setting;
  blank.detail = stage.reference_problem;
  if (!entrant.unfit.empty()) return {not_applicable(blank, entrant.unfit)};
  Request request;
  request.mode = mode;
  request.stops = stage.times;
  request.steps = static_cast<std::uint64_t>(std::llround(horizon / setting));
  if (mode == Mode::adaptive) request.steps = 0, request.tolerance = setting;
  request.budget.evaluations = 1'000'000;
  const Outcome outcome = entrant.solve(request);
  const std::size_t n = stage.solvers.y0->size();
  std::vector<LongRunRow> rows;
  blank.status = to_string(Status::ok);
  for (std::size_t k = 0; (k + 1) * n <= outcome.states.size(); ++k) {
    const double* const y = outcome.states.data() + k * n;
    const double* const exact = stage.reference.empty() ? nullptr : stage.reference.data() + k * n;
    blank.time = stage.times[k];
    blank.reference_source = stage.reference_sources[k];
    for (const Quantity& quantity :
         stage.scene.gravity[1] != 0 ? shape_of(stage, y, exact) : momenta_of(stage, y)) {
      LongRunRow& row = rows.emplace_back(blank);
      row.quantity = quantity.name;
      row.value = quantity.value;
      row.reference = quantity.reference;
    }
  }
  blank.reference_source = "none";
  // The run ends where numbers leave the range of doubles.
  const auto lost = std::ranges::find_if(rows, [](const LongRunRow& row) {
    return !std::isfinite(row.value) && row.quantity != "drape";
  });
  const bool overflown = lost != rows.end();
  rows.erase(lost, rows.end());
  if (outcome.status != Status::ok || overflown) {
    LongRunRow row = blank;
    row.status = to_string(overflown ? Status::non_finite : outcome.status);
    row.detail = overflown ? "beyond the range of doubles" : outcome.detail;
    row.time = outcome.t;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

ClothResult measure_long_runs(const Options& options, const Runner& runner) {
  Stage stages[] = {{"hanging", cases::square_cloth(side, 10)}, {"free", free_cloth()}};
  for (Stage& stage : stages)
    for (int k = 1; k * between <= horizon; ++k) stage.times.push_back(k * between);
  find_reference(stages[0]);
  stages[1].reference_sources.assign(stages[1].times.size(), "conserved");
  struct Task {
    const Stage* stage;
    const Entrant* entrant;
    Mode mode;
    double setting;
  };
  std::vector<Task> tasks;
  for (const Stage& stage : stages)
    for (const Entrant& entrant : stage.solvers.entrants) {
      const CommonUse use = entrant.info.common_use;
      if (use == CommonUse::none || !any_glob_matches(options.solvers, entrant.info.id())) continue;
      if (use == CommonUse::tolerance)
        tasks.push_back({&stage, &entrant, Mode::adaptive, tolerance});
      else
        for (const double step : steps) tasks.push_back({&stage, &entrant, Mode::fixed, step});
    }
  const auto key = [](const Task& task) {
    return fmt::format("{} {} {}", task.stage->name, task.entrant->info.id(), task.setting);
  };
  return runner.run("long runs", tasks, key, [](const Task& task) {
    return ClothResult{.long_run = run(*task.stage, *task.entrant, task.mode, task.setting)};
  });
}

}  // namespace odeum::study
