// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/kind.hpp"

#include "odeum/cases/foreign_case.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::cases {
namespace {

ReadProblem read_fmu(const Named& named, const Given& given) {
  foreign::ProblemCallbacks model = open_fmu(named.word(), given.set, given.inputs);
  model.id = given.id;
  std::string content = model.content;
  return {{foreign_statement(std::move(model))}, std::move(content)};
}

}  // namespace

Kind fmu_kind() {
  return {.name = "problem",
          .suffix = "_fmu",
          .recognises = [](const Named& named) { return named.word().ends_with(".fmu"); },
          .read = read_fmu,
          .has_inputs = true};
}

}  // namespace odeum::cases
