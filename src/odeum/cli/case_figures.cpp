// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/cli/case_runs.hpp"
#include "odeum/judge/errors.hpp"

namespace odeum::cli {
namespace {

using report::ChartPoint;
using report::Figure;
using report::FigureLine;

/// A number of the state, or of it and the time.
using Quantity = std::function<double(double t, const double* y)>;

constexpr std::size_t most_components = 6;

class Figures {
 public:
  Figures(const Case& c, const std::vector<CaseRun>& runs, const ExactStates& exact)
      : c_(c), runs_(runs), exact_(exact), names_(component_names(c)), n_(c.y0.size()) {}

  std::vector<Figure> all() {
    if (n_ > 1 && n_ <= 4 && runs_.size() == 1 && !second_order()) together();
    const auto measured = judge::measured_components(c_);
    const std::size_t shown = std::min(measured.size(), most_components);
    for (std::size_t m = 0; m < shown; ++m) component(measured[m]);
    if (second_order())
      for (std::size_t i = 0; i < std::min<std::size_t>(n_ / 2, 2); ++i) plane(i, n_ / 2 + i);
    else if (n_ > 1)
      plane(0, 1);
    if (second_order() && n_ / 2 >= 2) plane(0, 1, "Path");
    error();
    if (c_.energy) energy();
    steps();
    return std::move(figures_);
  }

 private:
  bool second_order() const { return c_.problem.view.second_order(); }

  std::vector<ChartPoint> points(const CaseRun& run, const Quantity& x, const Quantity& y) const {
    std::vector<ChartPoint> list{{x(c_.t0, c_.y0.data()), y(c_.t0, c_.y0.data())}};
    for (std::size_t k = 0; k < run.reached(n_); ++k) {
      const double t = run.request.stops[k], *const state = run.outcome.states.data() + k * n_;
      list.emplace_back(x(t, state), y(t, state));
    }
    return list;
  }

  // The same of the scheme's own closed form; empty where none is known.
  std::vector<ChartPoint> scheme_points(const CaseRun& run, const Quantity& x,
                                        const Quantity& y) const {
    if (std::isnan(difference_to_scheme(c_, run))) return {};
    std::vector<ChartPoint> list;
    std::vector<double> state(n_);
    for (const double t : run.request.stops) {
      const double h = run.step(c_.t0), count = std::round((t - c_.t0) / h);
      c_.scheme(run.entrant->info.id(), h, count, state.data());
      list.emplace_back(x(t, state.data()), y(t, state.data()));
    }
    return list;
  }

  void draw(Figure figure, const Quantity& x, const Quantity& y) {
    std::vector<ChartPoint> exact;
    for (std::size_t k = 0; k < exact_.times.size(); ++k)
      exact.emplace_back(x(exact_.times[k], exact_.states[k].data()),
                         y(exact_.times[k], exact_.states[k].data()));
    if (exact.size() > 1)
      figure.lines.push_back({.name = "exact", .points = exact, .marks_only = !exact_.everywhere});
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const std::string id = runs_[r].entrant->info.id();
      figure.lines.push_back({.name = id, .style = r, .points = points(runs_[r], x, y)});
      auto scheme = scheme_points(runs_[r], x, y);
      if (!scheme.empty())
        figure.lines.push_back({.name = id + ", its own closed form",
                                .style = r,
                                .points = std::move(scheme),
                                .dashed = true});
    }
    figures_.push_back(std::move(figure));
  }

  static double time(double t, const double*) { return t; }
  static Quantity component_of(std::size_t i) {
    return [i](double, const double* y) { return y[i]; };
  }

  void together() {
    Figure figure{.title = "Components over time", .x = "time"};
    for (std::size_t i = 0; i < n_; ++i)
      figure.lines.push_back(
          {.name = names_[i], .style = i, .points = points(runs_[0], time, component_of(i))});
    figures_.push_back(std::move(figure));
  }
  void component(std::size_t i) {
    draw({.title = names_[i] + " over time", .x = "time", .y = names_[i]}, time, component_of(i));
  }
  void plane(std::size_t i, std::size_t j, const char* title = "State plane") {
    draw({.title = fmt::format("{}: {} against {}", title, names_[j], names_[i]),
          .x = names_[i],
          .y = names_[j]},
         component_of(i), component_of(j));
  }

  void error() {
    Figure figure{
        .title = "Largest error over time", .x = "time", .y = "error", .logarithmic = true};
    const auto measured = judge::measured_components(c_);
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      FigureLine line{.name = runs_[r].entrant->info.id(), .style = r, .points = {}};
      for (std::size_t k = 0; k < runs_[r].reached(n_); ++k) {
        const double t = runs_[r].request.stops[k];
        const auto at = std::lower_bound(exact_.times.begin(), exact_.times.end(), t);
        if (at == exact_.times.end() || *at != t) continue;
        const auto& exact = exact_.states[static_cast<std::size_t>(at - exact_.times.begin())];
        double largest = 0;
        for (const std::size_t i : measured)
          largest = std::fmax(largest, std::abs(runs_[r].outcome.states[k * n_ + i] - exact[i]));
        line.points.emplace_back(t, largest);
      }
      line.marks_only = !exact_.everywhere;
      if (!line.points.empty()) figure.lines.push_back(std::move(line));
    }
    if (!figure.lines.empty()) figures_.push_back(std::move(figure));
  }

  void energy() {
    const double start = c_.energy(c_.y0.data());
    draw({.title = "Energy, less that at the start", .x = "time", .y = "energy"}, time,
         [&](double, const double* y) { return c_.energy(y) - start; });
  }

  void steps() {
    Figure figure{.title = "Steps taken over time", .x = "time", .y = "step", .logarithmic = true};
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      FigureLine line{.name = runs_[r].entrant->info.id(), .style = r, .points = {}};
      double before = c_.t0;
      for (const double t : runs_[r].outcome.step_ends) {
        line.points.emplace_back(before, t - before);
        line.points.emplace_back(t, t - before);
        before = t;
      }
      if (!line.points.empty()) figure.lines.push_back(std::move(line));
    }
    if (!figure.lines.empty()) figures_.push_back(std::move(figure));
  }

  const Case& c_;
  const std::vector<CaseRun>& runs_;
  const ExactStates& exact_;
  std::vector<std::string> names_;
  std::size_t n_;
  std::vector<Figure> figures_;
};

}  // namespace

std::vector<report::Figure> case_figures(const Case& c, const std::vector<CaseRun>& runs,
                                         const ExactStates& exact) {
  return Figures(c, runs, exact).all();
}

}  // namespace odeum::cli
