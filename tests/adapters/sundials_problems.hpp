// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sundials/solvers.hpp"
#include "support/enrolled.hpp"

/// Small problems with closed forms, and the adapter's solvers on them.
namespace odeum::sundials_tests {

/// y' = -2 t y^2, z' = y: nonlinear, coupled and non-autonomous. From (1, 0): 1/(1+t^2), atan t.
struct Witch {
  static constexpr std::size_t dimension = 2;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = -2 * t * y[0] * y[0];
    dydt[1] = y[0];
  }
  void jacobian(double t, const double* y, double* j) const {
    j[0] = -4 * t * y[0];
    j[1] = j[3] = 0;
    j[2] = 1;
  }
  void explicit_part(double, const double* y, double* f) const {
    f[0] = 0;
    f[1] = y[0] / 4;
  }
  void implicit_part(double t, const double* y, double* f) const {
    f[0] = -2 * t * y[0] * y[0];
    f[1] = 3 * y[0] / 4;
  }
  void implicit_jacobian(double t, const double* y, double* j) const {
    jacobian(t, y, j);
    j[2] = 0.75;
  }
  static double error(double t, const double* y) {
    return std::hypot(y[0] - 1 / (1 + t * t), y[1] - std::atan(t));
  }
};

/// The same without its Jacobian.
struct WitchWithoutJacobian {
  static constexpr std::size_t dimension = 2;
  void rhs(double t, const double* y, double* dydt) const { Witch{}.rhs(t, y, dydt); }
  void explicit_part(double t, const double* y, double* f) const { Witch{}.explicit_part(t, y, f); }
  void implicit_part(double t, const double* y, double* f) const { Witch{}.implicit_part(t, y, f); }
};

/// y' = y^2 from 1: 1/(1-t), a pole at t = 1.
struct Pole {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = y[0] * y[0]; }
  void jacobian(double, const double* y, double* j) const { j[0] = 2 * y[0]; }
};

/// y' = -y, whose right-hand side is NaN from t = 0.5 on.
struct NanLater {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = t < 0.5 ? -y[0] : std::numeric_limits<double>::quiet_NaN();
  }
  void jacobian(double, const double*, double* j) const { j[0] = -1; }
};

/// y' = i omega y on (Re, Im), from (1, 0).
struct Rotation {
  static constexpr std::size_t dimension = 2;
  static constexpr double omega = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = -omega * y[1];
    dydt[1] = omega * y[0];
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = j[3] = 0;
    j[1] = -omega;
    j[2] = omega;
  }
  static double error(double t, const double* y) {
    return std::hypot(y[0] - std::cos(omega * t), y[1] - std::sin(omega * t));
  }
};

/// y_i' = -k_i y_i from 1, with k_i from 1 to 200, and only Jacobian-vector products.
struct ManyDecays {
  static constexpr std::size_t dimension = dynamic;
  std::size_t n = 200;
  std::size_t size() const { return n; }
  static double rate(std::size_t i) { return static_cast<double>(i + 1); }
  void rhs(double, const double* y, double* dydt) const {
    for (std::size_t i = 0; i < n; ++i) dydt[i] = -rate(i) * y[i];
  }
  void jacobian_times(double, const double*, const double* x, double* product) const {
    rhs(0, x, product);
  }
};

/// The adapter's solvers on a problem but for IDA, which takes residuals (sundials_ida_test.cpp),
/// and for additive ones where it has no parts.
template <Ode P>
std::vector<Entrant> entrants(std::vector<double> y0, P problem = {}, double t0 = 0) {
  Contest<P> contest;
  contest.t0 = t0;
  contest.problem = std::make_shared<const P>(std::move(problem));
  contest.y0 = std::make_shared<const std::vector<double>>(std::move(y0));
  auto all = tests::enrolled_on(erase(contest), adapters::sundials::add_solvers);
  std::erase_if(all, [](const Entrant& entrant) {
    return entrant.info.library == "ida" || (!Split<P> && entrant.info.family == "imex_rk");
  });
  return all;
}

inline const Entrant& find(const std::vector<Entrant>& list, const std::string& id) {
  for (const Entrant& entrant : list)
    if (entrant.info.id() == id) return entrant;
  throw std::runtime_error("no solver " + id);
}

inline Request fixed(std::uint64_t steps, std::vector<double> stops) {
  Request request;
  request.steps = steps;
  request.stops = std::move(stops);
  return request;
}

inline Request adaptive(double tolerance, std::vector<double> stops) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = std::move(stops);
  return request;
}

/// One solver of each kind: variable and held multistep, both explicit steppers, implicit.
inline const std::array<std::string, 7> one_of_each{"cvode/adams",
                                                    "cvode/bdf",
                                                    "cvode/adams_held_1",
                                                    "cvode/bdf_held_1",
                                                    "arkode/erkstep_dormand_prince_7_4_5",
                                                    "arkode/arkstep_dormand_prince_7_4_5",
                                                    "arkode/arkstep_sdirk_5_3_4"};

/// A request in the mode that the solver has.
inline Request any_request(const SolverInfo& info, std::vector<double> stops) {
  return info.fixed ? fixed(200, std::move(stops)) : adaptive(1e-6, std::move(stops));
}

}  // namespace odeum::sundials_tests
