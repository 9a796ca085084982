// SPDX-License-Identifier: BSD-3-Clause
#include "fmi/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {
namespace {

using Node = pugi::xml_node;

[[noreturn]] void refuse(const std::string& why) {
  throw LoadError("modelDescription.xml: " + why);
}

std::string text_of(const Node& node, const char* attribute) {
  return foreign::cleaned(node.attribute(attribute).as_string());
}

/// A number in an attribute, or `otherwise` where there is none.
template <class Number>
Number number_of(const Node& node, const char* attribute, Number otherwise) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return otherwise;
  const char* first = found.value();
  if (*first == '+') ++first;
  const char* const last = first + std::strlen(first);
  Number value{};
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc{} || end != last)
    refuse(fmt::format("{}: got \"{}\", expected a number", attribute,
                       foreign::cleaned(found.value())));
  return value;
}

bool flag(const Node& node, const char* attribute) {
  const std::string value = node.attribute(attribute).as_string();
  return value == "true" || value == "1";
}

Variable variable_of(const Node& node, const Node& typed) {
  Variable v;
  v.name = text_of(node, "name");
  v.type = typed.name();
  v.reference = number_of<std::uint32_t>(node, "valueReference", 0);
  v.start = typed.attribute("start").as_string();
  v.nominal = std::abs(number_of<double>(typed, "nominal", 0));
  const std::string causality = node.attribute("causality").as_string(),
                    variability = node.attribute("variability").as_string(),
                    initial = node.attribute("initial").as_string();
  v.is_time = causality == "independent";
  v.is_parameter = causality == "parameter";
  v.is_input = causality == "input";
  v.is_output = causality == "output";
  v.is_discrete = variability.empty() ? !v.is_real() : variability != "continuous";
  v.is_array = !!node.child("Dimension");
  v.settable = variability != "constant" && !v.is_time &&
               (v.is_parameter || v.is_input || initial == "exact" || initial == "approx");
  return v;
}

/// The fault of a variable without a name, or of one whose start is not a finite number; empty:
/// none.
std::string fault_of(const Variable& v) {
  if (v.name.empty())
    return fmt::format("the variable of value reference {} has no name", v.reference);
  std::istringstream values(v.type == "String" ? "" : v.start);
  for (std::string value; values >> value;) {
    const char* const first = value.c_str();
    char* end = nullptr;
    if (!std::isfinite(std::strtod(first, &end)) && *end == 0)
      return fmt::format("variable {}: start: got \"{}\", expected a finite number", v.name,
                         foreign::cleaned(first));
  }
  return {};
}

void read_variables(const Node& root, const std::string& xml, Description& d) {
  std::set<std::string> names;
  for (const Node& node : root.child("ModelVariables").children()) {
    if (node.type() != pugi::node_element) continue;
    Node typed = node;
    if (d.version == 2)
      for (const char* type : {"Real", "Integer", "Boolean", "String", "Enumeration"})
        if (const Node child = node.child(type)) typed = child;
    if (d.version == 3 && std::strcmp(node.name(), "Clock") == 0)
      refuse(fmt::format("the model has the clock {}; clocks are not followed",
                         text_of(node, "name")));
    d.variables.push_back(variable_of(node, typed));
    const Variable& v = d.variables.back();
    const bool shown = !v.is_array && v.type != "String" && v.type != "Binary";
    if (v.is_output && shown) d.outputs.push_back(d.variables.size() - 1);
    if (v.is_output && !shown) d.unshown.push_back(v.name);
    std::string fault = fault_of(v);
    if (fault.empty() && !names.insert(v.name).second)
      fault = fmt::format("variable {}: there are two of that name", v.name);
    if (fault.empty()) continue;
    const auto at = std::min(static_cast<std::size_t>(node.offset_debug()), xml.size());
    const auto end = xml.begin() + static_cast<std::ptrdiff_t>(at);
    refuse(fmt::format("line {}: {}", 1 + std::count(xml.begin(), end, '\n'), fault));
  }
}

/// The states and derivatives among the variables.
class Structure {
 public:
  explicit Structure(Description& d) : d_(d) {
    for (std::size_t i = 0; i < d.variables.size(); ++i)
      by_reference_.emplace(d.variables[i].reference, i);
  }

  /// FMI 2 counts variables from 1, FMI 3 has value references.
  std::size_t place(std::uint32_t number) const {
    if (d_.version == 2) {
      if (number == 0 || number > d_.variables.size())
        refuse(fmt::format("index {}: there are {} variables", number, d_.variables.size()));
      return number - 1;
    }
    const auto found = by_reference_.find(number);
    if (found == by_reference_.end())
      refuse(fmt::format("no variable has the reference {}", number));
    return found->second;
  }

  bool names_time(const Node& unknown) const {
    std::istringstream numbers(unknown.attribute("dependencies").value());
    for (std::uint32_t number = 0; numbers >> number;)
      if (d_.variables[place(number)].is_time) return true;
    return false;
  }

