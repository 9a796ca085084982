// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "odeum/studies/evolution/field.hpp"
#include "odeum/studies/evolution/rows.hpp"

namespace odeum::study {
namespace {

using std::numbers::pi;

const char* name_of(fem::Mass mass) { return mass == fem::Mass::lumped ? "lumped" : "consistent"; }
double jump(fem::Point p) { return p.x < 0.5 && p.y < 0.5 ? 1. : 0.; }

double inner(const linear::SparseMatrix& mass, const double* a, const double* b) {
  std::vector<double> product(static_cast<std::size_t>(mass.rows));
  mass.multiply(b, product.data());
  double sum = 0;
  for (std::size_t i = 0; i < product.size(); ++i) sum += a[i] * product[i];
  return sum;
}

/// Stability functions (Hairer and Wanner, Solving ODEs II, IV.3 and IV.5; Bank et al., IEEE Trans.
/// CAD 4 (1985) 436-451).
double stability(const std::string& solver, double z) {
  if (solver == "odeum/implicit_euler") return 1 / (1 - z);
  if (solver == "odeum/trapezoidal") return (1 + z / 2) / (1 - z / 2);
  if (solver == "odeum/tr_bdf2") {
    const double g = 2 - std::numbers::sqrt2;
    return ((1 + (1 - g) * (1 - g)) * z + 2 * (2 - g)) /
           (z * z * (1 - g) * g + z * (g * g - 2) + 2 * (2 - g));
  }
  return (1 + 2 * z / 5 + z * z / 20) / (1 - 3 * z / 5 + 3 * z * z / 20 - z * z * z / 60);
}

/// The fastest mode of a jump, at steps far beyond its time.
void add_rough(EvolutionResult& result) {
  constexpr std::size_t steps = rough_steps;
  constexpr double z = 50;
  for (const fem::Mass mass : {fem::Mass::lumped, fem::Mass::consistent}) {
    const Field field(false, 8, mass, true, jump);
    const linear::Modes& modes = *field.system().modes;
    const double end = z * steps / static_cast<double>(modes.values.back());
    const std::vector<double> top(modes.vectors.back().begin(), modes.vectors.back().end());
    const double before = inner(field.system().mass, top.data(), field.start().data());
    for (const char* solver :
         {"odeum/implicit_euler", "odeum/trapezoidal", "odeum/tr_bdf2", "odeum/radau_iia5"}) {
      EvolutionModeRow& row = result.modes.emplace_back();
      row.problem = "heat", row.mass = name_of(mass), row.solver = solver;
      row.quantity = "factor", row.step = z;
      row.predicted = std::pow(stability(solver, -z), steps);
      const std::vector<double> u = field.after(solver, end, steps);
      if (!u.empty()) row.measured = inner(field.system().mass, top.data(), u.data()) / before;
    }
  }
}

/// The angle by which one step turns a wave of k half waves each way, against that of the equation:
/// by elements with lumped mass, leapfrog is too fast and the elements too slow.
void add_dispersion(EvolutionResult& result) {
  constexpr std::size_t n = wave_divisions;
  for (std::size_t k = 1; k < n; k *= 2) {
    const auto waves = static_cast<double>(k);
    const Field field(true, n, fem::Mass::lumped, false, [=](fem::Point p) {
      return std::sin(waves * pi * p.x) * std::sin(waves * pi * p.y);
    });
    const double sine = std::sin(waves * pi / (2 * n)), frequency = std::sqrt(8.) * n * sine;
    // 0.9 of what leapfrog's limit allows.
    const double dt = 1.8 / (std::sqrt(8.) * n * std::cos(pi / (2 * n)));
    for (const char* solver : {"odeum/velocity_verlet", "odeum/trapezoidal"}) {
      EvolutionModeRow& row = result.modes.emplace_back();
      row.problem = "wave", row.mass = "lumped", row.solver = solver;
      row.quantity = "speed", row.waves = k;
      const double exact = std::numbers::sqrt2 * pi * waves * dt, half = frequency * dt / 2;
      row.step = exact;
      row.predicted =
          2 * (solver == std::string("odeum/trapezoidal") ? std::atan(half) : std::asin(half)) /
          exact;
      const std::vector<double> u = field.after(solver, dt, 1);
      if (u.empty()) continue;
      const double* const start = field.start().data();
      const linear::SparseMatrix& mass = field.system().mass;
      row.measured = std::acos(inner(mass, start, u.data()) / inner(mass, start, start)) / exact;
    }
  }
}

/// Whether a jump grows in 2000 steps.
bool grows(const Field& field, const char* solver, double dt) {
  const std::vector<double> u = field.after(solver, 2000 * dt, 2000);
  if (u.empty()) return true;
  for (std::size_t i = 0; i < field.system().size(); ++i)
    if (!(std::abs(u[i]) < 10)) return true;
  return false;
}

void add_limits(EvolutionResult& result) {
  for (const bool wave : {false, true})
    for (const fem::Mass mass : {fem::Mass::lumped, fem::Mass::consistent}) {
      if (interrupted) throw Interrupted();
      const Field field(wave, 8, mass, true, jump);
      EvolutionLimitRow& row = result.limits.emplace_back();
      row.problem = wave ? "wave" : "heat", row.mass = name_of(mass);
      row.solver = wave ? "odeum/velocity_verlet" : "odeum/explicit_euler";
      const auto highest = static_cast<double>(field.system().modes->values.back());
      row.predicted = 2 / (wave ? std::sqrt(highest) : highest);
      double low = row.predicted / 2, high = row.predicted * 2;
      while (high / low > 1.0001) {
        const double middle = std::sqrt(low * high);
        (grows(field, row.solver.c_str(), middle) ? high : low) = middle;
      }
      row.measured = std::sqrt(low * high);
    }
}

}  // namespace

EvolutionResult measure_modes() {
  EvolutionResult result;
  add_rough(result);
  add_dispersion(result);
  add_limits(result);
  return result;
}

}  // namespace odeum::study
