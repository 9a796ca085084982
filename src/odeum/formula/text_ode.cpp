// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/text_ode.hpp"

#include <algorithm>

#include "odeum/formula/print_c.hpp"

namespace odeum::formula {
namespace {

std::vector<Id> jacobian_roots(const Analysis& analysis) {
  std::vector<Id> roots;
  for (const auto& row : analysis.jacobian)
    for (const Entry& entry : row) roots.push_back(entry.value);
  return roots;
}

}  // namespace

/// The functions of the view by evaluation of the graph.
struct TextOde::Interpreted {
  Evaluator<double> rhs, entries, time_derivative;
  Evaluator<long double> extended_rhs, extended_entries;

  Interpreted(const Problem& problem, const Analysis& analysis)
      : rhs(problem.graph, problem.equations),
        entries(problem.graph, jacobian_roots(analysis)),
        time_derivative(problem.graph, analysis.time_derivative),
        extended_rhs(problem.graph, problem.equations),
        extended_entries(problem.graph, jacobian_roots(analysis)) {}

  template <class Real>
  static void fill_jacobian(const Analysis& analysis, const Evaluator<Real>& entries, Real t,
                            const Real* y, Real* j) {
    const std::size_t n = analysis.structure.states;
    std::vector<Real> values(analysis.structure.entries);
    entries(t, y, values.data());
    std::fill(j, j + n * n, Real(0));
    std::size_t at = 0;
    for (std::size_t row = 0; row < n; ++row)
      for (const Entry& entry : analysis.jacobian[row]) j[row * n + entry.by] = values[at++];
  }
};

TextOde::TextOde(Problem problem, Code code)
    : problem_(std::move(problem)), analysis_(analyse(problem_)) {
  view_.problem = this;
  view_.dimension = problem_.states.size();
  const Structure& s = analysis_.structure;
  if (s.second_order) {
    view_.degrees_of_freedom = s.states / 2;
    view_.velocity_dependent = s.velocity_dependent;
  }
  if (code == Code::compiled) {
    Compiled compiled = compile_c(print_c(problem_, analysis_));
    library_ = std::move(compiled.library);
    how_ = library_ ? compiled.how : "interpreted, some ten times slower: " + compiled.how;
  } else {
    how_ = "interpreted, some ten times slower, as asked for";
  }
  if (library_)
    use(*library_);
  else
    interpret();
  if (s.linear && s.autonomous)
    view_.linear_matrix = [](const void* p, double* a) {
      const auto& self = *static_cast<const TextOde*>(p);
      const std::vector<double> zero(self.size());
      self.view_.jacobian(p, 0, zero.data(), a);
    };
}

void TextOde::use(const Library& library) {
  view_.rhs = library.function<decltype(view_.rhs)>("rhs");
  view_.jacobian = library.function<decltype(view_.jacobian)>("jacobian");
  view_.time_derivative = library.function<decltype(view_.time_derivative)>("time_derivative");
  view_.acceleration = library.function<decltype(view_.acceleration)>("acceleration");
  view_.taylor = library.function<decltype(view_.taylor)>("taylor");
  extended_rhs_ = library.function<Extended>("rhs_extended");
  extended_jacobian_ = library.function<Extended>("jacobian_extended");
}

void TextOde::interpret() {
  interpreted_ = std::make_shared<const Interpreted>(problem_, analysis_);
  view_.rhs = [](const void* p, double t, const double* y, double* f) {
    static_cast<const TextOde*>(p)->interpreted_->rhs(t, y, f);
  };
  view_.jacobian = [](const void* p, double t, const double* y, double* j) {
    const auto& self = *static_cast<const TextOde*>(p);
    Interpreted::fill_jacobian(self.analysis_, self.interpreted_->entries, t, y, j);
  };
  if (!analysis_.time_derivative.empty())
    view_.time_derivative = [](const void* p, double t, const double* y, double* d) {
      static_cast<const TextOde*>(p)->interpreted_->time_derivative(t, y, d);
    };
  if (analysis_.structure.second_order)
    view_.acceleration = [](const void* p, double t, const double* q, const double* v, double* a) {
      const auto& self = *static_cast<const TextOde*>(p);
      const std::size_t half = self.size() / 2;
      std::vector<double> y(q, q + half), f(2 * half);
      y.insert(y.end(), v, v + half);
      self.interpreted_->rhs(t, y.data(), f.data());
      std::copy(f.begin() + static_cast<std::ptrdiff_t>(half), f.end(), a);
    };
  if (analysis_.series)
    view_.taylor = [](const void* p, double t, const double* y, int order, double* c) {
      const auto& self = *static_cast<const TextOde*>(p);
      Series<double>(self.problem_.graph, *self.analysis_.series, self.size())(t, y, order, c);
    };
  extended_rhs_ = [](const void* p, long double t, const long double* y, long double* f) {
    static_cast<const TextOde*>(p)->interpreted_->extended_rhs(t, y, f);
  };
  extended_jacobian_ = [](const void* p, long double t, const long double* y, long double* j) {
    const auto& self = *static_cast<const TextOde*>(p);
    Interpreted::fill_jacobian(self.analysis_, self.interpreted_->extended_entries, t, y, j);
  };
}

}  // namespace odeum::formula
