// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "odeum/linear/eigenvalues.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::study {

std::vector<std::complex<double>> spectrum(const OdeView& view, double t, const double* y) {
  if (!view.jacobian) throw std::invalid_argument("spectrum: the problem offers no Jacobian");
  std::vector<double> jacobian(view.dimension * view.dimension);
  view.jacobian(view.problem, t, y, jacobian.data());
  return eigenvalues(jacobian, view.dimension);
}

SpectrumAlong spectrum_along(const Case& c, double time) {
  SpectrumAlong along;
  if (c.y0.size() > dense_dimension_limit) {
    along.reason =
        fmt::format("{} unknowns: no dense spectrum beyond {}", c.y0.size(), dense_dimension_limit);
    return along;
  }
  if (!c.problem.view.jacobian) {
    along.reason = "the case offers no Jacobian";
    return along;
  }
  constexpr int points = 32;
  Request request;
  request.mode = Mode::adaptive;
  set_tolerance(request, c, 1e-8);
  for (int k = 1; k <= points; ++k) request.stops.push_back(c.t0 + time * k / points);
  const Outcome outcome = find_solver(c.entrants, "odeum/radau_iia5").solve(request);
  if (outcome.status != Status::ok) {
    along.reason = "the solution could not be computed: " + outcome.detail;
    return along;
  }
  const std::size_t n = c.y0.size();
  along.sizes.assign(n, 0);
  const auto visit = [&](double t, const double* y) {
    for (std::size_t i = 0; i < n; ++i) along.sizes[i] = std::max(along.sizes[i], std::abs(y[i]));
    for (const std::complex<double>& z : spectrum(c.problem.view, t, y)) {
      if (std::abs(z) > std::abs(along.largest)) along.largest = z;
      // Rounding may put an imaginary one to the right.
      if (z.imag() >= 0 && z.real() <= 1e-9 * std::abs(z)) along.eigenvalues.push_back(z);
    }
  };
  visit(c.t0, c.y0.data());
  for (int k = 0; k < points; ++k)
    visit(request.stops[static_cast<std::size_t>(k)],
          outcome.states.data() + static_cast<std::size_t>(k) * n);
  return along;
}

}  // namespace odeum::study
