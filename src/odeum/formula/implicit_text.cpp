// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

#include "odeum/formula/printer.hpp"
#include "odeum/formula/reduction.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::formula {
namespace {

/// An entry of dR/dy, or of dR/dy'.
struct EntryPlace {
  std::size_t at;
  bool by_rate;
};

/// R and the entries of its derivatives.
class TextResiduals {
 public:
  explicit TextResiduals(const Problem& problem)
      : graph_(problem.graph), residuals_(problem.residuals), n_(problem.states.size()) {
    const auto gradient = gradients(graph_, residuals_, 2 * first_rate);
    for (std::size_t row = 0; row < n_; ++row)
      for (const Entry& entry : gradient[row]) {
        if (entry.by == 2 * first_rate) continue;  // the time
        const bool by_rate = entry.by >= first_rate;
        places_.push_back({row * n_ + entry.by - (by_rate ? first_rate : 0), by_rate});
        entries_.push_back(entry.value);
      }
    Printer out(graph_);
    out.line("/* R(t, y, y') with {} states, printed from a graph of operations */", n_);
    print(out, "residual", residuals_);
    print(out, "residual_entries", entries_);
    library_ = compile_c(out.text).library;
    if (library_) {
      residual_ = library_->function<Call>("residual");
      call_entries_ = library_->function<Call>("residual_entries");
    } else {
      interpreted_ = {make(residuals_), make(entries_)};
    }
  }

  void residual(double t, const double* y, const double* rates, double* r) const {
    if (residual_) return residual_(nullptr, t, y, rates, r);
    interpret(*interpreted_.first, t, y, rates, r);
  }
  void matrix(double t, const double* y, const double* rates, double alpha, double* j) const {
    thread_local std::vector<double> values;
    values.resize(entries_.size());
    if (call_entries_)
      call_entries_(nullptr, t, y, rates, values.data());
    else
      interpret(*interpreted_.second, t, y, rates, values.data());
    std::fill(j, j + n_ * n_, 0.);
    for (std::size_t k = 0; k < places_.size(); ++k)
      j[places_[k].at] += places_[k].by_rate ? alpha * values[k] : values[k];
  }

 private:
  using Call = void (*)(const void*, double t, const double* y, const double* rates, double* out);
  using Values = std::shared_ptr<const Evaluator<double>>;

  static void print(Printer& out, const char* name, const std::vector<Id>& roots) {
    const Function function{.name = name,
                            .arguments =
                                "const void* problem, double t, const double* y, const double* v, "
                                "double* __restrict f",
                            .passed = "problem, t, y, v, f",
                            .target = "f",
                            .first = "y",
                            .second = "v",
                            .split = first_rate};
    print_values(out, function, roots, in_order(roots.size()), in_double);
  }
  /// Makes the values of roots, with the rates after the states.
  Values make(const std::vector<Id>& roots) {
    std::map<std::uint32_t, Id> after;
    const auto n = static_cast<std::uint32_t>(n_);
    for (std::uint32_t k = 0; k < n; ++k) after[first_rate + k] = graph_.state(n + k);
    const std::vector<Id> replaced = with_states_replaced(graph_, roots, after);
    return std::make_shared<const Evaluator<double>>(graph_, replaced);
  }
  void interpret(const Evaluator<double>& values, double t, const double* y, const double* rates,
                 double* out) const {
    std::vector<double> both(y, y + n_);
    both.insert(both.end(), rates, rates + n_);
    values(t, both.data(), out);
  }

  Graph graph_;
  std::vector<Id> residuals_, entries_;
  std::size_t n_;
  std::vector<EntryPlace> places_;
  std::shared_ptr<const Library> library_;
  Call residual_ = nullptr, call_entries_ = nullptr;
  std::pair<Values, Values> interpreted_;
};

/// Made, and compiled, when a solver first asks for them: most solvers take the equations.
class LateResiduals {
 public:
  explicit LateResiduals(const Problem& problem) : problem_(problem) {}
  const TextResiduals& get() const {
    std::call_once(once_, [this] { made_.emplace(problem_); });
    return *made_;
  }

 private:
  Problem problem_;
  mutable std::once_flag once_;
  mutable std::optional<TextResiduals> made_;
};

}  // namespace

std::shared_ptr<const ImplicitForm> implicit_form(const Problem& problem) {
  if (problem.residuals.empty()) return nullptr;
  const auto text = std::make_shared<const LateResiduals>(problem);
  return std::make_shared<const ImplicitForm>(
      ImplicitForm{.dimension = problem.states.size(),
                   .residual = [text](double t, const double* y, const double* rates,
                                      double* r) { text->get().residual(t, y, rates, r); },
                   .matrix = [text](double t, const double* y, const double* rates, double alpha,
                                    double* j) { text->get().matrix(t, y, rates, alpha, j); },
                   .constraints = constraints_of(problem),
                   .index = problem.index,
                   .indices = problem.indices});
}

}  // namespace odeum::formula
