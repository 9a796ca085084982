// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/foreign_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/core/numbers.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/isolated/kept_arithmetic.hpp"
#include "odeum/linear/dense_limit.hpp"

namespace odeum::foreign {
namespace {

bool is_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

std::string fault_of_name(const char* what, const char* name) {
  if (!name) return fmt::format("a {} has a null pointer for its name", what);
  if (!is_name(name))
    return fmt::format("{} name: got \"{}\", expected 1 to 64 characters of a-z, 0-9 and _", what,
                       cleaned(name));
  return {};
}

std::string cleaned(const char* text) {
  std::string clean;
  for (; *text && clean.size() < 300; ++text)
    clean += static_cast<unsigned char>(*text) < 32 || *text == 127 ? ' ' : *text;
  return clean;
}

std::string fault_of(const odeum_problem& p) {
  if (const std::string fault = fault_of_name("problem", p.name); !fault.empty()) return fault;
  const std::string who = fmt::format("problem {}: ", p.name);
  if (p.dimension == 0 || p.dimension > 1'000'000)
    return who + fmt::format("dimension: got {}, expected 1 to 1000000", p.dimension);
  if (!p.y0 || !p.stops || !p.rhs || p.stop_count == 0)
    return who + "y0, stops and rhs are needed, and at least one stop";
  for (std::size_t i = 0; i < p.dimension; ++i)
    if (!std::isfinite(p.y0[i])) return who + fmt::format("y0[{}] is {}", i, p.y0[i]);
  double before = p.t0;
  for (std::size_t k = 0; k < p.stop_count; ++k) {
    if (!std::isfinite(before) || !std::isfinite(p.stops[k]) || !(p.stops[k] > before))
      return who + fmt::format("stop {} = {} does not come after {}", k, p.stops[k], before);
    before = p.stops[k];
  }
  if (p.acceleration && p.dimension % 2 != 0)
    return who + "a second-order problem has an even dimension, y = [q, v]";
  if ((p.jacobian != nullptr) + (p.banded_jacobian != nullptr) + (p.sparse_jacobian != nullptr) > 1)
    return who + "more than one form of the Jacobian is given";
  if (p.banded_jacobian && (p.lower >= p.dimension || p.upper >= p.dimension))
    return who + fmt::format("bandwidths {} and {}: each has to be below the dimension {}", p.lower,
                             p.upper, p.dimension);
  if (p.sparse_jacobian) {
    if (!p.row || !p.column) return who + "a sparse Jacobian needs row and column";
    for (std::size_t n = 0; n < p.entries; ++n)
      if (p.row[n] >= p.dimension || p.column[n] >= p.dimension)
        return who +
               fmt::format("entry {} of the sparse Jacobian is at ({}, {}), outside of the matrix",
                           n, p.row[n], p.column[n]);
  }
  return {};
}

Problem::Problem(const odeum_problem& description) : p_(description) {
  if (p_.banded_jacobian) values_.resize(p_.dimension * (p_.lower + p_.upper + 1));
  if (p_.sparse_jacobian) values_.resize(std::max<std::size_t>(p_.entries, 1));
  const std::size_t n = p_.dimension;
  const std::size_t most = n <= dense_dimension_limit ? std::max(n * n, n) : n;
  evaluator_ =
      std::make_shared<Evaluator>([this](int function, double t, const double* in,
                                         double* out) { return direct(function, t, in, out); },
                                  std::max<std::size_t>(most, 2));
}

bool Problem::offers_jacobian() const {
  return (p_.jacobian || p_.banded_jacobian || p_.sparse_jacobian) &&
         p_.dimension <= dense_dimension_limit;
}

int Problem::dense(double t, const double* y, double* j) const {
  const std::size_t n = p_.dimension;
  if (p_.jacobian) return p_.jacobian(p_.data, t, y, j);
  std::fill_n(j, n * n, 0.0);
  if (p_.banded_jacobian) {
    const std::size_t width = p_.lower + p_.upper + 1;
    if (const int failed = p_.banded_jacobian(p_.data, t, y, values_.data())) return failed;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t d = 0; d < width; ++d)
        if (i + d >= p_.lower && i + d - p_.lower < n)
          j[i * n + i + d - p_.lower] = values_[i * width + d];
    return 0;
  }
  if (const int failed = p_.sparse_jacobian(p_.data, t, y, values_.data())) return failed;
  for (std::size_t k = 0; k < p_.entries; ++k) j[p_.row[k] * n + p_.column[k]] += values_[k];
  return 0;
}

int Problem::direct(int function, double t, const double* in, double* out) const {
  using isolated::Sign;
  isolated::alive(function == f || function == second ? Sign::evaluation
                  : function == f_y                   ? Sign::jacobian
                                                      : Sign::other);
  const isolated::KeptArithmetic kept;
  switch (function) {
    case f:
      return p_.rhs(p_.data, t, in, out);
    case f_y:
      return dense(t, in, out);
    case f_t:
      return p_.time_derivative(p_.data, t, in, out);
    case second:
      return p_.acceleration(p_.data, t, in, in + p_.dimension / 2, out);
    case energy_of:
      return p_.energy(p_.data, in, out);
    default:
      return p_.exact(p_.data, t, out);
  }
}

void Problem::evaluate(Function function, double t, const double* in, std::size_t n_in, double* out,
                       std::size_t n_out) const {
  if (!isolated::in_isolated_process())
    evaluator_->call(function, t, in, n_in, out, n_out);
  else if (direct(function, t, in, out) != 0)
    std::fill_n(out, n_out, nan);
}

void Problem::rhs(double t, const double* y, double* dydt) const {
  evaluate(f, t, y, size(), dydt, size());
}

void Problem::jacobian(double t, const double* y, double* j) const {
  evaluate(f_y, t, y, size(), j, size() * size());
}

void Problem::time_derivative(double t, const double* y, double* dfdt) const {
  evaluate(f_t, t, y, size(), dfdt, size());
}

void Problem::acceleration(double t, const double* q, const double* v, double* a) const {
  const std::size_t m = size() / 2;
  if (isolated::in_isolated_process() && v == q + m) return evaluate(second, t, q, 2 * m, a, m);
  thread_local std::vector<double> y;
  y.assign(q, q + m);
  y.insert(y.end(), v, v + m);
  evaluate(second, t, y.data(), 2 * m, a, m);
}

bool Problem::exact(double t, double* y) const {
  if (!p_.exact) return false;
  const std::size_t n = p_.dimension;
  evaluate(exact_at, t, y, 0, y, n);
  return std::all_of(y, y + n, [](double x) { return std::isfinite(x); });
}

double Problem::energy(const double* y) const {
  double energy = nan;
  evaluate(energy_of, 0, y, p_.dimension, &energy, 1);
  return energy;
}

std::string Problem::fault() const {
  const std::size_t n = p_.dimension;
  const std::size_t room = std::max(n <= dense_dimension_limit ? n * n : n, n);
  std::vector<double> out(room, 0.0), y(p_.y0, p_.y0 + n);
  const auto say = [&](const char* what, double t) {
    return fmt::format("problem {}: {} fails or is not finite at t = {}", p_.name, what, t);
  };
  const auto sound = [&](int function, std::size_t size, double t) {
    return direct(function, t, y.data(), out.data()) == 0 &&
           std::all_of(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size),
                       [](double x) { return std::isfinite(x); });
  };
  if (!sound(f, n, p_.t0)) return say("rhs", p_.t0);
  if (offers_jacobian() && !sound(f_y, n * n, p_.t0)) return say("the Jacobian", p_.t0);
  if (p_.time_derivative && !sound(f_t, n, p_.t0)) return say("time_derivative", p_.t0);
  if (p_.acceleration && !sound(second, n / 2, p_.t0)) return say("acceleration", p_.t0);
  if (p_.energy && !sound(energy_of, 1, p_.t0)) return say("energy", p_.t0);
  return p_.exact ? fault_of_exact() : std::string();
}

