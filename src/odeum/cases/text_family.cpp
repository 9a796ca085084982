// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "odeum/cases/case_text.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/formula/lane_code.hpp"

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
  TextFamily(const std::string& file, const std::string& text, const std::string& id,
             const formula::Overrides& set)
      : CaseText(file, text, id, set),
        file_(file),
        text_(text),
        usual_stops_(stops()),
        usual_(problem_.parameters),
        y0_(std::make_shared<std::vector<double>>(problem_.states.size())),
        ode_(std::make_shared<formula::TextOde>(
            formula::read_problem(file, text, values_, formula::Parameters::names))) {
    for (const formula::Invariant& invariant : ode_->problem().invariants)
      if (!energy_ && (invariant.name == "energy" || invariant.name == "H"))
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
    formula::Overrides all = values_;
    for (const std::string& name : offered_)
      all[name] = fmt::format("{:.21g}", problem_.parameters.at(name));
    const Problem read = formula::read_problem(file_, text_, all);
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
    Family family;
    family.y0 = self->y0_;
    family.entrants =
        enroll({view, self, static_cast<double>(self->problem_.t0), self->y0_, nullptr});
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
  std::string file_, text_;
  std::vector<double> usual_stops_;
  std::map<std::string, long double> usual_;
  std::shared_ptr<std::vector<double>> y0_;
  std::shared_ptr<formula::TextOde> ode_;
  std::optional<formula::Evaluator<double>> energy_;
};

}  // namespace

TextFamilies::TextFamilies(std::string file, std::string text, std::string id,
                           formula::Overrides set)
    : file_(std::move(file)), text_(std::move(text)), id_(std::move(id)), set_(std::move(set)) {}

std::optional<Family> TextFamilies::operator()(
    const std::vector<std::vector<double>>& samples) const {
  const auto family = std::make_shared<TextFamily>(file_, text_, id_, set_);
  for (const std::vector<double>& values : samples)
    if (!family->agrees(values)) return std::nullopt;
  return TextFamily::make(family);
}

FamilyInLanes TextFamilies::in_lanes() const {
  const auto family = std::make_shared<TextFamily>(file_, text_, id_, set_);
  return {family->in_lanes(),
          [family](const std::vector<double>& values) { return family->place(values); }};
}

}  // namespace odeum::cases
