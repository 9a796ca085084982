// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/runner.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "odeum/judge/errors.hpp"
#include "odeum/solvers/own_methods.hpp"

namespace odeum::sweep {
namespace {

/// Some members from the first to the last, on which a family is checked.
std::vector<std::vector<double>> samples_of(const Plan& plan) {
  constexpr std::uint64_t most = 8;
  const std::uint64_t count = std::min(plan.members.size(), most);
  std::vector<std::vector<double>> samples;
  for (std::uint64_t k = 0; k < count; ++k)
    samples.push_back(parameters_of(plan, spread(plan, k, count)));
  return samples;
}

/// Why values make no problem, as `work` on them finds; none where they make one.
template <class Work>
std::optional<std::string> fault_in(const Work& work) {
  try {
    work();
    return std::nullopt;
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

Runner::Runner(const Plan& plan, std::optional<Family> family)
    : plan_(plan), family_(std::move(family)) {
  if (!family_) return;
  energy_ = family_->energy;
  y0_ = family_->y0;
  use_lanes();
}

void Runner::use_lanes() {
  constexpr std::string_view own = "odeum/";
  const std::string_view solver = plan_.solver;
  const auto* const text = plan_.base->family.target<cases::TextFamilies>();
  if (!text || !solver.starts_with(own) || plan_.request.stops.size() != 1) return;
  // What is asked over the time needs each member's start.
  if (std::ranges::any_of(plan_.quantities, &Quantity::over_time)) return;
  // Members that step together do not end their steps at the switches of each.
  if (plan_.request.mode == Mode::adaptive && plan_.base->problem.switches) return;
  // What the solver does not fit at all is told by member.
  const Entrant* const entrant = family_->entrants.find(plan_.solver);
  const Solver* const method = find_own_solver(solver.substr(own.size()));
  if (!entrant || !entrant->solve || !method || !method->lanes) return;
  lanes_ = text->in_lanes();
  lane_run_ = method->lanes(plan_.request.mode, lanes_->problem);
}

std::vector<Outcome> Runner::run_in_lanes(std::uint64_t first, std::uint64_t last) {
  if (!lane_run_ || plan_.study) return {};
  const auto place = [&](std::size_t member) {
    bool placed = false;  // where it cannot be, the run alone tells why
    fault_in([&] { placed = lanes_->place(parameters_of(plan_, first + member)); });
    return placed;
  };
  return lane_run_({lanes_->problem, static_cast<std::size_t>(last - first), place}, plan_.request);
}

Outcome Runner::run(const std::vector<double>& values, const Request& request) {
  Outcome outcome;
  const std::optional<std::string> fault = fault_in([&] {
    if (family_) {
      family_->place(values);
    } else {
      case_ = plan_.base->with_values(values, {});
      energy_ = case_.energy;
      y0_ = std::make_shared<const std::vector<double>>(case_.y0);
    }
    outcome = fitting(family_ ? family_->entrants : case_.entrants, plan_.solver).solve(request);
  });
  if (fault) outcome.status = Status::refused, outcome.detail = *fault;
  return outcome;
}

MemberRow Runner::measure(const std::vector<double>& values) const {
  MemberRow row{.solver = plan_.solver, .status = to_string(Status::refused)};
  row.answer = row.status;
  const std::optional<std::string> fault = fault_in([&] {
    Case member = plan_.base->with_values(values, {});
    row = plan_.study->measure(member);
  });
  if (fault) row.detail = *fault;
  return row;
}

double Runner::value(const Quantity& quantity, const std::vector<double>& values,
                     const Outcome& outcome) {
  const std::size_t n = y0_->size(), count = outcome.states.size() / n;
  const double* const last = outcome.states.data() + (count - 1) * n;
  if (quantity.kind == Quantity::Kind::error || quantity.kind == Quantity::Kind::error_of)
    return error(quantity, values, last);
  const std::vector<double>& stops = plan_.request.stops;
  if (!quantity.over_time()) return value_at(quantity, values, stops.back(), last);
  double value = value_at(quantity, values, plan_.base->t0, y0_->data());
  for (std::size_t k = 0; k < count; ++k) {
    const double each = value_at(quantity, values, stops[k], outcome.states.data() + k * n);
    value =
        quantity.kind == Quantity::Kind::greatest ? std::max(value, each) : std::min(value, each);
  }
  return value;
}

double Runner::value_at(const Quantity& quantity, const std::vector<double>& values, double t,
                        const double* y) {
  if (quantity.kind == Quantity::Kind::energy) return energy_(y);
  if (!quantity.is_output) return y[quantity.component];
  const auto* const text = plan_.base->family.target<cases::TextFamilies>();
  if (text && !outputs_) outputs_ = text->outputs();
  std::vector<double> all(plan_.base->outputs.names.size());
  if (outputs_)
    outputs_(values, t, y, all.data());
  else
    case_.outputs.at(t, y, all.data());
  return all[quantity.component];
}

double Runner::error(const Quantity& quantity, const std::vector<double>& values,
                     const double* last) {
  const Case& base = *plan_.base;
  if (const auto* const text = base.family.target<cases::TextFamilies>(); text && !exact_) {
    exact_ = text->exact();
    judged_.y0 = base.y0;
    judged_.measured = base.measured;
    judged_.units = base.units;
  }
  if (exact_) judged_.truth.at = [&](double t, double* y) { return exact_(values, t, y); };
  const Case& judged = exact_ ? judged_ : case_;
  const double end = plan_.request.stops.back();
  if (quantity.kind == Quantity::Kind::error) return judge::error_at(judged, end, last);
  std::vector<double> exact(y0_->size());
  if (!judged.truth.at(end, exact.data())) return nan;
  return std::abs(value_at(quantity, values, end, last) -
                  value_at(quantity, values, end, exact.data()));
}

Runners::Runners(const Plan& plan) : plan_(plan) {
  if (!plan.base->family || plan.study) return;
  std::optional<Family> family;
  // Values that make no problem are told by member.
  fault_in([&] { family = plan.base->family(samples_of(plan)); });
  in_place_ = family.has_value();
  if (in_place_) free_.push_back(std::make_unique<Runner>(plan, std::move(family)));
}

std::shared_ptr<Runner> Runners::lend() {
  std::unique_lock lock(mutex_);
  std::unique_ptr<Runner> runner;
  if (!free_.empty()) {
    runner = std::move(free_.back());
    free_.pop_back();
  }
  lock.unlock();
  if (!runner)
    runner = std::make_unique<Runner>(plan_, in_place_ ? plan_.base->family({}) : std::nullopt);
  return {runner.release(), [this](Runner* used) {
            const std::lock_guard taken(mutex_);
            free_.emplace_back(used);
          }};
}

}  // namespace odeum::sweep
