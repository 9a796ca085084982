// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "odeum/cases/foreseen_cost.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/printed_text.hpp"
#include "odeum/cases/proposed_scale.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/study_steps.hpp"
#include "odeum/cases/text_events.hpp"
#include "odeum/cases/text_facts.hpp"
#include "odeum/cases/text_family.hpp"
#include "odeum/cases/text_switches.hpp"
#include "odeum/cases/text_truth.hpp"
#include "odeum/formula/cache.hpp"

namespace odeum::cases {
namespace {

/// What is known of a file before it is read as a problem.
struct File {
  const PrintedText* printed = nullptr;  ///< null: no built-in text has its equations
  std::string folder = {};               ///< of its references; empty: they are built in
};

class TextCase : CaseText, public std::enable_shared_from_this<TextCase> {
 public:
  TextCase(const File& file, const TextSource& source) : CaseText(source), file_(file) {}
  Case make() {
    require_signs();
    case_.text = std::make_shared<const TextSource>(source_);
    case_.t0 = static_cast<double>(problem_.t0);
    case_.y0.assign(problem_.y0.begin(), problem_.y0.end());
    case_.source = text("source", problem_.file);
    case_.equation = text("equation", problem_.equations_text);
    add_parameters();
    read_numbers();
    if (!has_name_of_column(problem_.states)) case_.components = problem_.states;
    case_.units.scale = problem_.scale;
    set_problem();
    add_outputs(problem_, case_);
    set_truth();
    select_invariants();
    set_facts(case_);
    case_.compute_truth = std::bind_front(&TextCase::complete, shared_from_this());
    return std::move(case_);
  }

 private:
  void complete(Case& c, const TruthBounds& bounds) {
    if (waits_for_truth_) {
      truth_ = truth_of(ode_, c.units, along_, bounds, [&](auto& r) { foresee_cost(c, r); });
      take_truth(c);
      cut_stops(c, truth_.stops);
    }
    if (!truth_.words.empty() && !c.problem.events) hold_invariants(c);
    if (!file_.folder.empty()) prove(ode_ ? ode_->problem() : problem_, *analysis_, c, truth_);
    choose_settings(c);
    set_facts(c);
  }

  void set_facts(Case& c) const {
    c.facts = text_facts(problem_, *analysis_, file_.printed ? nullptr : ode_.get(), truth_, c);
    if (problem_.scale.empty() && !c.units.scale.empty())
      c.facts.push_back(units_fact(c.units, problem_.states, problem_.tolerance.relative == 0));
  }
  void add_parameters() {
    const std::vector<Item> meanings = mapping("meanings");
    for (const std::string& name : offered_) {
      const Item* const meaning = input::entry_of(meanings, name);
      const auto value = static_cast<double>(problem_.parameters.at(name));
      if (has("parameters") || has("meanings"))
        case_.equation +=
            fmt::format("{} {} = {}", case_.parameters.empty() ? ";" : ",", name, value);
      case_.parameters.push_back({name, value, meaning ? scalar(*meaning->value, name) : ""});
    }
    if (offered_.empty()) return;
    if (problem_.events.empty() && problem_.jumps.empty()) case_.family = TextFamilies{source_};
    // What stays as it is keeps all digits of the file.
    case_.with_values = [file = file_, source = source_, now = case_.parameters](
                            const Values& values, const TruthBounds& bounds) {
      TextSource other = source;
      for (std::size_t k = 0; k < now.size(); ++k)
        if (values[k] != now[k].value)
          other.set[now[k].name] = fmt::format("{:.21g}", static_cast<long double>(values[k]));
      Case c = std::make_shared<TextCase>(file, other)->make();
      odeum::complete(c, bounds);
      return c;
    };
  }

