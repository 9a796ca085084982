// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "accuracy/wrong_solvers.hpp"
#include "odeum/proof/test_problems.hpp"

namespace odeum::tests {
namespace {

template <class P>
Case make_case(const std::string& id, std::shared_ptr<const P> problem, double t0, double horizon,
               std::vector<double> y0, std::function<void(double t, double* y)> truth) {
  Case c;
  c.id = id;
  c.nature.smooth = true;
  c.t0 = t0;
  c.y0 = std::move(y0);
  for (int k = 1; k <= 4; ++k) c.stops.push_back(t0 + horizon * k / 4);
  c.truth.at = [truth = std::move(truth)](double t, double* y) {
    truth(t, y);
    return true;
  };
  c.settings.steps_multiple = 4;
  c.settings.finest_steps = 8192;
  c.problem.view = view_of(*problem);
  c.problem.keep_alive = problem;
  return c;
}

template <class P>
Case on_test_problem(const std::string& id, const proof::TestProblem<P>& test) {
  return make_case(id, std::make_shared<const P>(test.problem), test.t0, test.horizon, test.y0,
                   test.truth);
}

/// Kaps' problem, y1' = -(200 + 2) y1 + 200 y2^2, y2' = y1 - y2 - y2^2: y = (exp(-2t), exp(-t)).
struct Kaps {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* d) const {
    d[0] = -202 * y[0] + 200 * y[1] * y[1];
    d[1] = y[0] - y[1] - y[1] * y[1];
  }
};
void kaps_truth(double t, double* y) {
  y[0] = std::exp(-2 * t);
  y[1] = std::exp(-t);
}

/// A ring of unknowns, each driven by its neighbours' deviations from a travelling wave, which is
/// the solution: y_i = sin(2t + i pi/10), y_i' = s_i' + s_i (y_{i+1} - s_{i+1}) - (y_i - s_i).
struct Ring {
  static constexpr std::size_t dimension = 20;
  static double wave(double t, std::size_t i) {
    return std::sin(2 * t + std::numbers::pi / 10 * static_cast<double>(i));
  }
  void rhs(double t, const double* y, double* d) const {
    for (std::size_t i = 0; i < dimension; ++i) {
      const std::size_t next = (i + 1) % dimension;
      const double speed = 2 * std::cos(2 * t + std::numbers::pi / 10 * static_cast<double>(i));
      d[i] = speed + y[i] * (y[next] - wave(t, next)) - (y[i] - wave(t, i));
    }
  }
};
void ring_truth(double t, double* y) {
  for (std::size_t i = 0; i < Ring::dimension; ++i) y[i] = Ring::wave(t, i);
}

/// Kepler's problem at eccentricity 0.3, from the pericentre.
struct Kepler {
  static constexpr std::size_t dimension = 4;
  static constexpr double e = 0.3;
  void rhs(double, const double* y, double* d) const {
    const double r = std::hypot(y[0], y[1]), cube = r * r * r;
    d[0] = y[2], d[1] = y[3];
    d[2] = -y[0] / cube, d[3] = -y[1] / cube;
  }
};
void kepler_truth(double t, double* y) {
  double u = t;  // the eccentric anomaly, by Newton
  for (int i = 0; i < 20; ++i)
    u -= (u - Kepler::e * std::sin(u) - t) / (1 - Kepler::e * std::cos(u));
  const double b = std::sqrt(1 - Kepler::e * Kepler::e), r = 1 - Kepler::e * std::cos(u);
  y[0] = std::cos(u) - Kepler::e, y[1] = b * std::sin(u);
  y[2] = -std::sin(u) / r, y[3] = b * std::cos(u) / r;
}

/// Prothero and Robinson's, y' = -10 (y - cos t) - sin t: y = cos t.
struct Relaxation {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* d) const {
    d[0] = -10 * (y[0] - std::cos(t)) - std::sin(t);
  }
};
void relaxation_truth(double t, double* y) { y[0] = std::cos(t); }

std::vector<double> at_start(std::size_t size, void (*truth)(double t, double* y)) {
  std::vector<double> y(size);
  truth(0, y.data());
  return y;
}

/// The fixed-step run of a Step.
Outcome run(const Case& c, const MakeStep& make, const Request& request) {
  const FixedGrid grid(c.t0, request);
  const Step step = make(c.problem.view);
  Vector y = c.y0;
  Outcome outcome;
  std::size_t stop = 0;
  for (std::uint64_t i = 0; i < grid.steps(); ++i) {
    step(i, grid.t(i), grid.h(), y);
    if (i + 1 == grid.index_of(stop)) outcome.record(request.stops[stop++], y.data(), y.size());
  }
  outcome.counters.steps = grid.steps();
  outcome.counters.work = outcome.counters.rhs_evaluations = 4 * grid.steps();
  for (const double x : outcome.states)
    if (!std::isfinite(x)) outcome.status = Status::non_finite;
  return outcome;
}

}  // namespace

Entrant entrant_of(const WrongSolver& solver, bool with_fault, const Case& c) {
  Entrant entrant;
  entrant.info.library = "wrong";
  entrant.info.method = solver.name;
  entrant.info.order = solver.claimed;
  if (solver.adaptive())
    entrant.solve = [&c, run = with_fault ? solver.wrong_run : solver.right_run](
                        const Request& request) { return run(c, request); };
  else
    entrant.solve = [&c, make = with_fault ? solver.wrong : solver.right](const Request& request) {
      return run(c, make, request);
    };
  return entrant;
}

const std::vector<Case>& campaign_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> list;
    for (const auto& test : proof::test_problems()) list.push_back(on_test_problem(test.id, test));
    list.push_back(on_test_problem("second_order", proof::separable_test_problems()[1]));
    list.back().tags.emplace_back("second_order");
    list.push_back(make_case("stiff", std::make_shared<const Kaps>(), 0, 2,
                             at_start(Kaps::dimension, kaps_truth), kaps_truth));
    list.push_back(make_case("larger", std::make_shared<const Ring>(), 0, 2,
                             at_start(Ring::dimension, ring_truth), ring_truth));
    list.back().settings.finest_steps = 512;  // its Jacobians by differences are dear
    list.push_back(make_case("kepler", std::make_shared<const Kepler>(), 0, 6,
                             at_start(Kepler::dimension, kepler_truth), kepler_truth));
    list.back().tags.emplace_back("second_order");
    list.push_back(make_case("relaxation", std::make_shared<const Relaxation>(), 0, 2,
                             at_start(Relaxation::dimension, relaxation_truth), relaxation_truth));
    return list;
  }();
  return cases;
}

}  // namespace odeum::tests
