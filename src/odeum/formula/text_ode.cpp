// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/text_ode.hpp"

#include <algorithm>

#include "odeum/formula/exact.hpp"
#include "odeum/formula/finite_entries.hpp"

namespace odeum::formula {
namespace {

Sparsity sparsity_of(const Analysis& analysis) {
  Sparsity sparsity;
  for (const auto& row : analysis.jacobian) {
    std::vector<int> columns;
    for (const Entry& entry : row) columns.push_back(static_cast<int>(entry.by));
    sparsity.add_row(columns);
  }
  return sparsity;
}

/// The exact propagator's matrix is dense.
constexpr std::size_t most_linear_states = 256;

}  // namespace

/// The functions of the view by evaluation of the graph.
struct TextOde::Interpreted {
  Evaluator<double> rhs, entries, time_derivative, explicit_part, implicit_part;
  Evaluator<long double> extended_rhs, extended_entries;

  Interpreted(const Problem& problem, const Analysis& analysis)
      : rhs(problem.graph, problem.equations),
        entries(problem.graph, jacobian_roots(analysis)),
        time_derivative(problem.graph, analysis.time_derivative),
        explicit_part(problem.graph, problem.explicit_part),
        implicit_part(problem.graph, problem.implicit_part),
        extended_rhs(problem.graph, problem.equations),
        extended_entries(problem.graph, jacobian_roots(analysis)) {}
};

/// One of them as a function of the view.
template <auto values, class Real>
void TextOde::interpreted(const void* handle, Real t, const Real* y, Real* out) {
  ((*of(handle).interpreted_).*values)(t, y, out);
}

TextOde::TextOde(Problem problem, Code code)
    : problem_(std::move(problem)),
      analysis_(analyse(problem_)),
      sparsity_(sparsity_of(analysis_)) {
  view_.problem = &handle_;
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
  offer_derivatives();
  view_.jacobian_times = [](const void* p, double t, const double* y, const double* x,
                            double* product) {
    const auto& self = of(p);
    multiply(self.sparsity_, self.entries(t, y).data(), x, product);
  };
  if (s.linear && s.autonomous && s.states <= most_linear_states)
    view_.linear_matrix = [](const void* p, double* a) {
      const auto& self = of(p);
      const std::vector<double> zero(self.size());
      self.view_.jacobian(p, 0, zero.data(), a);
    };
}

/// Where all operations have finite derivatives, the functions are those that compute.
void TextOde::offer_derivatives() {
  const bool steep = analysis_.structure.steep;
  const auto offered = [steep](Function<double> raw, Function<double> mended) {
    return steep && raw ? mended : raw;
  };
  if (analysis_.structure.is_sparse()) {
    view_.sparsity = &sparsity_;
    view_.jacobian_entries = offered(raw_.entries, call<&TextOde::fill_entries>);
  }
  view_.jacobian = steep || !raw_.jacobian ? call<&TextOde::fill_jacobian> : raw_.jacobian;
  view_.implicit_jacobian = offered(raw_.implicit_jacobian, call<&TextOde::fill_implicit_jacobian>);
  view_.time_derivative = offered(raw_.time_derivative, call<&TextOde::fill_time_derivative>);
}

void TextOde::use(const Library& library) {
  view_.rhs = library.function<decltype(view_.rhs)>("rhs");
  raw_ = {.jacobian = library.function<Function<double>>("jacobian"),
          .entries = library.function<Function<double>>("jacobian_entries"),
          .implicit_jacobian = library.function<Function<double>>("implicit_jacobian"),
          .time_derivative = library.function<Function<double>>("time_derivative"),
          .extended_rhs = library.function<Function<long double>>("rhs_extended"),
          .extended_entries = library.function<Function<long double>>("entries_extended")};
  view_.acceleration = library.function<decltype(view_.acceleration)>("acceleration");
  view_.taylor = library.function<decltype(view_.taylor)>("taylor");
  view_.explicit_part = library.function<decltype(view_.explicit_part)>("explicit_part");
  view_.implicit_part = library.function<decltype(view_.implicit_part)>("implicit_part");
}

void TextOde::interpret() {
  interpreted_ = std::make_shared<const Interpreted>(problem_, analysis_);
  view_.rhs = interpreted<&Interpreted::rhs>;
  raw_.entries = interpreted<&Interpreted::entries>;
  if (!analysis_.time_derivative.empty())
    raw_.time_derivative = interpreted<&Interpreted::time_derivative>;
  if (!problem_.implicit_part.empty()) {
    view_.explicit_part = interpreted<&Interpreted::explicit_part>;
    view_.implicit_part = interpreted<&Interpreted::implicit_part>;
  }
  if (analysis_.structure.second_order)
    view_.acceleration = [](const void* p, double t, const double* q, const double* v, double* a) {
      const auto& self = of(p);
      const std::size_t half = self.size() / 2;
      std::vector<double> y(q, q + half), f(2 * half);
      y.insert(y.end(), v, v + half);
      self.interpreted_->rhs(t, y.data(), f.data());
      std::copy(f.begin() + static_cast<std::ptrdiff_t>(half), f.end(), a);
    };
  if (analysis_.series)
    view_.taylor = [](const void* p, double t, const double* y, int order, double* c) {
      const auto& self = of(p);
      Series<double>(self.problem_.graph, *self.analysis_.series, self.size())(t, y, order, c);
    };
  raw_.extended_rhs = interpreted<&Interpreted::extended_rhs>;
  raw_.extended_entries = interpreted<&Interpreted::extended_entries>;
}

bool TextOde::set_parameters(const std::map<std::string, long double>& values) {
  if (!library_) return false;
  const Graph& graph = problem_.graph;
  const std::vector<long double> known = definitions_of(graph, values);
  constants_.assign(known.begin(), known.end());
  handle_.constants = constants_.data();
  std::transform(problem_.start.begin(), problem_.start.end(), problem_.y0.begin(), [&](Id id) {
    return graph.is_number(id) ? graph[id].value : known[graph[id].index - 1];
  });
  problem_.parameters = values;
  return true;
}

void TextOde::jacobian_extended(long double t, const long double* y, long double* j) const {
  std::vector<long double> values(sparsity_.entries());
  entries_extended(t, y, values.data());
  fill_dense(sparsity_, values.data(), j);
}

std::vector<double> TextOde::entries(double t, const double* y) const {
  std::vector<double> values(sparsity_.entries());
  fill_entries(t, y, values.data());
  return values;
}

void TextOde::fill_entries(double t, const double* y, double* values) const {
  raw_.entries(&handle_, t, y, values);
  if (analysis_.structure.steep && !all_finite(values, sparsity_.entries()))
    FiniteEntries<double>(sparsity_, &handle_, view_.rhs, raw_.entries).mend(t, y, values);
}

void TextOde::entries_extended(long double t, const long double* y, long double* values) const {
  raw_.extended_entries(&handle_, t, y, values);
  if (analysis_.structure.steep && !all_finite(values, sparsity_.entries()))
    FiniteEntries<long double>(sparsity_, &handle_, raw_.extended_rhs, raw_.extended_entries)
        .mend(t, y, values);
}

void TextOde::fill_jacobian(double t, const double* y, double* j) const {
  if (raw_.jacobian) {
    raw_.jacobian(&handle_, t, y, j);
    if (all_finite(j, size() * size())) return;
  }
  fill_dense(sparsity_, entries(t, y).data(), j);
}

void TextOde::fill_implicit_jacobian(double t, const double* y, double* j) const {
  const std::size_t n = size();
  raw_.implicit_jacobian(&handle_, t, y, j);
  if (all_finite(j, n * n)) return;
  FiniteEntries<double>(banded_sparsity(n, n, n), &handle_, view_.implicit_part,
                        raw_.implicit_jacobian)
      .mend(t, y, j);
}

void TextOde::fill_time_derivative(double t, const double* y, double* dfdt) const {
  raw_.time_derivative(&handle_, t, y, dfdt);
  if (all_finite(dfdt, size())) return;
  const double span = problem_.stops.back() - static_cast<double>(problem_.t0);
  mend_time_derivative([&](double at, double* f) { rhs(at, y, f); }, t, span, size(), dfdt);
}

}  // namespace odeum::formula
