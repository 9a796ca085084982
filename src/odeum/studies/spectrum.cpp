// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/spectrum.hpp"

#include <algorithm>

#include "odeum/cases/spectrum.hpp"
#include "odeum/linear/dense_limit.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::study {

SpectrumAlong spectrum_along(const Case& c, double time) {
  SpectrumAlong along;
  const std::size_t n = c.y0.size();
  const bool small = n <= dense_dimension_limit;
  const std::string explicit_pair = "odeum/dormand_prince54";
  const int points = small ? 32 : 8;
  Request request;
  request.mode = Mode::adaptive;
  for (int k = 1; k <= points; ++k) request.stops.push_back(c.t0 + time * k / points);
  Outcome outcome = refused("no solver fits");
  std::vector<std::string> solvers{"odeum/radau_iia5"};
  if (!small) solvers.insert(c.nature.stiff ? solvers.end() : solvers.begin(), explicit_pair);
  for (const std::string& solver : solvers) {
    const Entrant& entrant = find_solver(c.entrants, solver);
    if (!entrant.solve || outcome.status == Status::ok) continue;
    set_tolerance(request, c, small ? 1e-8 : 1e-6);
    request.over_stops = solver == explicit_pair;
    request.budget = {};
    if (solver == explicit_pair) request.budget.evaluations = 2 * c.settings.evaluation_budget;
    outcome = entrant.solve(request);
  }
  if (outcome.status != Status::ok) {
    along.reason = "the solution could not be computed: " + outcome.detail;
    return along;
  }
  along.sizes.assign(n, 0);
  // What Arnoldi's method finds is on the imaginary axis to that alone.
  const double undamped = small ? 1e-9 : 1e-3;
  const auto visit = [&](double t, const double* y) {
    for (std::size_t i = 0; i < n; ++i) along.sizes[i] = std::max(along.sizes[i], std::abs(y[i]));
    for (std::complex<double> z : cases::outermost_eigenvalues(c, t, {y, y + n})) {
      if (std::abs(z) > std::abs(along.largest)) along.largest = z;
      // Rounding may put an imaginary one to the right.
      if (z.real() > undamped * std::abs(z)) {
        along.growing = std::max(along.growing, z.real());
        continue;
      }
      if (z.real() > 0) z.real(0);
      along.eigenvalues.push_back(z);
    }
  };
  visit(c.t0, c.y0.data());
  for (int k = 0; k < points; ++k)
    visit(request.stops[static_cast<std::size_t>(k)],
          outcome.states.data() + static_cast<std::size_t>(k) * n);
  return along;
}

}  // namespace odeum::study
