// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/evolution/field.hpp"

#include <cmath>

#include "odeum/cases/element_case.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::study {

Field::Field(bool wave, std::size_t divisions, fem::Mass mass, bool with_modes,
             const std::function<double(fem::Point)>& start) {
  auto system = std::make_shared<fem::SemiDiscrete>(fem::semi_discrete(
      fem::unit_square(divisions), {.load = [](fem::Point) { return 0.; }}, mass, with_modes));
  system->multiplications = std::make_shared<double>(0);
  for (const fem::Point p : system->nodes) case_.y0.push_back(start(p));
  if (wave) case_.y0.resize(2 * case_.y0.size());
  system_ = system;
  if (wave)
    cases::set_wave_stage(case_, system_);
  else
    cases::set_heat_stage(case_, system_);
}

std::vector<double> Field::after(const std::string& solver, double end, std::size_t steps,
                                 std::string* detail) const {
  Request request;
  request.steps = steps, request.stops = {end};
  *system_->multiplications = 0;
  Outcome outcome = find_solver(case_.entrants, solver).solve(request);
  if (outcome.status == Status::ok) return std::move(outcome.states);
  if (detail) *detail = outcome.detail;
  return {};
}

double Field::norm(const std::vector<double>& u) const {
  double sum = 0;
  for (std::size_t i = 0; i < system_->size(); ++i) sum += system_->mass.value[i] * u[i] * u[i];
  return std::sqrt(sum);
}

}  // namespace odeum::study