  void add_derivative(const Node& unknown, const Node& variable) {
    const std::size_t at =
        place(number_of<std::uint32_t>(unknown, d_.version == 2 ? "index" : "valueReference", 0));
    if (!variable.attribute("derivative"))
      refuse(fmt::format("{} is listed as a derivative, but of no state", d_.variables[at].name));
    const std::size_t state = place(number_of<std::uint32_t>(variable, "derivative", 0));
    d_.derivatives.push_back(at);
    d_.states.push_back(state);
    d_.has_arrays = d_.has_arrays || d_.variables[state].is_array;
    d_.names_time = d_.names_time || names_time(unknown);
  }

 private:
  Description& d_;
  std::map<std::uint32_t, std::size_t> by_reference_;
};

void read_structure(const Node& root, Description& d) {
  std::vector<Node> typed;
  for (const Node& node : root.child("ModelVariables").children())
    if (node.type() == pugi::node_element)
      typed.push_back(d.version == 2 ? node.child("Real") : node);
  Structure structure(d);
  const Node model = root.child("ModelStructure");
  const auto add = [&](const Node& unknown) {
    const std::size_t at = structure.place(
        number_of<std::uint32_t>(unknown, d.version == 2 ? "index" : "valueReference", 0));
    structure.add_derivative(unknown, typed[at]);
  };
  if (d.version == 2)
    for (const Node& unknown : model.child("Derivatives").children("Unknown")) add(unknown);
  else
    for (const Node& unknown : model.children("ContinuousStateDerivative")) add(unknown);
}

/// Why the model is not one for Model Exchange.
std::string other_purpose(const Node& root) {
  if (root.child("CoSimulation"))
    return "the model is for co-simulation only: it brings its own integrator";
  if (root.child("ScheduledExecution"))
    return "the model is for scheduled execution only, whose clocks are not followed";
  return "the model is not for Model Exchange";
}

/// The name of the binaries for a purpose.
std::string name_of_file(const Node& purpose) {
  std::string name = purpose.attribute("modelIdentifier").as_string();
  if (name.empty() || name.find_first_of("/\\") != std::string::npos)
    refuse(fmt::format("modelIdentifier: got \"{}\", expected a name",
                       foreign::cleaned(name.c_str())));
  return name;
}

/// What it says of events.
void read_events(const Node& root, const Node& exchange, Description& d) {
  d.indicators = number_of<std::uint32_t>(root, "numberOfEventIndicators", 0);
  d.has_indicators =
      d.version == 2 ? d.indicators > 0 : !!root.child("ModelStructure").child("EventIndicator");
  if (d.version == 2) {
    d.completes_steps = !flag(exchange, "completedIntegratorStepNotNeeded");
  } else if (exchange.attribute("needsCompletedIntegratorStep")) {
    d.completes_steps = d.acts_at_steps = flag(exchange, "needsCompletedIntegratorStep");
  }
}

void read_experiment(const Node& root, Description& d) {
  const Node experiment = root.child("DefaultExperiment");
  d.t0 = number_of<double>(experiment, "startTime", 0);
  d.stop_is_given = !!experiment.attribute("stopTime");
  d.stop = number_of<double>(experiment, "stopTime", d.t0 + 1);
  if (!std::isfinite(d.t0) || !std::isfinite(d.stop) || !(d.stop > d.t0))
    refuse(
        fmt::format("DefaultExperiment: the time from {} to {} is not an interval", d.t0, d.stop));
  if (experiment.attribute("tolerance"))
    d.tolerance = number_of<double>(experiment, "tolerance", 0);
}

}  // namespace

Description read_description(const std::string& xml) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(
      xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_auto);
  if (!parsed) refuse(fmt::format("byte {}: {}", parsed.offset, parsed.description()));
  for (const Node& node : document.children())
    if (node.type() == pugi::node_doctype)
      refuse("has a document type declaration, whose entities are not expanded");
  const Node root = document.child("fmiModelDescription");
  if (!root) refuse("has no element fmiModelDescription");
  Description d;
  const std::string version = text_of(root, "fmiVersion");
  if (version != "2.0" && !version.starts_with("3."))
    refuse(fmt::format("fmiVersion is \"{}\", expected 2.0 or 3.0", version));
  d.version = version == "2.0" ? 2 : 3;
  const Node exchange = root.child("ModelExchange");
  if (!exchange) refuse(other_purpose(root));
  d.model = text_of(root, "modelName");
  d.text = text_of(root, "description");
  d.identifier = name_of_file(exchange);
  if (const Node own = root.child("CoSimulation"); own && !flag(own, "needsExecutionTool"))
    d.co_simulation = name_of_file(own);
  d.token = root.attribute(d.version == 2 ? "guid" : "instantiationToken").as_string();
  d.directional_derivatives = flag(exchange, d.version == 2 ? "providesDirectionalDerivative"
                                                            : "providesDirectionalDerivatives");
  if (flag(exchange, "needsExecutionTool"))
    refuse("the model needs its simulation tool beside it (needsExecutionTool)");
  read_events(root, exchange, d);
  read_experiment(root, d);
  read_variables(root, xml, d);
  read_structure(root, d);
  return d;
}

}  // namespace odeum::adapters::fmi
