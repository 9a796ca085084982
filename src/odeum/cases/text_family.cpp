// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/text_switches.hpp"
#include "odeum/formula/exact.hpp"
#include "odeum/formula/lane_code.hpp"
#include "odeum/formula/switch_times.hpp"

namespace odeum::cases {
namespace {

using formula::Problem;

bool near(double a, double b) {
  constexpr double rounding = 1e-11;  // of equations whose terms cancel, constants folded or not
  return a == b || std::abs(a - b) <= rounding * std::max({1e-3, std::abs(a), std::abs(b)}) ||
         (std::isnan(a) && std::isnan(b));
}

class TextFamily : CaseText {
 public:
  explicit TextFamily(const TextSource& source)
      : CaseText(source),
        usual_stops_(stops()),
        usual_(problem_.parameters),
        y0_(std::make_shared<std::vector<double>>(problem_.states.size())),
        ode_(std::make_shared<formula::TextOde>(with_names())),
        has_switches_(formula::has_timed_switches(ode_->problem())) {
    for (const formula::Invariant& invariant : ode_->problem().invariants)
      if (!energy_ && invariant.is_energy())
        energy_.emplace(ode_->problem().graph, std::vector<formula::Id>{invariant.value});
  }

  bool place(const std::vector<double>& values) {
    CaseText::place(values, usual_);
    require_signs();
    if (!ode_->set_parameters(problem_.parameters)) return false;
    std::ranges::copy(ode_->problem().y0, y0_->begin());
    if (energy_) energy_->define(ode_->constants());
    return true;
  }

  /// Whether the problem with these values is that which the text makes of them.
  bool agrees(const std::vector<double>& values) {
    if (!place(values)) return false;
    const Problem read = as_text();
    problem_.stops = read.stops;
    const std::size_t n = y0_->size();
    if (read.states.size() != n || read.t0 != problem_.t0 || stops() != usual_stops_) return false;
    const formula::Evaluator<double> rhs(read.graph, read.equations);
    std::vector<double> y(read.y0.begin(), read.y0.end()), f(n), f_read(n);
    if (!std::equal(y.begin(), y.end(), y0_->begin(), near)) return false;
    for (const double part : {0., 0.3, 1.}) {
      const auto t0 = static_cast<double>(read.t0);
      const double t = t0 + part * (usual_stops_.back() - t0);
      for (double& each : y) each += part * (0.1 + 0.1 * std::abs(each));
      rhs(t, y.data(), f_read.data());
      ode_->rhs(t, y.data(), f.data());
      if (!std::equal(f.begin(), f.end(), f_read.begin(), near)) return false;
    }
    return true;
  }

  /// Up to `end`, of the problem with the values that were placed last.
  std::vector<Switch> switches(double from, double end) const {
    return from_time(switches_of(as_text(), end), from);
  }

  LaneFamily in_lanes() {
    LaneFamily family{.lanes = formula::compile_lanes(*ode_),
                      .alone = offered(ode_->view(), offers()),
                      .t0 = static_cast<double>(problem_.t0),
                      .constants = &ode_->constants(),
                      .y0 = y0_.get()};
    if (!family.alone.time_derivative) family.lanes.time_derivative = nullptr;
    return family;
  }

  static Family make(const std::shared_ptr<TextFamily>& self) {
    const OdeView view = offered(self->ode_->view(), self->offers());
    ErasedContest contest{view, self, static_cast<double>(self->problem_.t0), self->y0_, nullptr};
    if (self->has_switches_)
      contest.switches = [self](double from, double end) { return self->switches(from, end); };
    Family family;
    family.y0 = self->y0_;
    family.entrants = enroll(contest);
    family.place = [self](const std::vector<double>& values) { self->place(values); };
    if (self->energy_)
      family.energy = [self](const double* y) {
        double value = 0;
        (*self->energy_)(0, y, &value);
        return value;
      };
    return family;
  }

 private:
  /// What the text makes of the values that were placed last.
  Problem as_text() const {
    formula::Overrides all = values_;
    for (const std::string& name : offered_)
      all[name] = fmt::format("{:.21g}", problem_.parameters.at(name));
    return formula::read_problem(source_.file, source_.text, all);
  }

  std::vector<double> usual_stops_;
  std::map<std::string, long double> usual_;
  std::shared_ptr<std::vector<double>> y0_;
  std::shared_ptr<formula::TextOde> ode_;
  std::optional<formula::Evaluator<double>> energy_;
  bool has_switches_;
};

/// The closed form for any values of the parameters.
class TextExact : CaseText {
 public:
  explicit TextExact(const TextSource& source) : CaseText(source), named_(with_names()) {
    if (!named_.exact.empty()) exact_.emplace(named_);
  }

  bool known() const { return exact_.has_value(); }

  bool operator()(const std::vector<double>& values, double t, double* y) {
    place(values, named_.parameters);
    exact_->define(formula::definitions_of(named_.graph, problem_.parameters));
    // A formula may hold for some values only, as one with a root does.
    const long double t0 = named_.t0, end = t;
    for (const long double at : {t0, t0 + (end - t0) * 0.4375L, end})
      if (exact_->flaw_at(at, t0, end)) return false;
    std::copy_n(exact_->state(), named_.states.size(), y);
    return true;
  }

 private:
  Problem named_;
  std::optional<formula::Exact> exact_;
};

/// The outputs for any values of the parameters.
class TextOutputs : CaseText {
 public:
  explicit TextOutputs(const TextSource& source) : CaseText(source), named_(with_names()) {
    std::vector<formula::Id> roots;
    for (const formula::Output& output : named_.outputs) roots.push_back(output.value);
    outputs_.emplace(named_.graph, roots);
  }

  void operator()(const std::vector<double>& values, double t, const double* y, double* out) {
    if (values != placed_) {
      place(values, named_.parameters);
      const auto constants = formula::definitions_of(named_.graph, problem_.parameters);
      outputs_->define({constants.begin(), constants.end()});
      placed_ = values;
    }
    (*outputs_)(t, y, out);
  }

 private:
  Problem named_;
  std::optional<formula::Evaluator<double>> outputs_;
  std::vector<double> placed_;
};

}  // namespace

std::optional<Family> TextFamilies::operator()(
    const std::vector<std::vector<double>>& samples) const {
  const auto family = std::make_shared<TextFamily>(source);
  for (const std::vector<double>& values : samples)
    if (!family->agrees(values)) return std::nullopt;
  return TextFamily::make(family);
}

FamilyInLanes TextFamilies::in_lanes() const {
  const auto family = std::make_shared<TextFamily>(source);
  return {family->in_lanes(),
          [family](const std::vector<double>& values) { return family->place(values); }};
}

MemberTruth TextFamilies::exact() const {
  const auto exact = std::make_shared<TextExact>(source);
  if (!exact->known()) return {};
  return [exact](const std::vector<double>& values, double t, double* y) {
    return (*exact)(values, t, y);
  };
}

MemberOutputs TextFamilies::outputs() const {
  return [outputs = std::make_shared<TextOutputs>(source)](const std::vector<double>& values,
                                                           double t, const double* y, double* out) {
    (*outputs)(values, t, y, out);
  };
}

}  // namespace odeum::cases
