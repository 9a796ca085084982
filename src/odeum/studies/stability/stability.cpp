// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/core/glob.hpp"
#include "odeum/judge/stability_search.hpp"
#include "odeum/studies/stability/growth_meter.hpp"
#include "odeum/studies/stability/region_map.hpp"

namespace odeum::study {
namespace {

/// The frame of a region.
struct Window {
  double first_low = 0, first_high = 0, second_low = 0, second_high = 0;
};

/// A measurement: a limit along an axis or a region of a plane.
struct Question {
  const char* name;    ///< the axis or the plane, as in the files
  const char* option;  ///< the value of --plane that asks for it
  const char* probe;   ///< the plane of the probe
  bool region, oscillator;
  judge::PlaneState direction{};  ///< of an axis: its direction from zero
  Window window{};                ///< of a region
};

// The window on z contains the regions of explicit methods up to order 8 and the unstable regions
// of BDF.
constexpr Question questions[] = {
    {.name = "real",
     .option = "lambda",
     .probe = "lambda",
     .region = false,
     .oscillator = false,
     .direction = {-1, 0}},
    {.name = "imaginary",
     .option = "lambda",
     .probe = "lambda",
     .region = false,
     .oscillator = false,
     .direction = {0, 1}},
    {.name = "oscillator",
     .option = "oscillator",
     .probe = "undamped",
     .region = false,
     .oscillator = true,
     .direction = {1, 0}},
    {.name = "lambda",
     .option = "lambda",
     .probe = "lambda",
     .region = true,
     .oscillator = false,
     .window = {-8, 4, -6, 6}},
    {.name = "oscillator",
     .option = "oscillator",
     .probe = "oscillator",
     .region = true,
     .oscillator = true,
     .window = {0, 4, 0, 2}},
};

/// A unit of work, whose result is kept.
struct Task {
  const Question* question;
  const Case* c;
  SolverInfo info;
  std::size_t index;  ///< of the entrant in the probe
  std::string unfit;  ///< why nothing can be measured; empty: it can
};

judge::PlaneState point_at(const Question& axis, double x) {
  return {axis.direction[0] * x, axis.direction[1] * x};
}

/// Growth by the method's own stability function, along the axis of a question.
std::function<judge::Growth(double)> theory_of(const Task& task) {
  const bool known = task.question->oscillator ? bool(task.info.oscillator_amplification)
                                               : bool(task.info.amplification);
  if (!known) return {};
  return [&task](double x) {
    const auto [first, second] = point_at(*task.question, x);
    const double amplification = task.question->oscillator
                                     ? task.info.oscillator_amplification(first)
                                     : task.info.amplification(first, second);
    return judge::Growth{std::log(amplification), judge::growth_rounding};
  };
}

/// A point where one of two limits is exceeded and the other is not.
double between(double limit, double other) {
  const double low = std::min(limit, other), high = std::max(limit, other);
  if (std::isinf(high)) return 2 * low;
  return low > 0 ? std::sqrt(low * high) : high / 2;
}

void find_limit_of(const Task& task, StabilityLimit& row) {
  const Probe probe = task.c->probe();
  GrowthMeter meter(probe, probe.entrants[task.index], task.question->oscillator, limit_length);
  std::string failure, failure_detail;
  const judge::LimitFound found = judge::find_limit([&](double x) {
    if (interrupted) throw Interrupted();
    const auto [first, second] = point_at(*task.question, x);
    const judge::Growth growth = meter.measure(first, second);
    if (growth.failed()) {
      failure = to_string(meter.status());
      failure_detail = meter.failure();
    }
    return growth;
  });
  row.limit = found.limit;
  row.status = std::isnan(row.limit) ? failure : to_string(Status::ok);
  row.detail = found.how;
  if (!failure.empty() && found.fails) row.detail += ": " + failure_detail;
  const auto theory = theory_of(task);
  if (!theory) return;
  row.theory = judge::find_limit(theory).limit;
  row.difference = row.limit == row.theory ? 0 : std::abs(row.limit - row.theory);
  if (row.difference > limit_tolerance * std::max(1.0, std::min(row.limit, row.theory))) {
    row.status = "differs";
    const double x = between(row.limit, row.theory);
    const auto [first, second] = point_at(*task.question, x);
    const judge::Growth measured = meter.measure(first, second);
    if (!row.detail.empty()) row.detail += "; ";
    row.detail += fmt::format(
        "at {:.4g}, between the two limits, a step grows by {:.1e} as measured (known to {:.1e}) "
        "and by {:.1e} in theory",
        x, std::expm1(measured.log_per_step), measured.noise, std::expm1(theory(x).log_per_step));
  }
}

void map_region_of(const Task& task, const Options& options, StabilityRegion& region) {
  const Question& question = *task.question;
  const bool own = task.info.library == "odeum";
  const LaneRunner runner =
      own && !question.oscillator ? find_lane_runner(task.info.method) : nullptr;
  const double points = options.number("grid", runner ? 257 : own ? 129 : 65);
  region.columns = static_cast<int>(own ? points : options.number("peer-grid", points));
  // The window on the oscillator is twice as wide as high: square cells there too.
  region.rows = question.oscillator ? region.columns / 2 + 1 : region.columns;
  region.first_low = question.window.first_low;
  region.first_high = question.window.first_high;
  region.second_low = question.window.second_low;
  region.second_high = question.window.second_high;
  if (runner) {
    map_region_in_lanes(runner, region);
  } else {
    const Probe probe = task.c->probe();
    GrowthMeter meter(probe, probe.entrants[task.index], question.oscillator, region_length);
    map_region(meter, !question.oscillator, region);
  }
}

StabilityResult answer(const Task& task, const Options& options) {
  StabilityResult result;
  if (task.question->region) {
    auto region = named_row<StabilityRegion>(task.info);
    region.plane = task.question->name;
    if (task.unfit.empty())
      map_region_of(task, options, region);
    else
      region = not_applicable(region, task.unfit);
    result.regions.push_back(std::move(region));
  } else {
    auto limit = named_row<StabilityLimit>(task.info);
    limit.axis = task.question->name;
    if (task.unfit.empty())
      find_limit_of(task, limit);
    else
      limit = not_applicable(limit, task.unfit);
    result.limits.push_back(std::move(limit));
  }
  return result;
}

std::string key_of(const Task& task) {
  return fmt::format("{} {} {}", task.question->region ? "region" : "limit", task.question->name,
                     task.info.id());
}

std::vector<Task> select_tasks(const Options& options) {
  const std::string plane = options.word("plane");
  std::vector<Task> tasks;
  for (const Question& question : questions) {
    if (!plane.empty() && plane != question.option) continue;
    for (const Case& c : all_cases()) {
      if (c.plane != question.probe) continue;
      const Probe probe = c.probe();
      for (std::size_t i = 0; i < probe.entrants.size(); ++i) {
        const Entrant& entrant = probe.entrants[i];
        if (!any_glob_matches(options.solvers, entrant.info.id())) continue;
        Task task{&question, &c, entrant.info, i, entrant.unfit};
        if (task.unfit.empty() && !entrant.info.fixed) task.unfit = "chooses its own steps only";
        tasks.push_back(std::move(task));
      }
    }
  }
  return tasks;
}

}  // namespace

StabilityResult measure_stability(const Options& options, const Runner& runner) {
  if (!options.cases.empty()) return measure_steps(options, runner);
  const std::vector<Task> tasks = select_tasks(options);
  return runner.run(
      "stability", tasks, [](const Task& task) { return key_of(task); },
      [&](const Task& task) { return answer(task, options); });
}

}  // namespace odeum::study
