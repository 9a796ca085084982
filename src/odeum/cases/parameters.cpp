// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace odeum::cases {

Case with_parameters(std::vector<Parameter> parameters,
                     const std::function<Case(const Values&)>& make) {
  Values values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.value);
  Case c = make(values);
  c.with_values = [parameters, make](const Values& others, const TruthBounds&) {
    Case other = make(others);
    other.parameters = parameters;
    for (std::size_t i = 0; i < others.size(); ++i) other.parameters[i].value = others[i];
    return other;
  };
  c.parameters = std::move(parameters);
  return c;
}

Case with_tabled_parameters(std::vector<Parameter> parameters,
                            const std::function<Case(const Values&)>& make) {
  return with_parameters(parameters, [=](const Values& values) {
    Case c = make(values);
    bool usual = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
      c.equation += fmt::format("{} {} = {}", i ? "," : ";", parameters[i].name, values[i]);
      usual = usual && values[i] == parameters[i].value;
    }
    if (!usual) c.truth = unknown_truth();
    return c;
  });
}

void require_positive(const std::string& name, double value) {
  if (!(value > 0))
    throw std::invalid_argument(fmt::format("{}: got {}, expected a positive number", name, value));
}

void require_not_negative(const std::string& name, double value) {
  if (!(value >= 0))
    throw std::invalid_argument(
        fmt::format("{}: got {}, expected a number that is not negative", name, value));
}

Truth unknown_truth(std::string why) {
  Truth truth;
  truth.at = [](double, double*) { return false; };
  truth.source = std::move(why);
  return truth;
}

}  // namespace odeum::cases