std::string Problem::fault_of_exact() const {
  const std::size_t n = p_.dimension;
  std::vector<double> y(n), before(n), after(n), slope(n);
  if (direct(exact_at, p_.t0, nullptr, y.data()) != 0)
    return fmt::format("problem {}: exact fails at t0", p_.name);
  for (std::size_t i = 0; i < n; ++i)
    if (!(std::abs(y[i] - p_.y0[i]) <= 1e-10 * (1 + std::abs(y[i]))))
      return fmt::format("problem {}: the exact solution begins at y[{}] = {}, y0 has {}", p_.name,
                         i, y[i], p_.y0[i]);
  // Its slope by differences is that of the right-hand side, to their accuracy.
  const double length = p_.stops[p_.stop_count - 1] - p_.t0;
  for (int k = 1; k <= 5; ++k) {
    const double t = p_.t0 + length * k / 6, d = 1e-6 * length;
    if (direct(exact_at, t, nullptr, y.data()) + direct(exact_at, t - d, nullptr, before.data()) +
            direct(exact_at, t + d, nullptr, after.data()) + direct(f, t, y.data(), slope.data()) !=
        0)
      return fmt::format("problem {}: exact or rhs fails at t = {}", p_.name, t);
    for (std::size_t i = 0; i < n; ++i) {
      const double measured = (after[i] - before[i]) / (2 * d);
      if (!(std::abs(measured - slope[i]) <=
            1e-3 * (std::abs(slope[i]) + std::abs(y[i]) / length + 1e-6)))
        return fmt::format(
            "problem {}: at t = {} the exact solution rises by y[{}]' = {}, the right-hand side "
            "says {}",
            p_.name, t, i, measured, slope[i]);
    }
  }
  return {};
}

}  // namespace odeum::foreign
