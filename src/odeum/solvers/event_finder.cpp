// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/event_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odeum {
namespace {

/// The same time, but for the rounding of where a zero is.
bool happens_with(double a, double b) {
  return std::abs(a - b) <=
         64 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

}  // namespace

EventFinder::EventFinder(const Events& events, std::size_t states)
    : events_(events),
      y_(states),
      values_(events.senses.size()),
      searches_(events.senses.size()),
      senses_(events.senses.size(), 0) {}

void EventFinder::begin(const Found& happened, const EventCourse& course,
                        const std::vector<double>& before) {
  rests_known_ = false;
  const auto fired = [](const Found& found, std::size_t k) {
    return std::ranges::find(found.functions, k) != found.functions.end();
  };
  if (!before.empty()) events_.functions(happened.t, before.data(), values_.data());
  const auto residue = [&](std::size_t k) {
    return before.empty() || !(fired(happened, k) || senses_[k] != 0) ? 0
                                                                      : 2 * std::abs(values_[k]);
  };
  for (std::size_t k = events_.of_events; k < searches_.size(); ++k) {
    const int side = course.side(k);
    side == 0 ? searches_[k].begin(true, residue(k)) : searches_[k].begin_beside(side, residue(k));
  }
  for (std::size_t k = 0; k < events_.of_events; ++k) {
    if (fired(happened, k)) {
      searches_[k].begin(true, residue(k));
    } else if (happened && senses_[k] != 0) {
      // It is on the far side of a zero, or came back from there by another event at once.
      const bool is_back = happens_with(before_.t, happened.t) && fired(before_, k);
      searches_[k].begin_beside(is_back ? -senses_[k] : senses_[k], residue(k));
    } else {
      searches_[k].begin();
    }
  }
  before_ = happened;
}

std::vector<EventCourse::Crossing> EventFinder::crossings(const Found& found) const {
  std::vector<EventCourse::Crossing> all;
  for (const std::size_t k : found.functions) all.push_back({k, senses_[k]});
  return all;
}

double EventFinder::value(std::size_t function, double t, const StateAt& state) {
  if (!state(t, y_.data())) return std::numeric_limits<double>::quiet_NaN();
  events_.functions(t, y_.data(), values_.data());
  return values_[function];
}

void EventFinder::find_rests(double t, const StateAt& state) {
  rests_known_ = true;
  if (!state(t, y_.data())) return;
  // Roundings of the steps that follow add up.
  constexpr double roundings = 1024 * std::numeric_limits<double>::epsilon();
  std::vector<double> at(values_.size()), moved(values_.size(), 0);
  events_.functions(t, y_.data(), at.data());
  const auto add = [&](double when) {
    events_.functions(when, y_.data(), values_.data());
    for (std::size_t k = 0; k < at.size(); ++k) moved[k] += std::abs(values_[k] - at[k]);
  };
  add(t * (1 + roundings));
  for (double& each : y_) {
    const double kept = each;
    each *= 1 + roundings;
    if (each != kept) add(t);
    each = kept;
  }
  for (std::size_t k = 0; k < at.size(); ++k) {
    searches_[k].round_within(moved[k] / 16);
    if (std::abs(at[k]) <= moved[k]) searches_[k].rest_within(moved[k]);
  }
}

EventFinder::Found EventFinder::look(double a, double b, const StateAt& state) {
  struct Crossing {
    double t;
    std::size_t function;
    int sense;
  };
  if (!rests_known_) find_rests(a, state);
  std::vector<Crossing> all;
  Found first;
  first.t = std::numeric_limits<double>::infinity();
  // What a polynomial and its rounding move one time against another.
  const double at_once =
      16 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b)) +
      1e-12 * (b - a);
  for (std::size_t k = 0; k < searches_.size(); ++k) {
    const auto g = [&](double t) { return value(k, t, state); };
    searches_[k](g, a, g(a), b, g(b), [&](const Zero& zero) {
      const int wanted = events_.senses[k];
      all.push_back({zero.t, k, zero.sense});
      if (wanted != 0 && zero.sense != wanted) return zero.t > first.t + at_once;
      first.t = std::min(first.t, zero.t);
      return true;
    });
  }
  if (first.functions.empty() && !std::isfinite(first.t)) return first;
  if (!happens_with(first.t, before_.t)) std::ranges::fill(senses_, 0);
  for (const Crossing& one : all) {
    if (std::abs(one.t - first.t) > at_once) continue;
    const int wanted = events_.senses[one.function];
    senses_[one.function] = one.sense;
    if (wanted == 0 || one.sense == wanted) first.functions.push_back(one.function);
  }
  return first;
}

bool StepPolynomial::operator()(double t, double* y) const {
  const double share = (t - a_) / (b_ - a_);
  double sum = 0;
  std::fill_n(y, n_, 0.0);
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const double apart = share - detail::zero_nodes[k];
    if (apart == 0) {
      std::copy_n(states_[k], n_, y);
      return true;
    }
    // The weights of the second barycentric form at these nodes.
    const double weight =
        (k == 0 || k + 1 == states_.size() ? 0.5 : 1) * (k % 2 == 0 ? 1 : -1) / apart;
    sum += weight;
    for (std::size_t i = 0; i < n_; ++i) y[i] += weight * states_[k][i];
  }
  for (std::size_t i = 0; i < n_; ++i) y[i] /= sum;
  return true;
}

}  // namespace odeum
