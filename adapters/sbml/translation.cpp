// SPDX-License-Identifier: BSD-3-Clause
#include "sbml/translation.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace odeum::adapters::sbml {

void Translation::add_state(const std::string& name, const std::string& start,
                            const std::string& equation) {
  text_.state(name, start);
  text_.equation(name, equation);
}

void Translation::write_species(const std::string& id, const Quantity& q) {
  const auto& s = static_cast<const Species&>(*q.element);
  const bool amount = is_amount(s), moves = volume_changes(s);
  const std::string v = volume(s, false);
  if (q.assigned) {
    text_.definition(q.name, expression(*q.assigned, s, false));
  } else if (q.rated) {
    add_state(q.name, start_of(id), expression(*q.rated, s, false));
  } else {
    const bool reacts = is_changed_by_reactions(s);
    if (!amount && moves) {
      const std::string name = amounts_[id] = text_.new_name(q.name + "_amount");
      if (reacts || q.is_reset)
        add_state(name, start_amount(id, s), reacts ? made(s, false) : "0");
      else
        text_.parameter(name, start_amount(id, s));
      text_.definition(q.name, name + "/" + v);
    } else if (reacts) {
      add_state(q.name, start_of(id),
                amount ? made(s, false) : fmt::format("({})/{}", made(s, false), v));
    } else if (q.is_reset) {
      add_state(q.name, start_of(id), "0");
    } else {
      text_.parameter(q.name, start_of(id));
    }
  }
}

void Translation::write_measures(const std::string& id, const Quantity& q) {
  const auto& s = static_cast<const Species&>(*q.element);
  const std::string v = volume(s, false);
  const Compartment* const in = model_.getCompartment(s.getCompartment());
  if (!is_amount(s))
    text_.output(id + "_amount", q.name + "*" + v);
  else if (!(in && in->isSetSpatialDimensions() && in->getSpatialDimensionsAsDouble() == 0))
    text_.output(id + "_concentration", q.name + "/" + v);
}

/// What has a value of its own, and rates of reactions.
void Translation::write_other(const std::string& id, const Quantity& q) {
  if (q.kind == Kind::reaction)
    text_.definition(q.name, law(static_cast<const Reaction&>(*q.element), false));
  else if (q.assigned)
    text_.definition(q.name, expression(*q.assigned, *q.element, false));
  else if (q.rated)
    add_state(q.name, start_of(id), expression(*q.rated, *q.element, false));
  else if (q.is_reset)
    add_state(q.name, start_of(id), "0");
  else if (q.initial)
    text_.parameter(q.name, expression(*q.initial, *q.element, true));
  else if (q.kind == Kind::reference &&
           static_cast<const SpeciesReference&>(*q.element).isSetStoichiometryMath())
    text_.definition(q.name,
                     stoichiometry(static_cast<const SpeciesReference&>(*q.element), false));
  else
    text_.parameter(q.name, start_without_rules(q, id));
}

void Translation::write_locals(const Reaction& reaction) {
  const KineticLaw* const given = reaction.getKineticLaw();
  if (!given) return;
  const auto add = [&](const Parameter& local) {
    if (!local.isSetValue())
      throw ElementError(local, "a quantity without a value (" + local.getId() + ")");
    const std::string name = text_.new_name(reaction.getId() + "_" + local.getId());
    locals_[reaction.getId()][local.getId()] = name;
    text_.parameter(name, text_of(local.getValue()));
  };
  if (given->getNumLocalParameters() > 0)
    for (unsigned k = 0; k < given->getNumLocalParameters(); ++k) add(*given->getLocalParameter(k));
  else
    for (unsigned k = 0; k < given->getNumParameters(); ++k) add(*given->getParameter(k));
}

std::string Translation::text(double end) {
  collect();
  for (unsigned k = 0; k < model_.getNumReactions(); ++k) write_locals(*model_.getReaction(k));
  for (const std::string& id : order_) {
    const Quantity& q = quantities_.at(id);
    if (q.kind == Kind::species)
      write_species(id, q);
    else
      write_other(id, q);
  }
  for (unsigned k = 0; k < model_.getNumEvents(); ++k)
    write_event(*model_.getEvent(k), static_cast<int>(k));
  // Ids before what is derived of them.
  for (const std::string& id : order_) text_.output(id, quantities_.at(id).name);
  for (const std::string& id : order_)
    if (const Quantity& q = quantities_.at(id); q.kind == Kind::species) write_measures(id, q);
  // A text has a state.
  if (!text_.has_states()) add_state(text_.new_name("clock"), "0", "1");
  try {
    return text_.text(end);
  } catch (const std::invalid_argument& cycle) {
    throw ElementError(model_, cycle.what());
  }
}

}  // namespace odeum::adapters::sbml
