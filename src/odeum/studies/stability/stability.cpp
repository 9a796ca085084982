// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/stability/stability.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "odeum/core/glob.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/judge/stability_search.hpp"
#include "odeum/record/fields.hpp"
#include "odeum/studies/stability/growth_meter.hpp"
#include "odeum/studies/stability/region_map.hpp"

namespace odeum::study {
namespace {

/// The frame of a region.
struct Window {
  double first_low = 0, first_high = 0, second_low = 0, second_high = 0;
};

/// A thing to find out about a solver: a limit along an axis or a region of a plane.
struct Question {
  const char* name;    ///< the axis or the plane, as the files name it
  const char* option;  ///< the value of --plane that asks for it
  const char* probe;   ///< the plane of the probe
  bool region, oscillator;
  judge::PlaneState direction{};  ///< of an axis: where it leads from zero
  Window window{};                ///< of a region
};

// The window on z holds the regions of explicit methods up to order 8 and the unstable ones of
// backward differences.
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

/// The unit of work, and of the journal.
struct Task {
  const Question* question;
  const Case* c;
  SolverInfo info;
  std::size_t index;  ///< of the entrant in the probe
  std::string unfit;  ///< why there is nothing to measure; empty: there is
};

struct TaskResult {
  std::optional<StabilityLimit> limit;
  std::optional<StabilityRegion> region;
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

StabilityLimit find_limit_of(const Task& task) {
  const Probe probe = task.c->probe();
  GrowthMeter meter(probe, probe.entrants[task.index], task.question->oscillator, limit_watch);
  StabilityLimit row;
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
  if (theory) row.theory = judge::find_limit(theory).limit;
  row.difference = row.limit == row.theory ? 0 : std::abs(row.limit - row.theory);
  return row;
}

StabilityRegion map_region_of(const Task& task, int own_grid, int peer_grid) {
  const Question& question = *task.question;
  const bool own = task.info.library == "odeum";
  const LaneRunner runner =
      own && !question.oscillator ? find_lane_runner(task.info.method) : nullptr;
  const int wanted = own ? own_grid : peer_grid;
  StabilityRegion region;
  region.columns = wanted > 1 ? wanted : runner ? 257 : own ? 129 : 65;
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
    GrowthMeter meter(probe, probe.entrants[task.index], question.oscillator, region_watch);
    map_region(meter, !question.oscillator, region);
  }
  return region;
}

template <class Row>
Row not_applicable(const Task& task, Row row) {
  row.status = "not_applicable";
  row.detail = task.unfit;
  return row;
}

TaskResult answer(const Task& task, const StabilityOptions& options) {
  TaskResult result;
  if (task.question->region)
    result.region = task.unfit.empty() ? map_region_of(task, options.own_grid, options.peer_grid)
                                       : not_applicable(task, StabilityRegion{});
  else
    result.limit =
        task.unfit.empty() ? find_limit_of(task) : not_applicable(task, StabilityLimit{});
  return result;
}

// The journal's form of a result.
template <class Record, class Row>
void fields(Record& record, Row& row) {
  record.field(row.status);
  record.field(row.detail);
  if constexpr (requires { row.limit; }) {
    record.field(row.limit);
    record.field(row.theory);
    record.field(row.difference);
  } else {
    record.field(row.columns);
    record.field(row.rows);
    record.field(row.first_low);
    record.field(row.first_high);
    record.field(row.second_low);
    record.field(row.second_high);
  }
}

std::string write_record(const TaskResult& result) {
  record::RecordWriter record;
  if (result.limit) fields(record, *result.limit);
  if (result.region) {
    fields(record, *result.region);
    record.field(growth_text(*result.region));
  }
  return record.text();
}

TaskResult read_record(const std::string& text, const Task& task) {
  record::RecordReader record(text);
  TaskResult result;
  if (task.question->region) {
    std::string growth;
    fields(record, result.region.emplace());
    record.field(growth);
    result.region->growth = read_growth(growth, *result.region);
  } else {
    fields(record, result.limit.emplace());
  }
  return result;
}

// Who a row is of does not stand in the record: the task says it.
void sign(const Task& task, TaskResult& result) {
  if (result.limit) {
    result.limit->library = task.info.library;
    result.limit->solver = task.info.method;
    result.limit->axis = task.question->name;
  } else {
    result.region->library = task.info.library;
    result.region->solver = task.info.method;
    result.region->plane = task.question->name;
  }
}

std::vector<Task> select_tasks(const StabilityOptions& options) {
  std::vector<Task> tasks;
  for (const Question& question : questions) {
    if (!options.plane.empty() && options.plane != question.option) continue;
    for (const Case& c : all_cases()) {
      if (c.plane != question.probe) continue;
      const Probe probe = c.probe();
      for (std::size_t i = 0; i < probe.entrants.size(); ++i) {
        const Entrant& entrant = probe.entrants[i];
        if (!any_glob_matches(options.solvers, entrant.info.id())) continue;
        Task task{&question, &c, entrant.info, i, entrant.unfit};
        if (task.unfit.empty() && !entrant.info.fixed) task.unfit = "has no fixed step";
        tasks.push_back(std::move(task));
      }
    }
  }
  return tasks;
}

}  // namespace

StabilityResult measure_stability(const StabilityOptions& options, record::Journal* journal) {
  const std::vector<Task> tasks = select_tasks(options);
  std::vector<TaskResult> results(tasks.size());
  Progress progress("stability", static_cast<double>(tasks.size()));
  parallel_for(tasks.size(), options.jobs, [&](std::size_t i) {
    const Task& task = tasks[i];
    const std::string key = fmt::format("{} {} {}", task.question->region ? "region" : "limit",
                                        task.question->name, task.info.id());
    if (const auto held = journal ? journal->find(key) : std::nullopt) {
      results[i] = read_record(*held, task);
    } else {
      results[i] = answer(task, options);
      if (journal) journal->add(key, write_record(results[i]));
    }
    sign(task, results[i]);
    progress.advance();
  });
  StabilityResult all;
  for (TaskResult& result : results) {
    if (result.limit) all.limits.push_back(std::move(*result.limit));
    if (result.region) all.regions.push_back(std::move(*result.region));
  }
  return all;
}

}  // namespace odeum::study
