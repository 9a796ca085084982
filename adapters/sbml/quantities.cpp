// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "sbml/translation.hpp"

namespace odeum::adapters::sbml {

void Translation::add(Kind kind, const std::string& id, const SBase& element) {
  if (id.empty()) return;
  const auto [at, is_new] = quantities_.try_emplace(id, Quantity{kind, "", &element});
  if (!is_new) throw ElementError(element, "the id " + id + " is given twice");
  order_.push_back(id);
}

void Translation::collect() {
  for (unsigned k = 0; k < model_.getNumCompartments(); ++k)
    add(Kind::compartment, model_.getCompartment(k)->getId(), *model_.getCompartment(k));
  for (unsigned k = 0; k < model_.getNumSpecies(); ++k)
    add(Kind::species, model_.getSpecies(k)->getId(), *model_.getSpecies(k));
  for (unsigned k = 0; k < model_.getNumParameters(); ++k)
    add(Kind::parameter, model_.getParameter(k)->getId(), *model_.getParameter(k));
  for (unsigned k = 0; k < model_.getNumReactions(); ++k) {
    const Reaction& reaction = *model_.getReaction(k);
    if (reaction.isSetFast() && reaction.getFast())
      throw ElementError(reaction, "fast reactions (" + reaction.getId() + ")");
    add(Kind::reaction, reaction.getId(), reaction);
    for (unsigned j = 0; j < reaction.getNumReactants(); ++j)
      add(Kind::reference, reaction.getReactant(j)->getId(), *reaction.getReactant(j));
    for (unsigned j = 0; j < reaction.getNumProducts(); ++j)
      add(Kind::reference, reaction.getProduct(j)->getId(), *reaction.getProduct(j));
  }
  // Names of the model first: what is made of them gives way.
  for (const std::string& id : order_) quantities_.at(id).name = text_.new_name(id);
  collect_rules();
  collect_events();
}

void Translation::collect_events() {
  for (unsigned k = 0; k < model_.getNumEvents(); ++k) {
    const Event& event = *model_.getEvent(k);
    for (unsigned j = 0; j < event.getNumEventAssignments(); ++j) {
      const EventAssignment& assignment = *event.getEventAssignment(j);
      const auto found = quantities_.find(assignment.getVariable());
      if (found == quantities_.end())
        throw ElementError(assignment, "an event that sets " + assignment.getVariable() +
                                           ", which the model has not");
      if (found->second.assigned)
        throw ElementError(assignment, "an event that sets " + assignment.getVariable() +
                                           ", which a rule assigns");
      found->second.is_reset = true;
    }
  }
}

void Translation::collect_rules() {
  for (unsigned k = 0; k < model_.getNumRules(); ++k) {
    const Rule& rule = *model_.getRule(k);
    if (rule.isAlgebraic()) throw ElementError(rule, "algebraic rules");
    if (!rule.isSetMath()) continue;
    const auto found = quantities_.find(rule.getVariable());
    if (found == quantities_.end())
      throw ElementError(rule, "a rule for " + rule.getVariable() + ", which the model has not");
    (rule.isRate() ? found->second.rated : found->second.assigned) = rule.getMath();
  }
  for (unsigned k = 0; k < model_.getNumInitialAssignments(); ++k) {
    const InitialAssignment& initial = *model_.getInitialAssignment(k);
    if (!initial.isSetMath()) continue;
    const auto found = quantities_.find(initial.getSymbol());
    if (found == quantities_.end())
      throw ElementError(initial, "an initial assignment for " + initial.getSymbol() +
                                      ", which the model has not");
    found->second.initial = initial.getMath();
  }
}

const Quantity& Translation::quantity(const std::string& id) const {
  const auto found = quantities_.find(id);
  if (found == quantities_.end())
    throw Unsupported("the name " + id + ", which the model does not declare,");
  return found->second;
}

bool Translation::volume_changes(const Species& species) const {
  const Quantity& q = quantity(species.getCompartment());
  return q.rated || q.assigned || q.is_reset;
}

bool Translation::is_amount(const Species& species) const {
  const Compartment* const in = model_.getCompartment(species.getCompartment());
  return species.getHasOnlySubstanceUnits() ||
         (in && in->isSetSpatialDimensions() && in->getSpatialDimensionsAsDouble() == 0);
}

bool Translation::is_changed_by_reactions(const Species& species) const {
  if (species.getBoundaryCondition() || species.getConstant()) return false;
  for (unsigned k = 0; k < model_.getNumReactions(); ++k) {
    const Reaction& reaction = *model_.getReaction(k);
    if (reaction.getReactant(species.getId()) || reaction.getProduct(species.getId())) return true;
  }
  return false;
}

}  // namespace odeum::adapters::sbml
