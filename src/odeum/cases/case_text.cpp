// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "odeum/cases/parameters.hpp"
#include "odeum/formula/parser.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/print/print_problem.hpp"

namespace odeum::cases {

CaseText::CaseText(const TextSource& source)
    : CaseSection(source.file, source.text), source_(source) {
  enter(source.id);
  values_ = own_values();
  problem_ = formula::read_problem(source.file, source.text, values_);
  usual_ = problem_.parameters;
  read_offered();
  if (source.set.empty()) return;
  for (const auto& [name, value] : source.set) {
    if (problem_.parameters.contains(name) && std::ranges::find(offered_, name) == offered_.end())
      throw std::invalid_argument(fmt::format("{} has no parameter {}; expected {}", source.id,
                                              name, one_of(offered_, name)));
    values_[name] = value;
  }
  take_values();
  require_signs();
  problem_ = formula::read_problem(source.file, source.text, values_);
}

// Numbers alone, so that signs are checked before the problem is made of them.
void CaseText::take_values() {
  for (const auto& [name, value] : source_.set) {
    formula::Graph graph;
    try {
      const formula::Id id = formula::parse_expression(value, {}, graph);
      if (graph.is_constant(id) && problem_.parameters.contains(name))
        problem_.parameters[name] = graph[id].value;
    } catch (const formula::ExpressionError&) {
      continue;  // the reader of the problem says what is wrong
    }
  }
}

formula::Overrides CaseText::own_values() {
  const std::vector<Item> given = mapping("set");
  if (given.empty()) return {};
  const auto known = formula::read_problem(source_.file, source_.text).parameters;
  std::vector<std::string> names;
  for (const auto& [name, value] : known) names.push_back(name);
  formula::Overrides values;
  for (const Item& item : given) {
    if (!known.contains(item.key))
      fail(item.key_place, "set: no parameter; got {}, expected {}", shown(item.key),
           one_of(names, item.key));
    values[item.key] = scalar(*item.value, "set: " + item.key);
  }
  return values;
}

double CaseText::number(const YamlNode& value, const std::string& key) {
  formula::Graph graph;
  formula::Scope scope;
  for (const auto& [name, known] : problem_.parameters) scope.names[name] = graph.constant(known);
  try {
    const formula::Id id = formula::parse_expression(scalar(value, key), scope, graph);
    if (graph.is_constant(id)) return static_cast<double>(graph[id].value);
  } catch (const formula::ExpressionError& error) {
    fail(value.place, "{}: {}", key, error.what());
  }
  fail(value.place, "{}: not a constant; got t in it, expected a number", key);
}

std::vector<double> CaseText::numbers(const std::string& key) {
  std::vector<double> all;
  for (const YamlNode* entry : entries(find(key))) all.push_back(number(*entry, key));
  return all;
}

std::vector<double> CaseText::times(const std::string& key) {
  std::vector<double> all = numbers(key);
  auto before = static_cast<double>(problem_.t0);
  for (const double stop : all) {
    if (!(stop > before))
      fail(find(key)->place, "{}: got {}, expected a time after {}", key, stop, before);
    before = stop;
  }
  return all;
}

std::vector<double> CaseText::stops() {
  if (!has("stops")) return problem_.stops;
  std::vector<double> all = times("stops");
  if (all.empty()) fail(find("stops")->place, "stops: got none, expected one at least");
  return all;
}

void CaseText::place(const std::vector<double>& values,
                     const std::map<std::string, long double>& as_read) {
  for (std::size_t k = 0; k < offered_.size(); ++k) {
    const long double read = as_read.at(offered_[k]);
    problem_.parameters[offered_[k]] =
        values[k] == static_cast<double>(read) ? read : static_cast<long double>(values[k]);
  }
}

std::vector<double> CaseText::thresholds() {
  std::vector<double> all = numbers("thresholds");
  const auto bad = [](double threshold) { return !(threshold > 0); };
  if (all.size() != problem_.states.size() || std::ranges::any_of(all, bad))
    fail(find("thresholds")->place, "thresholds: expected {} positive numbers, one for each state",
         problem_.states.size());
  return all;
}

// Offers the names under `parameters`, else those under `meanings`, else every parameter.
void CaseText::read_offered() {
  const std::vector<Item> meanings = mapping("meanings");
  const auto require = [&](const std::string& name, Place place, const char* in) {
    if (!problem_.parameters.contains(name))
      fail(place, "{}: no parameter; got {}, expected one of the file", in, shown(name));
  };
  for (const Item& item : meanings) require(item.key, item.key_place, "meanings");
  offered_ = texts("parameters");
  for (const std::string& name : offered_) require(name, find("parameters")->place, "parameters");
  if (has("parameters")) return;
  for (const Item& item : meanings) offered_.push_back(item.key);
  if (has("meanings")) return;
  for (const auto& [name, value] : problem_.parameters) offered_.push_back(name);
}

Nature CaseText::nature() const {
  Nature nature;
  for (const std::string& word : all_texts("nature")) {
    bool* const said = word == "smooth"    ? &nature.smooth
                       : word == "stiff"   ? &nature.stiff
                       : word == "chaotic" ? &nature.chaotic
                                           : nullptr;
    if (!said)
      fail(find("nature")->place, "nature: got {}, expected smooth, stiff or chaotic", word);
    *said = true;
  }
  return nature;
}

void CaseText::require_signs() {
  for (const YamlNode* each : entries(find("positive")))
    require_positive(scalar(*each, "positive"), number(*each, "positive"));
  for (const YamlNode* each : entries(find("not_negative")))
    require_not_negative(scalar(*each, "not_negative"), number(*each, "not_negative"));
}

bool CaseText::is_usual() const {
  return std::equal(usual_.begin(), usual_.end(), problem_.parameters.begin(),
                    [](const auto& a, const auto& b) {
                      return static_cast<double>(a.second) == static_cast<double>(b.second);
                    });
}

OdeView offered(OdeView view, const formula::Offers& offers) {
  if (!offers.jacobian) {
    view.jacobian = nullptr;
    view.jacobian_entries = nullptr;
    view.jacobian_times = nullptr;
    view.sparsity = nullptr;
    view.linear_matrix = nullptr;
  }
  if (!offers.second_order) view.acceleration = nullptr;
  if (!offers.series) view.taylor = nullptr;
  return view;
}

formula::Problem CaseText::with_names() const {
  return formula::read_problem(source_.file, source_.text, values_, formula::Parameters::names);
}

std::string CaseText::as_struct(bool series) const {
  constexpr std::size_t most_states = 200;
  // Parameters are the struct's members, but where the number of states follows from one.
  formula::Problem problem = problem_;
  try {
    problem = with_names();
  } catch (const InputError&) {
    ;  // the text is sound: it was read before
  }
  const std::size_t n = problem.states.size();
  if (n > most_states || problem.kinetic_energy != formula::no_node)
    fail({},
         "got {}, expected at most {} states and no mass matrix, since a program spells out each "
         "equation",
         n > most_states ? fmt::format("{} states", n) : "a mass matrix", most_states);
  const formula::Analysis analysis = formula::analyse(problem);
  return print::print_struct("Problem", problem, analysis, {.series = series});
}

}  // namespace odeum::cases
