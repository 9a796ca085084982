// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/formula/reader.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

using Real = long double;
using Matrix = std::vector<std::vector<Real>>;

/// The inverse by Cholesky's factors; empty where the matrix is not positive definite.
Matrix inverse_of(const Matrix& m) {
  const std::size_t n = m.size();
  Matrix l(n, std::vector<Real>(n, 0)), inverse = l;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      // Below that a pivot is the rounding of its terms.
      if (i == j && !(sum > 1e-15L * m[i][i])) return {};
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
  for (std::size_t column = 0; column < n; ++column) {
    std::vector<Real> x(n, 0);
    x[column] = 1;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= l[i][k] * x[k];
      x[i] /= l[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k) x[i] -= l[k][i] * x[k];
      x[i] /= l[i][i];
    }
    for (std::size_t i = 0; i < n; ++i) inverse[i][column] = x[i];
  }
  return inverse;
}

}  // namespace

void Reader::read_mass(Scope& scope) {
  const Item* const mass = section("mass");
  if (!mass) return;
  const std::vector<Item> rows = required_items("mass");
  if (rows.size() > 100)
    fail(mass->value->place, "mass: too many rows; got more than 100, expected fewer");
  std::vector<std::string> names;
  std::vector<std::size_t> at;  // the state of each row
  for (const Item& row : rows) {
    const auto state = std::ranges::find(problem_.states, row.key);
    if (state == problem_.states.end())
      fail(row.key_place, "mass: no state; got {}, expected the name of one, a velocity{}",
           shown(row.key), near_one(row.key, problem_.states));
    names.push_back(row.key);
    at.push_back(static_cast<std::size_t>(state - problem_.states.begin()));
  }
  const std::size_t n = rows.size();
  Matrix m(n, std::vector<Real>(n, 0));
  for (std::size_t i = 0; i < n; ++i)
    for (const Item& entry : items(*rows[i].value, "mass: " + rows[i].key)) {
      const auto column = std::ranges::find(names, entry.key);
      if (column == names.end())
        fail(entry.key_place, "mass: {}: no row of that name; got {}, expected {}", rows[i].key,
             shown(entry.key), one_of(names, entry.key));
      m[i][static_cast<std::size_t>(column - names.begin())] =
          number(*entry.value, fmt::format("mass: {}: {}", rows[i].key, entry.key));
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(m[i][j] - m[j][i]) > 1e-15L * (std::abs(m[i][i]) + std::abs(m[j][j])))
        fail(rows[i].key_place,
             "mass: not symmetric, and only the symmetric part of a mass matrix is in the kinetic "
             "energy; got {0}: {{{1}: {2:.6Lg}}} and {1}: {{{0}: {3:.6Lg}}}, expected them equal",
             names[i], names[j], m[i][j], m[j][i]);
  const Matrix inverse = inverse_of(m);
  if (inverse.empty())
    fail(mass->value->place,
         "mass: not positive definite: some motion has no kinetic energy; got such a matrix, "
         "expected v M v > 0 for all v");
  apply_mass(at, m, inverse, scope);
}

void Reader::apply_mass(const std::vector<std::size_t>& at, const Matrix& m, const Matrix& inverse,
                        Scope& scope) {
  Graph& graph = problem_.graph;
  const std::vector<Id> forces = problem_.equations;
  Id twice = graph.constant(0);
  std::vector<std::string> names, text;
  for (std::size_t i = 0; i < at.size(); ++i) {
    Id acceleration = graph.constant(0), momentum = graph.constant(0);
    for (std::size_t j = 0; j < at.size(); ++j) {
      acceleration =
          graph.make(Op::add, acceleration,
                     graph.make(Op::multiply, graph.constant(inverse[i][j]), forces[at[j]]));
      momentum = graph.make(Op::add, momentum,
                            graph.make(Op::multiply, graph.constant(m[i][j]),
                                       graph.state(static_cast<std::uint32_t>(at[j]))));
    }
    problem_.equations[at[i]] = acceleration;
    twice = graph.make(
        Op::add, twice,
        graph.make(Op::multiply, graph.state(static_cast<std::uint32_t>(at[i])), momentum));
    names.push_back(problem_.states[at[i]]);
    text.push_back(fmt::format("{:.6Lg}", fmt::join(m[i], " ")));
  }
  problem_.kinetic_energy = graph.make(Op::multiply, graph.constant(0.5L), twice);
  problem_.mass_text = fmt::format("M = [{}]", fmt::join(text, "; "));
  problem_.equations_text +=
      fmt::format("; M ({0})' in place of ({0})', {1}", fmt::join(names, ", "), problem_.mass_text);
  const auto [unused, added] = names_.try_emplace("kinetic_energy", "mass");
  if (!added)
    fail(section("mass")->key_place,
         "mass: kinetic_energy is v M v / 2; got another of that name, expected none");
  scope.names["kinetic_energy"] = problem_.kinetic_energy;
}

}  // namespace odeum::formula::reading
