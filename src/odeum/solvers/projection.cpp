// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "odeum/core/text_of.hpp"
#include "odeum/linear/dense_lu.hpp"

namespace odeum {
namespace {

const char* const option = "projection";

/// A problem that offers the projection beside its own functions.
class ProjectedProblem {
  template <auto member, class R, class... All>
  static auto inside(R (*)(const void*, All...)) {
    return +[](const void* self, All... all) -> R {
      const OdeView& whole = static_cast<const ProjectedProblem*>(self)->whole_;
      return (whole.*member)(whole.problem, all...);
    };
  }

 public:
  ProjectedProblem(const ErasedContest& contest, const Request& request)
      : whole_(contest.view),
        keep_alive_(contest.keep_alive),
        implicit_(contest.implicit),
        tolerance_(request.tolerance),
        adaptive_(request.mode == Mode::adaptive) {}

  /// This must outlive the view.
  OdeView view() const {
    OdeView view = whole_;
    view.problem = this;
    view.rhs = inside<&OdeView::rhs>(whole_.rhs);
#define ODEUM_INSIDE(concept_name, function, charge, ...) \
  if (view.function) view.function = inside<&OdeView::function>(whole_.function);
    ODEUM_CAPABILITIES(ODEUM_INSIDE)
#undef ODEUM_INSIDE
    view.project = [](const void* self, double t, double* y) {
      return static_cast<const ProjectedProblem*>(self)->project(t, y);
    };
    return view;
  }

  /// See capabilities.hpp. Each correction is the shortest one in units of the weights: x = D G^T
  /// (G D G^T)^-1 g with the slopes G and D the squares of the weights.
  std::uint64_t project(double t, double* y) const {
    const Constraints& all = implicit_->constraints;
    const std::size_t n = whole_.dimension, m = all.names.size();
    std::vector<double> g(m), slopes(m * n), squares(n);
    linear::DenseLu system(m);
    constexpr double small = 1e-6, rounding = 1e-14, much_rounding = 1e-8;
    constexpr std::uint64_t most = 10;
    double before = std::numeric_limits<double>::infinity();
    for (std::uint64_t iteration = 1; iteration <= most; ++iteration) {
      all.values(t, y, g.data());
      all.slopes(t, y, slopes.data());
      for (std::size_t i = 0; i < n; ++i) {
        const double weight = weight_of(i, y[i]);
        squares[i] = weight * weight;
      }
      for (std::size_t a = 0; a < m; ++a)
        for (std::size_t b = 0; b < m; ++b) {
          double sum = 0;
          for (std::size_t i = 0; i < n; ++i)
            sum += slopes[a * n + i] * squares[i] * slopes[b * n + i];
          system.data()[a * m + b] = sum;
        }
      if (!system.factorise()) return 0;
      system.solve(g.data());
      double largest = 0, relative = 0;
      for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;
        for (std::size_t a = 0; a < m; ++a) sum += slopes[a * n + i] * g[a];
        const double change = squares[i] * sum;
        y[i] -= change;
        if (!std::isfinite(y[i])) return 0;
        largest = std::max(largest, std::abs(change) / std::sqrt(squares[i]));
        relative = std::max(relative, std::abs(change) / (1 + std::abs(y[i])));
      }
      // The next correction would be as the square of this one; at rounding they no longer fall.
      if (largest <= small || relative <= rounding) return iteration;
      if (relative <= much_rounding && relative > before / 2) return iteration;
      before = relative;
    }
    return 0;
  }

 private:
  double weight_of(std::size_t i, double y) const {
    return adaptive_ ? tolerance_.absolute(i) + tolerance_.relative * std::abs(y) : 1 + std::abs(y);
  }

  OdeView whole_;
  std::shared_ptr<const void> keep_alive_;
  std::shared_ptr<const ImplicitForm> implicit_;
  Tolerance tolerance_;
  bool adaptive_;
};

}  // namespace

void offer_projection(const Solver& solver, const ErasedContest& contest, Entrant& entrant) {
  const SolverInfo& info = solver.info;
  if (!entrant.solve || !contest.implicit || contest.implicit->constraints.names.empty() ||
      info.needs.starts_with("residuals"))
    return;
  const std::string& jumps = contest.implicit->constraints.jumps;
  if (info.library != "odeum" || info.family == "multistep") {
    if (jumps.empty()) return;
    entrant.solve = {};
    entrant.unfit = "steps along rates, which jump to no other state: " + jumps;
    return;
  }
  entrant.info.options[option] =
      "1: after each step the state moves onto the constraints, hidden ones among them";
  entrant.solve = [solver, contest, alone = std::move(entrant.solve)](const Request& request) {
    const std::string& jumps = contest.implicit->constraints.jumps;
    const auto asked = request.options.find(option);
    if (asked == request.options.end() || asked->second == 0)
      return jumps.empty()
                 ? alone(request)
                 : refused("expected --option projection=1, or a solver of residuals: " + jumps);
    if (asked->second != 1)
      return refused("projection: got " + text_of(asked->second) + ", expected 0 or 1");
    const auto projected = std::make_shared<const ProjectedProblem>(contest, request);
    ErasedContest other = contest;
    other.view = projected->view();
    other.keep_alive = projected;
    std::vector<double> y0 = *contest.y0;  // a part of a run may begin where states jump
    projected->project(contest.t0, y0.data());
    other.y0 = std::make_shared<const std::vector<double>>(std::move(y0));
    Entrant with;
    with.info = solver.info;
    solver.enroll(other, with);
    Outcome outcome = with.solve(request);
    const std::size_t n = contest.view.dimension;
    // States between the ends of steps are interpolated.
    for (std::size_t k = 0; request.over_stops && k < outcome.states.size() / n; ++k)
      projected->project(request.stops[k], outcome.states.data() + k * n);
    return outcome;
  };
}

}  // namespace odeum
