// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/kind.hpp"

#include "odeum/cases/kinds/sbml/sbml.hpp"

namespace odeum::cases {
namespace {

bool is_sbml(const Named& named) {
  return named.word().ends_with(".xml") || named.word().ends_with(".sbml");
}

ReadProblem read_sbml(const Named& named, const Given& given) {
  const std::string& xml = named.text("model", most_model_bytes);
  SbmlText model;
  ReadProblem problem = translated(named, given, [&](double end) {
    model = text_of_sbml(named.word(), xml, end);
    return model.text;
  });
  problem.warnings = std::move(model.warnings);
  return problem;
}

}  // namespace

Kind sbml_kind() { return {"problem", "_sbml", false, is_sbml, read_sbml}; }

}  // namespace odeum::cases
