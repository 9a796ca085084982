// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "sbml/translation.hpp"

namespace odeum::adapters::sbml {

std::string Translation::expression(const ASTNode& node, const SBase& of, bool at_start,
                                    const Reaction* in, bool as_condition) {
  Meaning meaning;
  meaning.value = [&](const std::string& id) { return value(id, at_start, in); };
  meaning.rate = [&](const std::string& id) {
    const auto locals = in ? locals_.find(in->getId()) : locals_.end();
    const bool is_local = locals != locals_.end() && locals->second.contains(id);
    return is_local ? std::string("0") : rate_of(id, at_start);
  };
  if (at_start) meaning.time = "0";
  try {
    MathText text(model_, meaning);
    return as_condition ? text.condition(node) : text.number(node);
  } catch (const Unsupported& error) {
    const std::string& id = of.getId();
    throw ElementError(of,
                       fmt::format("{}{}", error.what(), id.empty() ? "" : " (for " + id + ")"));
  }
}

std::string Translation::value(const std::string& id, bool at_start, const Reaction* in) {
  if (in)
    if (const auto locals = locals_.find(in->getId()); locals != locals_.end())
      if (const auto local = locals->second.find(id); local != locals->second.end())
        return local->second;
  return at_start ? start_of(id) : quantity(id).name;
}

std::string Translation::start_of(const std::string& id) {
  if (const auto known = starts_.find(id); known != starts_.end()) return known->second;
  const Quantity& q = quantity(id);
  if (!in_start_.insert(id).second)
    throw ElementError(*q.element,
                       "a cycle of rules and initial assignments, with " + id + " in it");
  std::string start;
  const ASTNode* const rule = q.assigned ? q.assigned : q.initial;
  if (q.kind == Kind::reaction)
    start = law(static_cast<const Reaction&>(*q.element), true);
  else if (rule)
    start = expression(*rule, *q.element, true);
  else
    start = start_without_rules(q, id);
  in_start_.erase(id);
  // What stays as it is has a name, which --set gives another value.
  const bool is_parameter = q.kind == Kind::parameter && !q.rated && !q.assigned && !q.is_reset;
  return starts_[id] = is_parameter ? q.name : "(" + start + ")";
}

std::string Translation::start_without_rules(const Quantity& q, const std::string& id) {
  const auto given = [&](bool is_set, double number) {
    if (!is_set || !std::isfinite(number))
      throw ElementError(*q.element, "a quantity without a value (" + id + ")");
    return text_of(number);
  };
  switch (q.kind) {
    case Kind::compartment: {
      const auto& c = static_cast<const Compartment&>(*q.element);
      const bool is_point = c.isSetSpatialDimensions() && c.getSpatialDimensionsAsDouble() == 0;
      return is_point && !c.isSetSize() ? "1" : given(c.isSetSize(), c.getSize());
    }
    case Kind::parameter: {
      const auto& p = static_cast<const Parameter&>(*q.element);
      return given(p.isSetValue(), p.getValue());
    }
    case Kind::reference:
      return own_stoichiometry(static_cast<const SpeciesReference&>(*q.element), true);
    default:
      break;
  }
  const auto& s = static_cast<const Species&>(*q.element);
  if (s.isSetInitialConcentration()) {
    const std::string number = given(true, s.getInitialConcentration());
    return is_amount(s) ? number + "*" + volume(s, true) : number;
  }
  const std::string number = given(s.isSetInitialAmount(), s.getInitialAmount());
  return is_amount(s) ? number : number + "/" + volume(s, true);
}

std::string Translation::volume(const Species& species, bool at_start) {
  return value(species.getCompartment(), at_start, nullptr);
}

std::string Translation::start_amount(const std::string& id, const Species& species) {
  if (quantity(id).initial == nullptr && species.isSetInitialAmount())
    return text_of(species.getInitialAmount());
  return start_of(id) + "*" + volume(species, true);
}

std::string Translation::law(const Reaction& reaction, bool at_start) {
  const KineticLaw* const given = reaction.getKineticLaw();
  if (!given || !given->isSetMath())
    throw ElementError(reaction, "a reaction without a rate (" + reaction.getId() + ")");
  return expression(*given->getMath(), reaction, at_start, &reaction);
}

std::string Translation::own_stoichiometry(const SpeciesReference& reference, bool at_start) {
  if (const StoichiometryMath* const math = reference.getStoichiometryMath();
      math && math->isSetMath())
    return "(" + expression(*math->getMath(), reference, at_start) + ")";
  if (!std::isfinite(reference.getStoichiometry()))
    throw ElementError(reference,
                       "a stoichiometry without a value (of " + reference.getSpecies() + ")");
  return text_of(reference.getStoichiometry() / reference.getDenominator());
}

std::string Translation::stoichiometry(const SpeciesReference& reference, bool at_start) {
  const std::string& id = reference.getId();
  if (!id.empty() && quantities_.contains(id)) {
    const Quantity& q = quantity(id);
    if (q.assigned || q.rated || q.initial || q.is_reset) return value(id, at_start, nullptr);
  }
  return own_stoichiometry(reference, at_start);
}

std::string Translation::made(const Species& species, bool at_start) {
  std::string sum;
  for (unsigned k = 0; k < model_.getNumReactions(); ++k) {
    const Reaction& reaction = *model_.getReaction(k);
    const auto add = [&](const SpeciesReference& reference, bool is_reactant) {
      if (reference.getSpecies() != species.getId()) return;
      std::string number = stoichiometry(reference, at_start);
      if (number == "1")
        number.clear();
      else
        number += '*';
      sum += fmt::format("{}{}{}",
                         is_reactant   ? " - "
                         : sum.empty() ? ""
                                       : " + ",
                         number, value(reaction.getId(), at_start, nullptr));
    };
    for (unsigned j = 0; j < reaction.getNumReactants(); ++j) add(*reaction.getReactant(j), true);
    for (unsigned j = 0; j < reaction.getNumProducts(); ++j) add(*reaction.getProduct(j), false);
  }
  if (sum.empty()) return "0";
  const std::string factor = species.isSetConversionFactor()  ? species.getConversionFactor()
                             : model_.isSetConversionFactor() ? model_.getConversionFactor()
                                                              : "";
  return factor.empty() ? sum : fmt::format("({})*{}", sum, value(factor, at_start, nullptr));
}

std::string Translation::rate_of(const std::string& id, bool at_start) {
  const Quantity& q = quantity(id);
  if (q.assigned) throw Unsupported("the rate of what a rule assigns, " + id + ",");
  if (!at_start)
    if (const auto known = rates_.find(id); known != rates_.end()) return known->second;
  std::string rate = "0";
  if (q.rated) {
    rate = expression(*q.rated, *q.element, at_start);
  } else if (q.kind == Kind::species) {
    const auto& s = static_cast<const Species&>(*q.element);
    if (is_changed_by_reactions(s)) rate = made(s, at_start);
    if (!is_amount(s)) {
      const std::string v = volume(s, at_start);
      rate = fmt::format("({})/{}", rate, v);
      if (volume_changes(s))
        rate += fmt::format(" - {}*{}/{}", value(id, at_start, nullptr),
                            rate_of(s.getCompartment(), at_start), v);
    }
  }
  if (at_start) return "(" + rate + ")";
  const std::string name = text_.new_name("rate_of_" + q.name);
  rates_[id] = name;
  text_.definition(name, rate);
  return name;
}

}  // namespace odeum::adapters::sbml
