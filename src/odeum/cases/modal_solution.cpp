// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/modal_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/linear/eigenvalues.hpp"
#include "odeum/linear/matrix_exponential.hpp"

namespace odeum::cases {
namespace {

using Real = long double;
using Complex = std::complex<Real>;

/// s^power e^(rate s), with a coefficient for each component.
struct Mode {
  Complex rate;
  int power = 0;
  std::vector<Complex> of = {};
};

/// The modes of eigenvalues, of which those within `apart` are one of their multiplicity.
std::vector<Mode> modes_of(std::vector<std::complex<double>> values, double apart) {
  std::vector<Mode> modes;
  while (!values.empty()) {
    const std::complex<double> first = values.front();
    const auto rest = std::stable_partition(
        values.begin(), values.end(), [&](const auto& z) { return std::abs(z - first) <= apart; });
    Complex mean = 0;
    for (auto z = values.begin(); z != rest; ++z) mean += Complex(z->real(), z->imag());
    const auto times = static_cast<int>(rest - values.begin());
    mean /= static_cast<Real>(times);
    if (std::abs(mean.imag()) <= apart) mean = mean.real();
    if (std::abs(mean) <= apart) mean = 0;
    for (int power = 0; power < times; ++power) modes.push_back({mean, power});
    values.erase(values.begin(), rest);
  }
  return modes;
}

/// Derivative number r of a mode at 0, divided by unit^r.
Complex derivative(const Mode& mode, int r, Real unit) {
  if (r < mode.power) return 0;
  Complex value = 1;
  for (int k = 0; k < mode.power; ++k) value *= static_cast<Real>(r - k) / unit;
  for (int k = mode.power; k < r; ++k) value *= mode.rate / unit;
  return value;
}

/// Gives modes their coefficients from the derivatives M^r z0; those that are rounding become 0.
bool set_coefficients(std::vector<Mode>& modes, const std::vector<double>& m,
                      const std::vector<double>& z0) {
  const std::size_t n = z0.size();
  Real unit = 0;
  for (const Mode& mode : modes) unit = std::max(unit, std::abs(mode.rate));
  if (unit == 0) unit = 1;
  linear::Lu<Complex> derivatives(n);
  std::vector<std::vector<Complex>> b(n, std::vector<Complex>(n));  // by component
  std::vector<Real> z(z0.begin(), z0.end());
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t k = 0; k < n; ++k)
      derivatives.data()[r * n + k] = derivative(modes[k], static_cast<int>(r), unit);
    for (std::size_t i = 0; i < n; ++i) b[i][r] = z[i];
    std::vector<Real> next(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) next[i] += static_cast<Real>(m[i * n + j]) * z[j] / unit;
    z = next;
  }
  if (!derivatives.factorise()) return false;
  for (Mode& mode : modes) mode.of.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    derivatives.solve(b[i].data());
    for (std::size_t k = 0; k < n; ++k) modes[k].of[i] = b[i][k];
  }
  constexpr Real rounding = 1e-13L;
  for (std::size_t i = 0; i < n; ++i) {
    Real largest = 0;
    for (const Mode& mode : modes) largest = std::max(largest, std::abs(mode.of[i]));
    for (Mode& mode : modes)
      if (std::abs(mode.of[i]) <= rounding * largest) mode.of[i] = 0;
  }
  return true;
}

/// The largest difference from e^(M s) z0 at times up to `end`, by the state's size.
double difference(const std::vector<Mode>& modes, const std::vector<double>& m,
                  const std::vector<double>& z0, double end) {
  const std::size_t n = z0.size();
  double largest = 0;
  for (const double part : {0.001, 0.03, 0.3, 0.7, 1.}) {
    const double s = part * end;
    std::vector<double> scaled = m;
    for (double& x : scaled) x *= s;
    const std::vector<double> flow = linear::matrix_exponential(scaled, n);
    if (flow.empty()) return HUGE_VAL;
    double size = 0, off = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double exact = 0;
      for (std::size_t j = 0; j < n; ++j) exact += flow[i * n + j] * z0[j];
      Complex sum = 0;
      for (const Mode& mode : modes)
        sum += mode.of[i] * std::pow(static_cast<Real>(s), mode.power) *
               std::exp(mode.rate * static_cast<Real>(s));
      size = std::max({size, std::abs(exact), std::abs(z0[i])});
      off = std::max(off, std::abs(static_cast<double>(sum.real()) - exact));
    }
    largest = std::max(largest, off == 0 ? 0 : off / size);
  }
  return largest;
}

/// `factor` times a product of functions of the time, with its sign.
void add_term(std::string& text, Real factor, const std::string& functions) {
  if (factor == 0) return;
  const std::string size = fmt::format("{:.10Lg}", std::abs(factor));
  text += text.empty() ? (factor < 0 ? "-" : "") : (factor < 0 ? " - " : " + ");
  text += functions.empty() ? size : size == "1" ? functions : size + "*" + functions;
}

std::string joined(const std::string& left, const std::string& right) {
  return left.empty() || right.empty() ? left + right : left + "*" + right;
}

std::string text_of(const std::vector<Mode>& modes, std::size_t i, const std::string& time) {
  std::string text;
  for (const Mode& mode : modes) {
    if (mode.rate.imag() < 0) continue;  // with its conjugate
    std::string outer = mode.power == 0   ? ""
                        : mode.power == 1 ? time
                                          : fmt::format("{}^{}", time, mode.power);
    if (mode.rate.real() != 0)
      outer = joined(outer, fmt::format("exp({:.10Lg}*{})", mode.rate.real(), time));
    const Complex c = mode.of[i];
    if (mode.rate.imag() == 0) {
      add_term(text, c.real(), outer);
      continue;
    }
    const std::string angle = fmt::format("({:.10Lg}*{})", mode.rate.imag(), time);
    const Real least = 1e-13L * std::abs(c);
    add_term(text, std::abs(c.real()) > least ? 2 * c.real() : 0, joined(outer, "cos" + angle));
    add_term(text, std::abs(c.imag()) > least ? -2 * c.imag() : 0, joined(outer, "sin" + angle));
  }
  return text.empty() ? "0" : text;
}

}  // namespace

std::vector<std::string> modal_solution(const std::vector<double>& m, const std::vector<double>& z0,
                                        std::size_t shown, double end, const std::string& time) {
  const std::vector<std::complex<double>> values = eigenvalues(m, z0.size());
  double largest = 0;
  for (const auto& z : values) largest = std::max(largest, std::abs(z));
  // An eigenvalue of multiplicity k is computed to the k-th root of rounding; as several it would
  // have terms that cancel.
  for (const double apart : {1e-3, 1e-5, 1e-7, 1e-13}) {
    std::vector<Mode> modes = modes_of(values, apart * largest);
    if (!set_coefficients(modes, m, z0) || !(difference(modes, m, z0, end) <= 1e-9)) continue;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < shown; ++i) texts.push_back(text_of(modes, i, time));
    return texts;
  }
  return {};
}

}  // namespace odeum::cases
