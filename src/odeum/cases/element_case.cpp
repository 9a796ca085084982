// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/element_case.hpp"

#include <algorithm>

#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

using System = std::shared_ptr<const fem::SemiDiscrete>;

void dense_operator(const fem::SemiDiscrete& system, double* a) {
  if (system.lumped) return fill_dense(system.pattern, system.entries.data(), a);
  std::ranges::copy(system.operator_matrix, a);
}

/// M u' = -K u + f.
struct Heat {
  static constexpr std::size_t dimension = dynamic;
  System system;

  std::size_t size() const { return system->size(); }
  void rhs(double, const double* u, double* dudt) const { system->rate(u, dudt); }
  void jacobian(double, const double*, double* j) const { linear_matrix(j); }
  void jacobian_times(double, const double*, const double* x, double* product) const {
    system->rate(x, product);
    for (std::size_t i = 0; i < size(); ++i) product[i] -= system->source[i];
  }
  void linear_matrix(double* a) const { dense_operator(*system, a); }
  const Sparsity* sparsity() const { return system->lumped ? &system->pattern : nullptr; }
  void jacobian_entries(double, const double*, double* values) const {
    std::ranges::copy(system->entries, values);
  }
  std::unique_ptr<ShiftedSolver> shifted_solver() const { return fem::heat_solver(*system); }
};

/// M u'' = -K u.
struct Wave {
  static constexpr std::size_t dimension = dynamic;
  static constexpr bool velocity_dependent = false;
  System system;
  Sparsity pattern;  // of [0, I; -M^-1 K, 0], where M is lumped

  explicit Wave(System given) : system(std::move(given)) {
    if (!system->lumped) return;
    const auto n = static_cast<int>(system->size());
    for (int i = 0; i < n; ++i) pattern.add_row({n + i});
    const Sparsity& of = system->pattern;
    for (int i = 0; i < n; ++i)
      pattern.add_row({of.column.begin() + of.start[i], of.column.begin() + of.start[i + 1]});
  }
  std::size_t size() const { return 2 * system->size(); }
  void acceleration(double, const double* q, const double*, double* a) const { system->rate(q, a); }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, system->size(), t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const { linear_matrix(j); }
  void jacobian_times(double t, const double*, const double* x, double* product) const {
    rhs(t, x, product);
  }
  void linear_matrix(double* a) const {
    const std::size_t n = system->size(), all = 2 * n;
    std::vector<double> block(n * n);
    dense_operator(*system, block.data());
    std::fill(a, a + all * all, 0);
    for (std::size_t i = 0; i < n; ++i) {
      a[i * all + n + i] = 1;
      std::copy_n(block.data() + i * n, n, a + (n + i) * all);
    }
  }
  const Sparsity* sparsity() const { return system->lumped ? &pattern : nullptr; }
  void jacobian_entries(double, const double*, double* values) const {
    std::fill_n(values, system->size(), 1);
    std::ranges::copy(system->entries, values + system->size());
  }
  std::unique_ptr<ShiftedSolver> shifted_solver() const { return fem::wave_solver(*system); }
  double energy(const double* y) const {
    const std::size_t n = system->size();
    std::vector<double> product(n);
    double sum = 0;
    system->mass.multiply(y + n, product.data());
    for (std::size_t i = 0; i < n; ++i) sum += y[n + i] * product[i] / 2;
    system->stiffness.multiply(y, product.data());
    for (std::size_t i = 0; i < n; ++i) sum += y[i] * product[i] / 2;
    return sum;
  }
};

}  // namespace

void set_heat_stage(Case& c, System system) { set_problem(c, Heat{std::move(system)}); }
void set_wave_stage(Case& c, System system) { set_problem(c, Wave(std::move(system))); }

}  // namespace odeum::cases
