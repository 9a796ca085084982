// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/candidate.hpp"

#include <cmath>

#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shared.hpp"
#include "odeum/proof/facts.hpp"

namespace odeum::brought {
namespace {

/// df/dt by central differences, with the cube root of rounding, where they are best.
void time_derivative(const OdeView& view, double t, const double* y, double* out) {
  constexpr double part = 6e-6;
  const std::size_t n = view.dimension;
  std::vector<double> above(n);
  const double width = part * std::max(std::abs(t), 1e-3);
  view.rhs(view.problem, t + width, y, above.data());
  view.rhs(view.problem, t - width, y, out);
  for (std::size_t i = 0; i < n; ++i) out[i] = (above[i] - out[i]) / (2 * width);
}

template <class Mechanics>
void fill(Mechanics& mechanics, const SharedOde& shared, const OdeView& view) {
  mechanics.unknowns = view.dimension;
  mechanics.f = [view](double t, const double* y, double* f) { view.rhs(view.problem, t, y, f); };
  mechanics.f_y = [shared](double t, const double* y, double* j) {
    jacobian_or_differences(shared, t, y, j);
  };
  mechanics.f_t = [view](double t, const double* y, double* f) { time_derivative(view, t, y, f); };
  mechanics.a = [view](double t, const double* q, const double* v, double* a) {
    const std::size_t n = view.dimension / 2;
    std::vector<double> y(q, q + n), f(2 * n);
    y.insert(y.end(), v, v + n);
    view.rhs(view.problem, t, y.data(), f.data());
    std::copy(f.begin() + static_cast<std::ptrdiff_t>(n), f.end(), a);
  };
}

std::unique_ptr<proof::AnyStepper> stepper_on(const proof::Code& code, const Problem& problem) {
  if (code.on_problem) return code.on_problem(problem.first_order());
  if (code.on_second_order && problem.second_order())
    return code.on_second_order(*problem.second_order());
  if (code.on_separable && problem.separable()) return code.on_separable(*problem.separable());
  return nullptr;
}

Candidate of_method(const proof::MethodFacts& facts) {
  return one_step(facts.id(), "", facts.info.order,
                  [&facts](const Problem& problem, double t, double h, std::vector<double>& y) {
                    const auto stepper = stepper_on(facts, problem);
                    if (!stepper) return false;
                    stepper->start(t, h, y);
                    return stepper->step(t, h, y) == Status::ok;
                  });
}

}  // namespace

Problem::Problem(const Case& c) : view_(c.problem.view) {
  const SharedOde shared{c.problem.view, c.problem.keep_alive};
  fill(mechanics_, shared, view_);
  of_second_order_ = view_.second_order() && 2 * view_.degrees_of_freedom == view_.dimension;
  if (!of_second_order_ || view_.velocity_dependent) return;
  separable_ = std::make_unique<FunctionMechanics<false>>();
  fill(*separable_, shared, view_);
}

Candidate one_step(std::string method, std::string mistake, double order, Step step) {
  Candidate candidate{std::move(method), std::move(mistake), order, 1, {}};
  candidate.defect = [step = std::move(step)](const Problem& problem, const Rows& rows,
                                              double* defect) {
    const std::size_t n = problem.size();
    std::vector<double> y(rows.y[0], rows.y[0] + n);
    for (std::size_t k = 0; k < rows.steps_a_row; ++k)
      if (!step(problem, rows.t + static_cast<double>(k) * rows.h, rows.h, y)) return false;
    for (std::size_t i = 0; i < n; ++i) defect[i] = rows.y[1][i] - y[i];
    return true;
  };
  return candidate;
}

Candidate of_tableau(std::string method, std::string mistake, DynamicTableau<double> tableau) {
  const double order = tableau.order;
  return one_step(std::move(method), std::move(mistake), order,
                  [tableau = std::move(tableau)](const Problem& problem, double t, double h,
                                                 std::vector<double>& y) {
                    return TableauInterpreter(tableau, problem.first_order()).step(t, h, y) ==
                           Status::ok;
                  });
}

Candidate multistep(std::string method, std::string mistake, double order,
                    std::vector<double> alpha, std::vector<double> beta) {
  Candidate candidate{std::move(method), std::move(mistake), order, alpha.size() - 1, {}};
  candidate.defect = [alpha, beta](const Problem& problem, const Rows& rows, double* defect) {
    if (rows.steps_a_row != 1) return false;
    const std::size_t n = problem.size();
    std::vector<double> f(n);
    std::fill(defect, defect + n, 0.0);
    for (std::size_t j = 0; j < alpha.size(); ++j) {
      if (beta[j] != 0)
        problem.first_order().rhs(rows.t + static_cast<double>(j) * rows.h, rows.y[j], f.data());
      for (std::size_t i = 0; i < n; ++i)
        defect[i] += alpha[j] * rows.y[j][i] - (beta[j] != 0 ? rows.h * beta[j] * f[i] : 0);
    }
    return true;
  };
  return candidate;
}

std::vector<Candidate> known_methods() {
  std::vector<Candidate> candidates;
  for (const proof::MethodFacts& facts : proof::all_method_facts())
    if (!facts.recurrence) candidates.push_back(of_method(facts));
  candidates.push_back(multistep("adams_bashforth2", "", 2, {0, -1, 1}, {-0.5, 1.5, 0}));
  candidates.push_back(
      multistep("adams_bashforth3", "", 3, {0, 0, -1, 1}, {5. / 12, -16. / 12, 23. / 12, 0}));
  candidates.push_back(multistep("adams_bashforth4", "", 4, {0, 0, 0, -1, 1},
                                 {-9. / 24, 37. / 24, -59. / 24, 55. / 24, 0}));
  candidates.push_back(multistep("bdf2", "", 2, {0.5, -2, 1.5}, {0, 0, 1}));
  candidates.push_back(
      multistep("the explicit midpoint rule over two steps", "", 2, {-1, 0, 1}, {0, 2, 0}));
  return candidates;
}

}  // namespace odeum::brought
