// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "sbml/translation.hpp"

namespace odeum::adapters::sbml {

std::pair<std::string, std::string> Translation::reset(const Event& event,
                                                       const EventAssignment& assignment) {
  const std::string& id = assignment.getVariable();
  const std::string value = expression(*assignment.getMath(), event, false);
  const auto amount = amounts_.find(id);
  if (amount == amounts_.end()) return {quantity(id).name, value};
  // The amount of a species whose symbol is a concentration, in the volume before the event, as the
  // SBML Test Suite has it where the event sets both.
  const std::string& in = static_cast<const Species&>(*quantity(id).element).getCompartment();
  return {amount->second, fmt::format("({})*{}", value, quantity(in).name)};
}

void Translation::write_event(const Event& event, int place) {
  const Trigger* const trigger = event.getTrigger();
  std::vector<std::pair<std::string, std::string>> set, keys;
  for (unsigned k = 0; k < event.getNumEventAssignments(); ++k)
    if (const EventAssignment& assignment = *event.getEventAssignment(k); assignment.isSetMath())
      set.push_back(reset(event, assignment));
  if (!trigger || !trigger->isSetMath() || set.empty()) return;
  const auto key = [&](const char* name, const std::string& value) {
    keys.emplace_back(name, value);
  };
  key("when", expression(*trigger->getMath(), event, false, nullptr, true));
  key("initially", trigger->getInitialValue() ? "true" : "false");
  key("persistent", trigger->getPersistent() ? "true" : "false");
  // Events of one priority have no order in SBML: here that of the file.
  key("order", fmt::format("{}", place));
  if (event.getDelay() && event.getDelay()->isSetMath())
    key("delay", expression(*event.getDelay()->getMath(), event, false));
  if (event.getPriority() && event.getPriority()->isSetMath())
    key("priority", expression(*event.getPriority()->getMath(), event, false));
  key("early", event.getUseValuesFromTriggerTime() ? "true" : "false");
  key("name", event.getId().empty() ? fmt::format("event {}", place + 1) : event.getId());
  text_.event(keys, set);
}

}  // namespace odeum::adapters::sbml
