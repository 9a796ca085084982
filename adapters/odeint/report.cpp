// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/util/odeint_error.hpp>

#include "odeint/tripped.hpp"

namespace odeum::adapters::odeint {

double smallest_step(double t, double stop) {
  return 16 * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), std::abs(stop));
}

bool step_is_large_enough(double h, double t, Outcome& outcome) {
  if (h > smallest_step(t, t)) return true;  // a NaN is not
  outcome.status = Status::step_too_small;
  outcome.detail = fmt::format("step {} at t = {} is at the rounding of t", h, t);
  return false;
}

void explain_exception(Outcome& outcome) {
  try {
    throw;
  } catch (const Tripped&) {
    // The guard has the reason.
  } catch (const boost::numeric::odeint::step_adjustment_error& error) {
    outcome.status = Status::step_too_small;
    outcome.detail = fmt::format("step_adjustment_error: {}", error.what());
  } catch (const std::exception& error) {
    outcome.status = Status::refused;
    outcome.detail = fmt::format("odeint threw: {}", error.what());
  }
}

Outcome refuse_adaptive() { return refused("runs at a fixed step only"); }
Outcome refuse_by_component() {
  return refused("tolerances by component are not compiled for an inlined problem");
}
Outcome refuse_fixed() { return refused("chooses its own steps: runs to a tolerance only"); }

}  // namespace odeum::adapters::odeint
