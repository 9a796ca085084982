// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <string>
#include <vector>

#include "fmi_stage.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/solvers/case.hpp"

/// FMUs of the models in tests/package/fmi/hybrid_models.h.
namespace odeum::fmi_tests {

/// A variable of a description, by the types of FMI 2.
struct Written {
  std::string name;
  unsigned reference;
  std::string type, causality, variability, start = {};
  unsigned derivative_of = 0;
};

/// What modelDescription.xml is written of.
struct Model {
  std::string token;
  double stop;
  std::vector<Written> variables;
  unsigned indicators = 0;
  std::string flags = {};  ///< further attributes of ModelExchange
};

inline std::string type_in_three(const std::string& type) {
  return type == "Real" ? "Float64" : type == "Integer" ? "Int32" : type;
}

inline std::string xml_of(const Model& model, bool three) {
  std::string variables, derivatives;
  for (std::size_t k = 0; k < model.variables.size(); ++k) {
    const Written& v = model.variables[k];
    const std::string common =
        fmt::format(R"( name="{}" valueReference="{}" causality="{}" variability="{}")", v.name,
                    v.reference, v.causality, v.variability);
    const std::string start = v.start.empty() ? "" : fmt::format(R"( start="{}")", v.start);
    const std::string initial =
        v.start.empty() || v.causality == "input" ? "" : R"( initial="exact")";
    // FMI 2 counts variables from 1, FMI 3 names references.
    unsigned of = v.derivative_of;
    for (std::size_t i = 0; !three && of != 0 && i < model.variables.size(); ++i)
      if (model.variables[i].reference == v.derivative_of) of = static_cast<unsigned>(i) + 1;
    const std::string derivative = of == 0 ? "" : fmt::format(R"( derivative="{}")", of);
    variables += three ? fmt::format("<{}{}{}{}{}/>", type_in_three(v.type), common, initial, start,
                                     derivative)
                       : fmt::format("<ScalarVariable{}{}><{}{}{}/></ScalarVariable>", common,
                                     initial, v.type, start, derivative);
    if (of != 0)
      derivatives +=
          three ? fmt::format(R"(<ContinuousStateDerivative valueReference="{}"/>)", v.reference)
                : fmt::format(R"(<Unknown index="{}"/>)", k + 1);
  }
  if (!three) derivatives = "<Derivatives>" + derivatives + "</Derivatives>";
  for (unsigned k = 0; three && k < model.indicators; ++k)
    derivatives += fmt::format(R"(<EventIndicator valueReference="{}"/>)", 100 + k);
  return fmt::format(
      R"(<fmiModelDescription fmiVersion="{}.0" modelName="{}" {}="{}" numberOfEventIndicators="{}">
<ModelExchange modelIdentifier="hybrid" {}/><DefaultExperiment startTime="0" stopTime="{}"/>
<ModelVariables>{}</ModelVariables><ModelStructure>{}</ModelStructure></fmiModelDescription>)",
      three ? 3 : 2, model.token, three ? "instantiationToken" : "guid", model.token,
      model.indicators, model.flags, model.stop, variables, derivatives);
}

inline Model ball() {
  return {"{ball}",
          3,
          {{"h", 1, "Real", "output", "continuous", "1"},
           {"v", 2, "Real", "output", "continuous", "0"},
           {"der(h)", 9, "Real", "local", "continuous", "", 1},
           {"der(v)", 10, "Real", "local", "continuous", "", 2},
           {"g", 3, "Real", "parameter", "fixed", "-9.81"},
           {"e", 4, "Real", "parameter", "fixed", "0.7"},
           {"v_min", 5, "Real", "parameter", "fixed", "0.1"}},
          1};
}
inline Model stair() {
  return {"{stair}", 10, {{"counter", 1, "Integer", "output", "discrete", "1"}}};
}
/// x' = u - x.
inline Model follow() {
  return {"{follow}",
          3,
          {{"x", 1, "Real", "output", "continuous", "0"},
           {"der(x)", 9, "Real", "local", "continuous", "", 1},
           {"u", 2, "Real", "input", "continuous", "1"}}};
}
/// x' = -x, and one more where it is below 1/2 at the end of a step.
inline Model steps(const std::string& flags) {
  return {"{steps}",
          2,
          {{"x", 1, "Real", "output", "continuous", "1"},
           {"der(x)", 9, "Real", "local", "continuous", "", 1}},
          0,
          flags};
}
inline Model thermostat() {
  return {"{thermostat}",
          4,
          {{"temperature", 1, "Real", "output", "continuous", "5"},
           {"der(temperature)", 9, "Real", "local", "continuous", "", 1}},
          1};
}

/// With the binary of these models.
class HybridFmus : public Fmus {
 protected:
  std::string written(const Model& model, const Entries& more = {}) {
    const std::string name =
        three() ? "binaries/" ODEUM_PROCESSOR "-linux/hybrid.so" : "binaries/linux64/hybrid.so";
    Entries all{{"modelDescription.xml", xml_of(model, three())},
                {name, read(three() ? ODEUM_HYBRID3 : ODEUM_HYBRID2)}};
    all.insert(all.end(), more.begin(), more.end());
    return archive(all);
  }
  Case hybrid(const Model& model, const Values& values = {}, const std::string& inputs = {},
              const Entries& more = {}) {
    foreign::ProblemCallbacks given = open_fmu(written(model, more), values, inputs);
    given.id = "model";
    return cases::foreign_statement(std::move(given)).make();
  }
  /// Its states at times by a solver to a tolerance, or in steps.
  static Outcome run(const Case& c, const std::string& id, const std::vector<double>& stops,
                     double tolerance, std::uint64_t steps = 0) {
    Request request{.mode = steps > 0 ? Mode::fixed : Mode::adaptive, .stops = stops};
    request.steps = steps;
    request.tolerance = tolerance;
    const Entrant* const entrant = c.entrants.find(id);
    return entrant && entrant->solve ? entrant->solve(request) : refused("no solver " + id);
  }
  /// A file of inputs.
  std::string csv(const std::string& text) {
    const fs::path file = folder_ / "inputs.csv";
    std::ofstream(file) << text;
    return file.string();
  }
};

}  // namespace odeum::fmi_tests