  void read_numbers() {
    case_.stops = stops_of(source_.span, case_.t0, stops());
    add_stops();
    if (problem_.tolerance.relative > 0) case_.tolerance = problem_.tolerance;
    const std::vector<double> units = has("thresholds") ? thresholds() : problem_.scale;
    if (!units.empty() && (has("thresholds") || problem_.tolerance.relative == 0))
      case_.tolerance = Tolerance::of_thresholds(case_.tolerance.relative, units);
    StudySettings& settings = case_.settings;
    settings.no_fixed_steps = text("no_fixed_steps", "");
    case_.nature = nature();
    take_number("steps_multiple", settings.steps_multiple);
    take_number("coarsest_steps", settings.coarsest_steps);
    take_number("finest_steps", settings.finest_steps);
    take_number("evaluation_budget", settings.evaluation_budget);
    if (source_.span.given()) return;
    settings.timed_stops = times("timed_stops");
    take_number("timed_floor", settings.timed_floor);
  }

  /// The problem's truth is to be known at the stops of the case and of timed studies.
  void add_stops() {
    std::vector<double>& stops = problem_.stops = case_.stops;
    if (!source_.span.given())
      for (const double timed : times("timed_stops")) stops.push_back(timed);
    std::ranges::sort(stops);
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  }

  /// Takes the code of a built-in text, or compiles the problem.
  void set_problem() {
    const formula::Offers offers = this->offers();
    if (file_.printed) {
      std::vector<double> values;
      for (const std::string& name : file_.printed->parameters)
        values.push_back(static_cast<double>(problem_.parameters.at(name)));
      analysis_ = std::make_shared<const formula::Analysis>(formula::analyse(problem_));
      file_.printed->put(values.data(), case_);
    } else {
      require_code();
      case_.problem = {offered(ode_->view(), offers),
                       ode_,
                       case_.t0,
                       std::make_shared<const std::vector<double>>(case_.y0),
                       nullptr,
                       formula::implicit_form(problem_)};
      add_invariants(problem_, case_);
    }
    if (take_changes(problem_, case_) || !file_.printed)
      case_.entrants = enroll_unchanging(case_.problem);
    const formula::Structure& s = analysis_->structure;
    case_.nature.linear = s.linear, case_.nature.autonomous = s.autonomous;
    if (s.second_order && offers.second_order) {
      case_.tags.emplace_back("second_order");
      if (!s.velocity_dependent) case_.tags.emplace_back("separable");
    }
  }

  void require_code() {
    if (ode_) return;
    ode_ = std::make_shared<const formula::TextOde>(problem_);
    analysis_ = {ode_, &ode_->analysis()};
  }

  /// A reference holds for the usual parameters alone; complete() computes one when a run asks.
  void set_truth() {
    const std::vector<std::string> files = texts("reference");
    double floor = 0;
    take_number("floor", floor);
    if (!files.empty() && !(floor > 0))
      fail(find("reference")->place, "floor: got none, expected the error of the reference");
    if (!files.empty() && is_usual()) {
      case_.truth = reference(files.front(), floor);
      for (std::size_t k = 1; k < files.size(); ++k)
        case_.truth.at = [before = case_.truth.at, more = reference(files[k], floor).at](
                             double t, double* y) { return before(t, y) || more(t, y); };
      if (!problem_.exact.empty())
        case_.truth.at = [before = case_.truth.at, between = closed_form(problem_).truth.at](
                             double t, double* y) { return before(t, y) || between(t, y); };
      if (case_.extended && file_.folder.empty()) {
        ExtendedProblem extended = *case_.extended;
        extended.truth = extended_truth(files.front());
        extended.floor = std::max(floor, 1e-20);  // the digits of the file
        case_.extended = std::make_shared<const ExtendedProblem>(std::move(extended));
      }
      return;
    }
    const bool follows = problem_.exact.empty() && files.empty();
    waits_for_truth_ = follows && problem_.jumps.empty();  // methods would agree on what has none
    if (waits_for_truth_ || (!follows && files.empty() && !file_.folder.empty())) look_along();
    if (problem_.exact.empty()) {
      case_.truth = follows ? unknown_truth(waits_for_truth_ ? "not computed" : problem_.jumps)
                            : unknown_truth();
      if (along_ && along_->whole) take_sizes(*along_, case_.truth);
    } else {
      truth_ = closed_form(problem_, case_.units);
      take_truth(case_);
    }
  }

