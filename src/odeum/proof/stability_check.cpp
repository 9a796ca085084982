// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/stability_check.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "odeum/core/numbers.hpp"
#include "odeum/linear/eigenvalues.hpp"
#include "odeum/proof/test_problems.hpp"
#include "odeum/tableau/character.hpp"

namespace odeum::proof {
namespace {

constexpr int points = 64;

FunctionProblem dahlquist(std::complex<double> z) {
  FunctionProblem p;
  p.unknowns = 2;
  p.f = [z](double, const double* y, double* f) {
    f[0] = z.real() * y[0] - z.imag() * y[1];
    f[1] = z.imag() * y[0] + z.real() * y[1];
  };
  p.f_y = [z](double, const double*, double* j) {
    j[0] = j[3] = z.real();
    j[1] = -z.imag();
    j[2] = z.imag();
  };
  p.f_t = [](double, const double*, double* d) { d[0] = d[1] = 0; };
  return p;
}

FunctionMechanics<false> oscillator(double w) {
  return mechanics<false>(
      1, {.a = [w](double, const double* q, const double*, double* a) { a[0] = -w * w * q[0]; },
          .a_q = [w](double, const double*, const double*, double* a) { a[0] = -w * w; }});
}

void note(StabilityAgreement& found, double difference) {
  ++found.points;
  if (!(difference <= found.difference)) found.difference = difference;  // NaN stays as the largest
}

/// One step at h = 1 of y' = z y from y = 1, as the code computes it; NaN where it fails.
std::complex<double> running_growth(const MakeStepper<FunctionProblem>& make,
                                    std::complex<double> z) {
  const FunctionProblem problem = dahlquist(z);
  const auto stepper = make(problem);
  std::vector<double> y{1, 0};
  stepper->start(0, 1, y);
  if (stepper->step(0, 1, y) != Status::ok) return {nan, nan};
  return {y[0], y[1]};
}

}  // namespace

StabilityAgreement compare_stability(const MakeStepper<FunctionProblem>& make,
                                     const MethodFacts& theory) {
  StabilityAgreement found;
  if (!theory.tableau && !theory.amplification) return found;
  const bool polynomial = theory.tableau && theory.tableau->is_explicit();
  std::mt19937 random(20);
  std::uniform_real_distribution<double> near_re(-3, 0.5), imaginary(-3, 3), size(0, 3);
  for (int i = 0; i < points; ++i) {
    std::complex<double> z{near_re(random), imaginary(random)};
    // To |z| = 1000 for methods of stiff problems.
    if (i % 2 == 1 && !polynomial)
      z = {-std::pow(10, size(random)), imaginary(random) * std::pow(10, size(random) - 1)};
    const std::complex<double> code = running_growth(make, z);
    if (theory.tableau) {
      const std::complex<double> r = stability_function(*theory.tableau, z);
      note(found, std::abs(code - r) / (1 + std::abs(r)));
      continue;
    }
    const double r = theory.amplification(z.real(), z.imag());
    // Where the code fails, the stability function must be NaN too.
    if (!std::isfinite(r) && !std::isfinite(code.real())) continue;
    note(found, std::abs(std::abs(code) - r) / (1 + r));
  }
  return found;
}

StabilityAgreement compare_recurrence(const MakeStepper<FunctionProblem>& make,
                                      const MethodFacts& theory) {
  StabilityAgreement found;
  if (!theory.recurrence) return found;
  std::mt19937 random(22);
  std::uniform_real_distribution<double> re(-1.5, 0.2), im(-1.5, 1.5);
  for (int i = 0; i < points; ++i) {
    const std::complex<double> z{re(random), im(random)};
    const std::vector<std::complex<double>> c = theory.recurrence(z);
    const FunctionProblem problem = dahlquist(z);
    const auto stepper = make(problem);
    std::vector<double> y{1, 0};
    std::vector<std::complex<double>> states{{1, 0}};  // newest first
    stepper->start(0, 1, y);
    double difference = 0;
    for (std::size_t n = 0; n < c.size() + 4; ++n) {
      if (stepper->step(static_cast<double>(n), 1, y) != Status::ok) return {1, nan};
      const std::complex<double> code(y[0], y[1]);
      if (n + 1 >= c.size()) {
        std::complex<double> expected = 0;
        double size = 1;
        for (std::size_t k = 0; k < c.size(); ++k) {
          expected += c[k] * states[k];
          size += std::abs(c[k] * states[k]);
        }
        const double apart = std::abs(code - expected) / size;
        if (!(apart <= difference)) difference = apart;
      }
      states.insert(states.begin(), code);
    }
    note(found, difference);
  }
  return found;
}

double largest_root(const std::vector<std::complex<double>>& recurrence) {
  const std::size_t k = recurrence.size(), n = 2 * k;
  // The companion matrix, each complex number as a real 2 x 2 block: its eigenvalues and their
  // conjugates.
  std::vector<double> companion(n * n);
  const auto put = [&](std::size_t i, std::size_t j, std::complex<double> c) {
    double* const block = &companion[2 * i * n + 2 * j];
    block[0] = block[n + 1] = c.real();
    block[1] = -c.imag();
    block[n] = c.imag();
  };
  for (std::size_t i = 0; i < k; ++i) {
    put(0, i, recurrence[i]);
    if (i > 0) put(i, i - 1, 1);
  }
  double largest = 0;
  for (const std::complex<double> root : eigenvalues(companion, n))
    largest = std::max(largest, std::abs(root));
  return largest;
}

StabilityAgreement compare_oscillator_map(const MakeStepper<FunctionMechanics<false>>& make,
                                          const MethodFacts& theory) {
  StabilityAgreement found;
  if (!theory.oscillator_map) return found;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> frequency(0.05, 2.5);
  for (int i = 0; i < points; ++i) {
    const double w = frequency(random);
    const OscillatorMap map = theory.oscillator_map(w);
    const FunctionMechanics<false> problem = oscillator(w);
    for (const int column : {0, 1}) {
      std::vector<double> y{column == 0 ? 1 / w : 0, column == 0 ? 0.0 : 1.0};
      const auto stepper = make(problem);
      stepper->start(0, 1, y);
      if (stepper->step(0, 1, y) != Status::ok) y = {nan, nan};
      const double difference =
          std::max(std::abs(w * y[0] - map[column]), std::abs(y[1] - map[2 + column]));
      note(found, difference / (1 + std::abs(map[0]) + std::abs(map[3])));
    }
  }
  return found;
}

double compare_with_tableau(const MakeStepper<FunctionProblem>& make,
                            const DynamicTableau<double>& tableau, bool with_estimate) {
  const TestProblem<FunctionProblem>& test = test_problems().back();
  const auto code = make(test.problem);
  InterpretedStepper theory(tableau, test.problem);
  std::vector<double> y = test.y0, z = y, error, estimate;
  double difference = 0;
  const double h = 0.1;
  const bool estimated = with_estimate && tableau.embedded();
  code->start(0, h, y);
  for (const double t : {0.0, h}) {
    if (code->step(t, h, y, estimated ? &error : nullptr) != Status::ok ||
        theory.step(t, h, z, estimated ? &estimate : nullptr) != Status::ok)
      return nan;
    for (std::size_t i = 0; i < y.size(); ++i) {
      difference = std::max(difference, std::abs(y[i] - z[i]));
      if (!error.empty()) difference = std::max(difference, std::abs(error[i] - estimate[i]));
      if (std::isnan(y[i])) return nan;
    }
  }
  return difference;
}

}  // namespace odeum::proof
