// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/text_happenings.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "odeum/formula/event_course.hpp"

namespace odeum::truth {

/// Numbers of few binary digits are exact.
Real moved(Real c) {
  constexpr Real few = 0x1p24L;
  const bool exact = c == 0 || std::ldexp(few, std::ilogb(c)) == 0 ||
                     std::remainder(c, std::ldexp(1 / few, std::ilogb(c))) == 0;
  return exact ? c : c * (1 + moved_by);
}

void add_happenings(const formula::Problem& problem, System& system) {
  if (problem.events.empty()) return;
  using Rules = formula::EventRules<Real>;
  auto all = std::make_shared<Happenings>();
  for (const formula::Watched& watched : problem.watched) {
    all->senses.push_back(watched.sense);
    all->of_events += watched.event != formula::no_event ? 1 : 0;
  }
  const auto rules = std::make_shared<const Rules>(problem),
             moved_rules = std::make_shared<const Rules>(problem, moved);
  all->values = [rules, moved_rules](Real t, const Real* y, Real* values, bool is_moved) {
    (is_moved ? moved_rules : rules)->functions(t, y, values);
  };
  all->course = [rules, moved_rules](bool is_moved) {
    return std::make_unique<formula::EventCourse<Real>>(is_moved ? moved_rules : rules, false);
  };
  system.events = std::move(all);
}

}  // namespace odeum::truth
