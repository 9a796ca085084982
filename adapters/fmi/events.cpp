// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/problem/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fmi/fmu.hpp"
#include "odeum/core/numbers.hpp"
#include "odeum/isolated/isolated_process.hpp"

namespace odeum::adapters::fmi {
namespace {

enum Kind : std::size_t { state_event, time_event, input_event, step_event };
constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_reached(double due, double t) {
  constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
  return due <= t ||
         (std::isfinite(due) && due - t <= roundings * std::max(std::abs(due), std::abs(t)));
}

/// The events of a run: the model itself knows what they do.
class Course final : public EventCourse {
 public:
  Course(Fmu& fmu, bool resumed) : fmu_(fmu), resumed_(resumed) {}

  std::string happen(double t, const std::vector<Crossing>& crossings, State& y,
                     const Ahead& /*ahead*/) override {
    done_.clear();
    if (!isolated::in_isolated_process()) return "an FMU with events runs in a process of its own";
    if (resumed_)
      return "an FMU has discrete states, which its state does not tell: its runs begin at the "
             "start";
    const isolated::KeptArithmetic kept;
    isolated::alive();
    try {
      model_ ? go_on(t, crossings, y) : begin(t, y);
    } catch (const LoadError& error) {
      return error.what();
    }
    return {};
  }
  const std::vector<Done>& done() const override { return done_; }
  bool has_stopped() const override { return info_.terminate; }
  double next() const override { return std::min(next_of_model(), next_of_inputs()); }
  int side(std::size_t function) const override {
    return function < sides_.size() ? sides_[function] : 0;  // none before the start
  }
  bool completes(double t, const double* y) override {
    const isolated::KeptArithmetic kept;
    try {
      asks_ = model_->completes(t, y);
    } catch (const LoadError&) {
      asks_ = true;  // the event at the end of the step tells of it
    }
    return asks_;
  }

 private:
  double next_of_model() const { return info_.has_next ? info_.next : infinity; }
  double next_of_inputs() const { return fmu_.inputs ? fmu_.inputs->next_jump(passed_) : infinity; }

  void begin(double t, State& y) {
    passed_ = t;
    model_ = &fmu_.restarted();
    info_ = model_->start;
    asks_ = model_->asks_at_start;
    asks_ ? go_on(t, {}, y) : take_sides(t, y);
  }

  void go_on(double t, const std::vector<Crossing>& crossings, State& y) {
    constexpr int most_at_once = 100;
    const bool crossed =
        std::ranges::any_of(crossings, [](const Crossing& c) { return c.side != 0; });
    for (int k = 0; k == 0 || is_reached(next(), t); ++k) {
      const double due = next_of_model(), jump = next_of_inputs();
      const bool jumps = is_reached(jump, t), is_due = is_reached(due, t);
      if (!(k == 0 && (crossed || asks_)) && !is_due && !jumps) break;
      if (k == most_at_once)
        throw LoadError(
            fmt::format("the model's time events do not go on from t = {:.9g}: each asks for the "
                        "next at the same time",
                        t));
      if (k == 0) cross_over(crossings, t, y);
      if (is_due) t = std::max(t, due);
      const Kind kind = k == 0 && crossed ? state_event
                        : is_due          ? time_event
                        : jumps           ? input_event
                                          : step_event;
      done_.push_back({kind, y, {}});
      info_ = model_->happen(t, y.data(), jumps ? jump : -infinity);
      done_.back().after = y;
      if (jumps) passed_ = jump;
      asks_ = false;
      if (info_.terminate) return;
    }
    take_sides(t, y);
  }

  /// The model sees for itself which of its indicators have changed their signs. Where rounding and
  /// the error of the step left one on the side from which it comes, the state goes on along its
  /// slope until none is.
  void cross_over(const std::vector<Crossing>& crossings, double& t, State& y) {
    const auto is_over = [&](double at, const State& there) {
      const std::vector<double> values = indicators_at(at, there);
      return std::ranges::all_of(crossings, [&](const Crossing& c) {
        return c.side == 0 || (values[c.function] > 0) == (c.side > 0);
      });
    };
    if (crossings.empty() || is_over(t, y)) return;
    State slope(y.size()), there(y.size());
    require(model_->rhs(t, y.data(), slope.data()), "the derivatives at an event");
    const auto is_over_after = [&](double way) {
      for (std::size_t i = 0; i < y.size(); ++i) there[i] = y[i] + way * slope[i];
      return is_over(t + way, there);
    };
    double way = std::numeric_limits<double>::epsilon() * std::max(std::abs(t), 1e-12 * span());
    while (!is_over_after(way))
      if ((way *= 2) > 1e-3 * span()) return;
    constexpr int halvings = 12;  // to a part of the error that made them necessary
    double below = way / 2;
    for (int k = 0; k < halvings; ++k) {
      const double middle = below + (way - below) / 2;
      (is_over_after(middle) ? way : below) = middle;
    }
    is_over_after(way);
    y = there;
    t += way;
  }
  std::vector<double> indicators_at(double t, const State& y) {
    std::vector<double> values(fmu_.indicators);
    if (!values.empty())
      require(model_->indicate(t, y.data(), values.data()), "the event indicators");
    return values;
  }
  double span() const { return fmu_.description.stop - fmu_.description.t0; }

  /// A domain is that of positive values, or that of the others: one that is zero and about to
  /// become positive leaves the latter.
  void take_sides(double t, const State& y) {
    sides_.clear();
    const std::vector<double> values = indicators_at(t, y);
    for (const double value : values) sides_.push_back(value > 0 ? 1 : -1);
    if (std::ranges::find(values, 0.0) == values.end()) return;
    State later = y, slope(y.size());
    require(model_->rhs(t, y.data(), slope.data()), "the derivatives at an event");
    const double way = 1e-9 * span();
    for (std::size_t i = 0; i < later.size(); ++i) later[i] += way * slope[i];
    const std::vector<double> next = indicators_at(t + way, later);
    for (std::size_t k = 0; k < next.size(); ++k)
      if (values[k] == 0 && next[k] == 0) sides_[k] = 0;
  }

  Fmu& fmu_;
  bool resumed_, asks_ = false;
  Model* model_ = nullptr;
  EventInfo info_;
  double passed_ = -infinity;  ///< the last jump of inputs
  std::vector<int> sides_;
  std::vector<Done> done_;
};

}  // namespace

std::shared_ptr<const Events> events_of(Fmu& fmu) {
  if (!fmu.has_events) return nullptr;
  auto events = std::make_shared<Events>();
  events->names = {"state event", "time event", "input changes", "event of a step"};
  events->stops.assign(events->names.size(), false);
  events->senses.assign(fmu.indicators, 0);
  events->remembers = events->isolated = events->modal = true;
  events->steps = fmu.has_states && fmu.description.completes_steps;
  events->functions = [&fmu](double t, const double* y, double* values) {
    const isolated::KeptArithmetic kept;
    if (!isolated::in_isolated_process() || fmu.model().indicate(t, y, values) != 0)
      std::fill_n(values, fmu.indicators, nan);
  };
  events->course = [&fmu](bool resumed) { return std::make_unique<Course>(fmu, resumed); };
  if (!fmu.has_states)
    events->observe = [&fmu](double t, double* y) {
      const isolated::KeptArithmetic kept;
      try {
        if (fmu.model().observe(t, y) == 0) return;
      } catch (const LoadError&) {
      }
      std::fill_n(y, fmu.y0.size(), nan);
    };
  return events;
}

}  // namespace odeum::adapters::fmi