  void take_truth(Case& c) {
    c.truth = truth_.truth;
    double floor = 0;
    take_number("floor", floor);
    if (floor > 0) c.truth.floor = floor, c.truth.floors.clear();
  }

  /// The truth keeps what the text states as kept.
  void hold_invariants(Case& c) {
    std::vector<long double> y(c.y0.size());
    for (const double stop : truth_.stops)
      if (truth_.extended(stop, y.data())) formula::require_invariants(problem_, stop, y.data());
    if (!ode_) return;
    c.extended = std::make_shared<const ExtendedProblem>(
        ExtendedProblem{.f = [ode = ode_](long double t, const long double* at,
                                          long double* f) { ode->rhs_extended(t, at, f); },
                        .y0 = problem_.y0,
                        .truth = truth_.extended,
                        .floor = truth_.extended_floor});
  }

  Truth reference(const std::string& name, double floor) const {
    try {
      return reference_truth(name, floor, file_.folder);
    } catch (const std::exception& error) {
      fail(find("reference")->place, "reference: {}", error.what());
    }
  }

  /// Before the truth is computed, so that runs need not wait for it.
  void look_along() {
    require_code();
    along_ = along_of(ode_);
    if (along_ && along_->slides_from < problem_.stops.back())
      case_.entrants = enroll_unchanging(case_.problem, bound_by_sliding(along_->slides_from));
    if (along_ && problem_.scale.empty() && !has("thresholds"))
      take_units(case_, proposed_units(*along_), problem_.tolerance.relative == 0);
  }

  /// Leaves those that `invariants` names.
  void select_invariants() {
    if (!has("invariants")) return;
    const std::vector<std::string> names = texts("invariants");
    for (const std::string& name : names)
      if (std::ranges::find(problem_.invariants, name, &formula::Invariant::name) ==
          problem_.invariants.end())
        fail(find("invariants")->place, "invariants: no invariant; got {}", shown(name));
    std::erase_if(case_.invariants, [&](const Invariant& invariant) {
      return std::ranges::find(names, invariant.name) == names.end();
    });
  }

  void choose_settings(Case& c) {
    for (const char* key : {"no_fixed_steps", "steps_multiple", "coarsest_steps", "finest_steps",
                            "evaluation_budget"})
      if (has(key) && !source_.span.given()) return;
    choose_steps(c, analysis_->structure.smooth, !truth_.stops.empty());
  }

  File file_;
  bool waits_for_truth_ = false;
  std::shared_ptr<const formula::TextOde> ode_;
  std::shared_ptr<const formula::Analysis> analysis_;
  TextTruth truth_;
  std::shared_ptr<const truth::Along> along_;  ///< null: not known
  Case case_;
};

File user_file(const std::string& file, const std::string& text) {
  return {printed_with(formula::content_key(formula::code_of_problem(file, text))),
          std::filesystem::absolute(file).parent_path().string()};
}

std::vector<Statement> statements_of(const File& file, TextSource source) {
  formula::CaseSection keys(source.file, source.text);
  std::vector<std::string> ids = keys.ids();
  if (ids.empty()) ids = {source.id};
  std::vector<Statement> all;
  for (const std::string& id : ids) {
    keys.enter(id);
    source.id = id;
    all.push_back(
        {.id = id,
         .title = keys.text("title", keys.name().empty() ? id : keys.name()),
         .tags = keys.all_texts("tags"),
         .make = [file, source] { return std::make_shared<TextCase>(file, source)->make(); }});
  }
  return all;
}

}  // namespace

std::vector<Statement> text_statements(const std::string& file, const std::string& text,
                                       const std::string& id, const formula::Overrides& set,
                                       const Span& span) {
  return statements_of(user_file(file, text), {file, text, id, set, span});
}

std::vector<Statement> text_statements(const BuiltInText& text) {
  return statements_of({printed_of(text.stem)}, source_of(text, text.stem));
}

}  // namespace odeum::cases
