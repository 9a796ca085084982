// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "odeum/core/glob.hpp"
#include "odeum/judge/stability_search.hpp"
#include "odeum/measure/growth_meter.hpp"
#include "odeum/studies/stability/raster_lanes.hpp"

namespace odeum::study {
namespace {

/// A measurement: a limit along an axis or a region of a plane.
struct Question {
  const char* name;             ///< the axis or the plane, as in the files
  const char* probe;            ///< the plane of the probe
  judge::PlaneState direction;  ///< of an axis: its direction from zero; a region has none
  std::tuple<double, double, double, double> window{};  ///< of a region: first_low to second_high

  bool oscillator() const { return probe != std::string_view("lambda"); }
  bool region() const { return direction == judge::PlaneState{}; }
};

// The window on z contains the regions of explicit methods up to order 8 and the unstable regions
// of BDF.
constexpr Question questions[] = {
    {"real", "lambda", {-1, 0}},
    {"imaginary", "lambda", {0, 1}},
    {"oscillator", "undamped", {1, 0}},
    {"lambda", "lambda", {}, {-8, 4, -6, 6}},
    {"oscillator", "oscillator", {}, {0, 4, 0, 2}},
};

/// A unit of work, whose result is kept.
struct Task {
  const Question* question;
  const Case* c;
  SolverInfo info;
  std::string unfit;  ///< why nothing can be measured; empty: it can
};

judge::PlaneState point_at(const Question& axis, double x) {
  return {axis.direction[0] * x, axis.direction[1] * x};
}

/// Growth by the method's own stability function, along the axis of a question.
std::function<judge::Growth(double)> theory_of(const Task& task) {
  const bool oscillator = task.question->oscillator();
  if (!(oscillator ? bool(task.info.oscillator_amplification) : bool(task.info.amplification)))
    return {};
  return [&task, oscillator](double x) {
    const auto [first, second] = point_at(*task.question, x);
    const double amplification = oscillator ? task.info.oscillator_amplification(first)
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

StabilityLimit limit_of(const Task& task) {
  auto row = named_row<StabilityLimit>(task.info);
  row.axis = task.question->name;
  if (!task.unfit.empty()) return not_applicable(row, task.unfit);
  const Probe probe = task.c->probe();
  measure::GrowthMeter meter(probe, find_solver(probe.entrants, task.info.id()),
                             task.question->oscillator(), measure::limit_length);
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
  if (!theory) return row;
  row.theory = judge::find_limit(theory).limit;
  row.difference = row.limit == row.theory ? 0 : std::abs(row.limit - row.theory);
  if (row.difference > limit_tolerance * std::max(1.0, std::min(row.limit, row.theory))) {
    row.status = "differs";
    const double x = between(row.limit, row.theory);
    const auto [first, second] = point_at(*task.question, x);
    const judge::Growth measured = meter.measure(first, second);
    remark(row, fmt::format("at {:.4g}, between the two limits, a step grows by {:.1e} as measured "
                            "(known to {:.1e}) and by {:.1e} in theory",
                            x, std::expm1(measured.log_per_step), measured.noise,
                            std::expm1(theory(x).log_per_step)));
  }
  return row;
}

/// The coordinate of a grid point, exact at both edges and in the middle of an odd grid.
double coordinate(double low, double high, int i, int count) {
  const double fraction = static_cast<double>(i) / (count - 1);
  return low * (1 - fraction) + high * fraction;
}

/// Calls fill(second, row) for each row to be solved; returns their number.
template <class Fill>
int fill_rows(StabilityRegion& region, bool mirrored, Fill&& fill) {
  const auto columns = static_cast<std::size_t>(region.columns);
  region.growth.resize(columns * static_cast<std::size_t>(region.rows));
  const auto row = [&](int j) {
    return region.growth.data() + static_cast<std::size_t>(j) * columns;
  };
  const int first = mirrored ? region.rows / 2 : 0;
  for (int j = first; j < region.rows; ++j) {
    if (interrupted) throw Interrupted();
    fill(coordinate(region.second_low, region.second_high, j, region.rows), row(j));
    const int mirror = region.rows - 1 - j;
    if (mirrored && mirror != j) std::copy_n(row(j), columns, row(mirror));
  }
  return region.rows - first;
}

/// Point by point; `mirrored`: solves the rows of the upper half and copies them to the lower one.
void map_region(measure::GrowthMeter& meter, bool mirrored, StabilityRegion& region) {
  int failures = 0;
  std::string status, detail;  // of the first failure
  const int rows = fill_rows(region, mirrored, [&](double second, float* row) {
    for (int i = 0; i < region.columns; ++i) {
      const double first = coordinate(region.first_low, region.first_high, i, region.columns);
      const judge::Growth growth = meter.measure(first, second);
      row[i] = static_cast<float>(std::exp(growth.log_per_step));
      if (growth.failed() && failures++ == 0) {
        status = to_string(meter.status());
        detail = meter.failure();
      }
    }
  });
  const int points = rows * region.columns;
  region.status = failures == points ? status : to_string(Status::ok);
  if (failures > 0)
    region.detail =
        fmt::format("no result at {} of {} points; the first: {}", failures, points, detail);
}

/// An own explicit Runge-Kutta method on the lambda plane, the points of a row together; mirrored.
void map_region_in_lanes(LaneRunner runner, StabilityRegion& region) {
  constexpr unsigned steps = 16;  // all equal: a one-step method multiplies y by R(z)
  const auto count = static_cast<std::size_t>(region.columns);
  std::vector<double> re(count), im(count), squared(count);
  for (std::size_t i = 0; i < count; ++i)
    re[i] = coordinate(region.first_low, region.first_high, static_cast<int>(i), region.columns);
  fill_rows(region, true, [&](double second, float* row) {
    std::ranges::fill(im, second);
    runner(re.data(), im.data(), count, steps, squared.data());
    for (std::size_t i = 0; i < count; ++i)
      row[i] = static_cast<float>(std::pow(squared[i], 1.0 / (2 * steps)));
  });
  region.status = to_string(Status::ok);
}

StabilityRegion region_of(const Task& task, const Options& options) {
  const Question& question = *task.question;
  auto region = named_row<StabilityRegion>(task.info);
  region.plane = question.name;
  if (!task.unfit.empty()) return not_applicable(region, task.unfit);
  const bool own = task.info.library == "odeum";
  const LaneRunner runner =
      own && !question.oscillator() ? find_lane_runner(task.info.method) : nullptr;
  const double points = options.number("grid", runner ? 257 : own ? 129 : 65);
  region.columns = static_cast<int>(own ? points : options.number("peer-grid", points));
  // The window on the oscillator is twice as wide as high: square cells there too.
  region.rows = question.oscillator() ? region.columns / 2 + 1 : region.columns;
  std::tie(region.first_low, region.first_high, region.second_low, region.second_high) =
      question.window;
  if (runner) {
    map_region_in_lanes(runner, region);
  } else {
    const Probe probe = task.c->probe();
    measure::GrowthMeter meter(probe, find_solver(probe.entrants, task.info.id()),
                               question.oscillator(), measure::region_length);
    map_region(meter, !question.oscillator(), region);
  }
  return region;
}

std::vector<Task> select_tasks(const Options& options) {
  const std::string plane = options.word("plane");
  std::vector<Task> tasks;
  for (const Question& question : questions) {
    if (!plane.empty() && (plane == "oscillator") != question.oscillator()) continue;
    const Case& c = measure::case_with_plane(question.probe);
    const Probe probe = c.probe();
    for (const Entrant& entrant : probe.entrants) {
      if (!any_glob_matches(options.solvers, entrant.info.id())) continue;
      Task task{&question, &c, entrant.info, entrant.unfit};
      if (task.unfit.empty() && !entrant.info.fixed) task.unfit = "chooses its own steps only";
      tasks.push_back(std::move(task));
    }
  }
  return tasks;
}

}  // namespace

StabilityResult measure_stability(const Options& options, const Runner& runner) {
  if (!options.cases.empty()) return measure_steps(options, runner);
  const std::vector<Task> tasks = select_tasks(options);
  const auto key = [](const Task& task) {
    return fmt::format("{} {} {}", task.question->region() ? "region" : "limit",
                       task.question->name, task.info.id());
  };
  return runner.run("stability", tasks, key, [&](const Task& task) {
    return task.question->region() ? StabilityResult{.regions = {region_of(task, options)}}
                                   : StabilityResult{.limits = {limit_of(task)}};
  });
}

}  // namespace odeum::study
