// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/springs/spring_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include "odeum/scene/springs/spring_grid.hpp"

namespace odeum::scene::spring_kernels_test {
namespace {

/// The results of all functions of one compilation of the kernels, on the grid only: outside of it
/// each writes up to its vector width.
template <class Real>
std::vector<Real> results_of(const SpringKernels<Real>& kernels, const GridLayout& layout,
                             const SpringRows<Real>& springs, const std::vector<Real>& q,
                             const std::vector<Real>& v) {
  std::vector<Real> all, one(4 * layout.size);
  const auto keep = [&] {
    for (std::size_t component = 0; component < 4; ++component)
      for (std::size_t r = 0; r < layout.rows; ++r) {
        const auto row =
            one.begin() + static_cast<std::ptrdiff_t>(component * layout.size + layout.row(r));
        all.insert(all.end(), row, row + static_cast<std::ptrdiff_t>(layout.columns));
      }
  };
  kernels.forces(springs, q.data(), v.data(), one.data(), 0, layout.rows);
  keep();
  kernels.damping(springs, v.data(), one.data(), 0, layout.rows);
  keep();
  kernels.derivative(springs, q.data(), v.data(), v.data(), one.data(), 0, layout.rows);
  keep();
  kernels.stiffness(springs, 0, q.data(), true, one.data(), one.data() + layout.size);
  keep();
  return all;
}

template <class Real>
void expect_all_kernels_to_agree(double tolerance) {
  const GridLayout layout(7, 19);
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> number(-1, 1);
  std::vector<Real> q(3 * layout.size), v(q);
  for (Real& x : q) x = number(random);
  for (Real& x : v) x = number(random);
  const std::vector<Real> mask(layout.stride, 1);
  std::vector<SpringNeighbour<Real>> neighbours;
  for (const auto& [row, column] : {std::pair{0, 1}, {0, -1}, {1, 1}, {-1, -1}})
    neighbours.push_back({.row_offset = row,
                          .offset = row * static_cast<std::ptrdiff_t>(layout.stride) + column,
                          .stiffness = 3,
                          .stiffness_length = 2,
                          .damping = Real(0.25),
                          .least = row == 0 ? Real(0) : std::numeric_limits<Real>::lowest(),
                          .mask = mask.data()});
  const std::size_t line = layout.stride + 32;
  std::vector<Real> kept(12 * neighbours.size() * line);
  const SpringRows<Real> springs{.rows = layout.rows,
                                 .columns = layout.columns,
                                 .stride = layout.stride,
                                 .size = layout.size,
                                 .margin = GridLayout::margin,
                                 .neighbours = neighbours.data(),
                                 .count = neighbours.size(),
                                 .damped = true,
                                 .moderate = true,
                                 .kept = kept.data() + 16,
                                 .line = line,
                                 .scale = nullptr,
                                 .add = nullptr};
  const auto& kernels = spring_kernels<Real>();
  ASSERT_FALSE(kernels.empty());
  const std::vector<Real> expected = results_of(*kernels.front(), layout, springs, q, v);
  EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](Real x) { return x != 0; }), 1000);
  for (const SpringKernels<Real>* each : kernels) {
    const std::vector<Real> found = results_of(*each, layout, springs, q, v);
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(found[i], expected[i], tolerance) << each->name << ", number " << i;
  }
}

TEST(SpringKernels, OfEveryInstructionSetAgree) {
  // Sums of some ten numbers of size 10 at most; fused multiply-adds and the guess of 1/sqrt round
  // in their own ways. Springs are 0.05 long at least, which costs another factor of 20.
  expect_all_kernels_to_agree<double>(1e-12);
  expect_all_kernels_to_agree<float>(5e-4);
}

}  // namespace
}  // namespace odeum::scene::spring_kernels_test
