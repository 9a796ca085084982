// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/character.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odeum {
namespace {

bool same(double x, double y) {
  return std::abs(x - y) <= 1e-13 * std::max({1.0, std::abs(x), std::abs(y)});
}

bool symplectic(const DynamicTableau<double>& t) {
  for (std::size_t i = 0; i < t.stages; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (!same(t.b[i] * t.at(i, j) + t.b[j] * t.at(j, i), t.b[i] * t.b[j])) return false;
  return true;
}

bool symmetric(const DynamicTableau<double>& t) {
  const std::size_t last = t.stages - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    if (!same(t.b[i], t.b[last - i])) return false;
    for (std::size_t j = 0; j <= last; ++j)
      if (!same(t.at(last - i, last - j) + t.at(i, j), t.b[j])) return false;
  }
  return true;
}

// |R| along the ray at `angle` degrees from the negative real axis stays at most 1.
bool bounded_on_ray(const std::function<double(std::complex<double>)>& amplification,
                    double angle) {
  const double radians = angle * std::numbers::pi / 180;
  const std::complex<double> direction =
      angle >= 90 ? std::complex<double>(0, 1)
                  : std::complex<double>(-std::cos(radians), std::sin(radians));
  for (int k = -240; k <= 360; ++k)
    if (!(amplification(direction * std::pow(10.0, k / 40.0)) <= 1 + 1e-12)) return false;
  return true;
}

}  // namespace

Structure structure_of(const DynamicTableau<double>& t) {
  Structure s;
  s.kind = t.is_explicit()              ? Structure::Kind::explicit_stages
           : t.is_diagonally_implicit() ? Structure::Kind::diagonally_implicit
                                        : Structure::Kind::fully_implicit;
  const std::size_t last = t.stages - 1;
  s.stiffly_accurate = true;
  for (std::size_t j = 0; j <= last; ++j)
    s.stiffly_accurate = s.stiffly_accurate && same(t.at(last, j), t.b[j]);
  if (s.kind == Structure::Kind::explicit_stages) {
    s.first_same_as_last = s.stiffly_accurate;
    s.stiffly_accurate = false;
  } else {
    s.first_stage_explicit = true;
    for (std::size_t j = 0; j <= last; ++j)
      s.first_stage_explicit = s.first_stage_explicit && t.at(0, j) == 0;
    s.one_diagonal = s.kind == Structure::Kind::diagonally_implicit;
    for (std::size_t i = s.first_stage_explicit ? 1 : 0; i <= last; ++i)
      s.one_diagonal = s.one_diagonal && same(t.at(i, i), t.at(last, last));
  }
  s.symplectic = symplectic(t);
  s.symmetric = symmetric(t);
  return s;
}

std::string describe(const Structure& s) {
  std::string text;
  if (s.kind == Structure::Kind::explicit_stages)
    text = "explicit";
  else if (s.kind == Structure::Kind::diagonally_implicit)
    text = s.one_diagonal ? "singly diagonally implicit" : "diagonally implicit";
  else
    text = "fully implicit";
  if (s.first_stage_explicit) text += ", first stage explicit";
  if (s.first_same_as_last) text += ", first same as last";
  if (s.stiffly_accurate) text += ", stiffly accurate";
  if (s.symplectic) text += ", symplectic";
  if (s.symmetric) text += ", symmetric";
  return text;
}

std::complex<double> stability_function(const DynamicTableau<double>& t, std::complex<double> at) {
  using LongComplex = std::complex<long double>;
  using Matrix = Eigen::Matrix<LongComplex, Eigen::Dynamic, Eigen::Dynamic>;
  const auto s = static_cast<Eigen::Index>(t.stages);
  Matrix below(s, s), above(s, s);
  for (Eigen::Index i = 0; i < s; ++i)
    for (Eigen::Index j = 0; j < s; ++j) {
      const auto column = static_cast<std::size_t>(j);
      const long double a = t.at(static_cast<std::size_t>(i), column), b = t.b[column];
      below(i, j) = (i == j ? 1.0L : 0.0L) - LongComplex(at) * a;
      above(i, j) = (i == j ? 1.0L : 0.0L) - LongComplex(at) * (a - b);
    }
  // Ratios of pivots: either determinant alone may overflow.
  const Eigen::PartialPivLU<Matrix> numerator(above), denominator(below);
  LongComplex result = static_cast<long double>(numerator.permutationP().determinant() *
                                                denominator.permutationP().determinant());
  for (Eigen::Index k = 0; k < s; ++k)
    result *= numerator.matrixLU()(k, k) / denominator.matrixLU()(k, k);
  return {static_cast<double>(result.real()), static_cast<double>(result.imag())};
}

StabilityClass stability_class(const std::function<double(std::complex<double>)>& amplification) {
  StabilityClass found;
  // Two points two decades apart: a value that tends to zero falls to a hundredth (the roots of a
  // six-step method, as |z|^(-1/6), to less than half); one with a finite limit does not change.
  // Farther out rounding in 1 + z b^T k would hide the limit.
  const double far = amplification(-1e6), farther = amplification(-1e8);
  found.at_infinity = farther < far / 2   ? 0
                      : farther < 2 * far ? farther
                                          : std::numeric_limits<double>::infinity();
  const auto bounded = [&](double angle) { return bounded_on_ray(amplification, angle); };
  if (!bounded(0)) return found;
  if (bounded(90) && bounded(30) && bounded(60)) {
    found.angle = 90;
    return found;
  }
  double low = 0, high = 90;
  for (double angle = 1; angle < 90; angle += 1) {
    if (!bounded(angle)) {
      high = angle;
      break;
    }
    low = angle;
  }
  while (high - low > 1e-3) {
    const double middle = (low + high) / 2;
    (bounded(middle) ? low : high) = middle;
  }
  found.angle = low;
  return found;
}

StabilityClass stability_class(const DynamicTableau<double>& tableau) {
  StabilityClass explicit_class;
  explicit_class.at_infinity = std::numeric_limits<double>::infinity();
  if (tableau.is_explicit()) return explicit_class;  // R is a polynomial
  return stability_class(
      [&](std::complex<double> z) { return std::abs(stability_function(tableau, z)); });
}

std::string describe(const StabilityClass& s) {
  if (s.l_stable()) return "L-stable";
  const std::string limit = fmt::format(", |R(-inf)| = {:.3g}", s.at_infinity);
  if (s.a_stable()) return "A-stable" + limit;
  if (s.angle > 0) return fmt::format("A(alpha)-stable, alpha = {:.2f} degrees", s.angle) + limit;
  return "not A(alpha)-stable";
}

}  // namespace odeum
