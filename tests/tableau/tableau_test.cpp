// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <string>
#include <vector>

#include "odeum/tableau/order_conditions.hpp"
#include "odeum_methods.hpp"

namespace odeum::tests::tableau_test {
namespace {

// --- rooted trees, made another way: as nested brackets, by hanging a leaf on every node ---

/// A tree from its brackets: the sorted brackets of the root's subtrees, in one pair.
std::string canonical(const std::string& tree) {
  std::vector<std::string> subtrees;
  int depth = 0;
  std::size_t start = 1;
  for (std::size_t i = 1; i + 1 < tree.size(); ++i) {
    depth += tree[i] == '(' ? 1 : -1;
    if (depth == 0) {
      subtrees.push_back(canonical(tree.substr(start, i + 1 - start)));
      start = i + 1;
    }
  }
  std::sort(subtrees.begin(), subtrees.end());
  std::string joined = "(";
  for (const auto& subtree : subtrees) joined += subtree;
  return joined + ")";
}

std::vector<std::set<std::string>> trees_by_nodes(int most) {
  std::vector<std::set<std::string>> trees{{}, {"()"}};
  for (int n = 2; n <= most; ++n) {
    std::set<std::string> larger;
    for (const std::string& tree : trees.back())
      for (std::size_t i = 0; i < tree.size(); ++i)
        if (tree[i] == '(') larger.insert(canonical(std::string(tree).insert(i + 1, "()")));
    trees.push_back(larger);
  }
  return trees;
}

/// gamma(tau): the product over all nodes of the size of the subtree below (and with) each.
double density(const std::string& tree) {
  double product = 1;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (tree[i] != '(') continue;
    int depth = 0, nodes = 0;
    std::size_t j = i;
    do {
      depth += tree[j] == '(' ? 1 : -1;
      nodes += tree[j] == '(';
    } while (depth > 0 && ++j < tree.size());
    product *= nodes;
  }
  return product;
}

TEST(RootedTrees, CountsAndDensitiesAgreeWithAnotherEnumeration) {
  // A000081: the number of rooted trees with n nodes.
  const std::vector<std::size_t> known{0, 1, 1, 2, 4, 9, 20, 48, 115, 286, 719};
  const auto expected = trees_by_nodes(10);
  constexpr const auto& trees = rooted_trees<10>;
  for (int n = 1; n <= 10; ++n) {
    std::vector<double> densities, expected_densities;
    for (std::size_t i = 0; i < trees.count; ++i)
      if (trees.nodes[i] == n) densities.push_back(trees.density[i]);
    for (const std::string& tree : expected[static_cast<std::size_t>(n)])
      expected_densities.push_back(density(tree));
    std::sort(densities.begin(), densities.end());
    std::sort(expected_densities.begin(), expected_densities.end());
    EXPECT_EQ(densities.size(), known[static_cast<std::size_t>(n)]);
    EXPECT_EQ(densities, expected_densities) << n << " nodes";  // small integers: exact
  }
}

// --- order conditions, and the errors they detect ---

TEST(OrderConditions, TellsWhichConditionIsMissed) {
  constexpr Tableau<2> ralston{.a = {{{0, 0}, {2. / 3, 0}}}, .b = {1. / 4, 3. / 4}, .order = 2};
  EXPECT_EQ(order_fault(ralston, ralston.b, 2).order, 0);
  EXPECT_EQ(order_fault(ralston, ralston.b, 1).order, 2) << "the order is higher than stated";
  const OrderFault lower = order_fault(ralston, ralston.b, 3);
  EXPECT_EQ(lower.order, 3) << "the order is lower than stated";
  // b1 c1^2 + b2 c2^2 = 1/3 holds; sum b_i a_ij c_j = 0 misses 1/6.
  EXPECT_NEAR(lower.residual, -1. / 6, 1e-15);  // one rounding of 1/6
  // Two-stage Gauss, order 4: the only implicit weights with which all eight conditions hold.
  const double r = std::sqrt(3.) / 6;
  const Tableau<2> gauss{
      .a = {{{1. / 4, 1. / 4 - r}, {1. / 4 + r, 1. / 4}}}, .b = {1. / 2, 1. / 2}, .order = 4};
  EXPECT_EQ(order_fault(gauss, gauss.b, 4).order, 0);
}

/// The run-time check of a tableau: order of both rows, and that a stiffly accurate method still is
/// one (for implicit Euler no order condition contains A).
template <std::size_t S>
bool accepted(const Tableau<S>& t, bool stiffly_accurate) {
  return first_fault(t).order == 0 && (!stiffly_accurate || t.a[S - 1] == t.b);
}

template <std::size_t S>
std::vector<double> entries_of(const Tableau<S>& t) {
  std::vector<double> entries;
  for (const auto& row : t.a) entries.insert(entries.end(), row.begin(), row.end());
  return entries;
}

/// The A of every own method with an embedded row, whose altered entries are all noticed.
std::vector<std::vector<double>> full_pairs() {
  std::vector<std::vector<double>> pairs;
  methods::All::for_each([&]<class M>() {
    if constexpr (requires { M::tableau.embedded(); })
      if (M::tableau.embedded()) pairs.push_back(entries_of(M::tableau));
  });
  return pairs;
}

TEST(OrderConditions, EveryAlteredCoefficientOfEveryOwnMethodIsNoticed) {
  int altered = 0;
  const auto pairs = full_pairs();
  methods::All::for_each([&]<class M>() {
    if constexpr (requires { M::tableau.embedded(); }) {
      constexpr std::size_t S = std::decay_t<decltype(M::tableau)>::stages;
      const bool stiffly_accurate =
          !M::tableau.is_explicit() && M::tableau.a[S - 1] == M::tableau.b;
      ASSERT_TRUE(accepted(M::tableau, stiffly_accurate)) << M::info.id;
      const std::complex<double> z{-0.7, 0.4};
      const auto growth = stability_function(M::tableau, z);
      // With the weights of a lower row some of the pair's stages have no effect; there the pair's
      // own rows detect the change.
      const bool borrowed =
          !M::tableau.embedded() &&
          std::find(pairs.begin(), pairs.end(), entries_of(M::tableau)) != pairs.end();
      const auto alter = [&](auto entry, const std::string& name) {
        auto mutant = M::tableau;
        double& value = entry(mutant);
        if (value == 0) return;
        value += 1e-6;
        ++altered;
        const bool dead = borrowed && std::abs(stability_function(mutant, z) - growth) < 1e-12;
        EXPECT_TRUE(dead || !accepted(mutant, stiffly_accurate)) << M::info.id << " " << name;
      };
      for (std::size_t i = 0; i < S; ++i) {
        const std::string n = std::to_string(i);
        alter([&](auto& t) -> double& { return t.b[i]; }, "b" + n);
        alter([&](auto& t) -> double& { return t.b_hat[i]; }, "b_hat" + n);
        for (std::size_t j = 0; j < S; ++j)
          alter([&](auto& t) -> double& { return t.a[i][j]; }, "a" + n + "," + std::to_string(j));
      }
    }
  });
  EXPECT_GE(altered, 100);  // Cash-Karp's six stages alone have 15 + 4 + 5 and four more rows
}

// --- the stability function ---

TEST(StabilityFunction, OfAnExplicitMethodWithAsManyStagesAsItsOrderIsTheExponentialSeries) {
  int checked = 0;
  methods::All::for_each([&]<class M>() {
    if constexpr (requires { M::tableau.embedded(); }) {
      constexpr const auto& t = M::tableau;
      if (!t.is_explicit() || t.order != static_cast<int>(t.stages)) return;
      for (const std::complex<double> z : {std::complex<double>{-1.5, 0}, {0.3, 2.1}, {0, -2.5}}) {
        std::complex<double> series = 1, term = 1;
        for (int n = 1; n <= t.order; ++n) series += term *= z / static_cast<double>(n);
        // Sums of a dozen terms of size one to ten.
        EXPECT_LT(std::abs(stability_function(t, z) - series), 1e-14) << M::info.id;
        EXPECT_NEAR(M::amplification(z.real(), z.imag()), std::abs(series), 1e-14) << M::info.id;
      }
      ++checked;
    }
  });
  EXPECT_GE(checked, 4);  // explicit Euler, midpoint, Heun, RK4
}

TEST(StabilityFunction, OfImplicitMethods) {
  constexpr Tableau<2> trapezoidal{
      .a = {{{0, 0}, {1. / 2, 1. / 2}}}, .b = {1. / 2, 1. / 2}, .order = 2};
  const std::complex<double> z{-3, 1.7};
  // A handful of operations on numbers of size one: ten roundings.
  EXPECT_LT(std::abs(stability_function(trapezoidal, z) - (1. + z / 2.) / (1. - z / 2.)), 2e-15);
  EXPECT_LT(std::abs(stability_function(methods::implicit_euler_tableau, z) - 1. / (1. - z)),
            2e-15);
}

TEST(Tableau, DerivesWhatFollowsFromItsCoefficients) {
  // Bogacki and Shampine's pair, whose last stage is the first of the next step.
  static constexpr Tableau<4> bs32{
      .a = {{{0, 0, 0, 0}, {1. / 2, 0, 0, 0}, {0, 3. / 4, 0, 0}, {2. / 9, 1. / 3, 4. / 9, 0}}},
      .b = {2. / 9, 1. / 3, 4. / 9, 0},
      .order = 3,
      .b_hat = {7. / 24, 1. / 4, 1. / 3, 1. / 8},
      .order_hat = 2};
  static_assert(proven<bs32>());
  static_assert(bs32.first_same_as_last() && bs32.is_explicit() && bs32.embedded());
  static_assert(!methods::rk4_tableau.first_same_as_last());
  static_assert(!methods::implicit_euler_tableau.is_explicit());
  EXPECT_EQ(bs32.c(1), 1. / 2);
  EXPECT_EQ(bs32.c(2), 3. / 4);
  EXPECT_DOUBLE_EQ(bs32.c(3), 1);
}

}  // namespace
}  // namespace odeum::tests::tableau_test
