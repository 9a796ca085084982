// SPDX-License-Identifier: BSD-3-Clause
// Which parts of surfaces are near enough for a force.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/surface/surfaces.hpp"
#include "support/wavy_sheet.hpp"

namespace odeum::near_pairs_test {
namespace {

using scene::Scene;
using scene::SceneProblem;
using tests::wavy;

// All pairs of parts are tried, in place of those in neighbouring cells.
TEST(NearPairs, WhatIsNearIsFound) {
  const Scene scene = wavy(14, 0.4);
  const scene::Surfaces surfaces(scene);
  const std::vector<double> q = scene::start_of(scene);
  const double margin = 0.02;
  std::vector<scene::SurfacePair> pairs;
  surfaces.find_near(q.data(), margin, pairs);
  std::set<std::pair<scene::SurfacePair::Kind, std::array<std::uint32_t, 4>>> found;
  for (const scene::SurfacePair& pair : pairs) {
    EXPECT_TRUE(found.insert({pair.kind, pair.x}).second) << "found twice";
    EXPECT_LE(pair.slack, margin);
  }
  std::size_t acting = 0, tried = 0;
  const auto& faces = scene.surfaces[0].faces;
  for (const auto& face : faces)
    for (std::uint32_t p = 0; p < scene.size(); ++p) {
      if (p == face[0] || p == face[1] || p == face[2]) continue;
      scene::SurfacePair pair{
          {std::uint32_t(face[0]), std::uint32_t(face[1]), p, std::uint32_t(face[2])},
          scene::SurfacePair::Kind::triangle};
      scene::Vec<double> e1, e2, r;
      scene::Apart<double> apart;
      scene::differences_of(pair, q.data(), e1, e2, r);
      ++tried;
      if (!scene::meet(pair, surfaces.law(0), e1, e2, r, apart)) continue;
      ++acting;
      EXPECT_TRUE(found.contains({pair.kind, pair.x})) << apart.distance;
    }
  EXPECT_GT(acting, 50U);
  EXPECT_LT(pairs.size(), tried / 5);
}

/// How far (m) the nearest points of a pair are from where a force acts: below 0 where one does.
double missing(const scene::SurfacePair& pair, const scene::SelfContact& law, const double* q) {
  scene::Vec<double> e1, e2, r;
  scene::differences_of(pair, q, e1, e2, r);
  scene::Nearest<double> at;
  // Without a thickness everything is computed up to the distance.
  const scene::SelfContact wide{1e3, law.stiffness, 0};
  scene::is_near(scene::meeting_of(pair.kind), wide, 0, e1, e2, r, at);
  const double l1 = std::sqrt(at.a), l2 = std::sqrt(at.c);
  double most = std::max({-at.u * l1, -at.near2 * l2, -at.far1 * std::min(l1, l2),
                          -at.far2 * std::min(l1, l2)}) -
                scene::reach * std::max(l1, l2);
  scene::Vec<double> w;
  for (std::size_t d = 0; d < 3; ++d) w[d] = r[d] - at.u * e1[d] - at.v * e2[d];
  return std::max(most, std::sqrt(scene::dot(w, w)) - law.thickness);
}

// The particles of a pair are moved step by step towards a force, as far as the slack allows: none
// may act. A slack three times as large would be enough for most pairs, so that it is not too small
// by much.
TEST(NearPairs, NoForceActsUntilTheSlackIsUsedUp) {
  const Scene scene = wavy(14, 0.4);
  const scene::Surfaces surfaces(scene);
  const std::vector<double> q = scene::start_of(scene);
  std::vector<scene::SurfacePair> pairs;
  surfaces.find_near(q.data(), 0.05, pairs);
  std::mt19937_64 bits(1);
  const auto unit = [&] { return static_cast<double>(bits() >> 11U) * 0x1p-52 - 1; };
  const auto reached = [&](const scene::SurfacePair& pair, double factor) {
    const scene::SelfContact& law = surfaces.law(pair.law);
    const double most = factor * pair.slack / scene::Surfaces::shrinks;
    std::vector<double> best = q;
    double least = missing(pair, law, q.data());
    for (int round = 0; round < 1500; ++round) {
      std::vector<double>& moved = best;
      scene::Vec<double> before[4];
      for (std::size_t k = 0; k < 4; ++k) {
        double* const x = moved.data() + 3 * pair.x[k];
        const double* const from = q.data() + 3 * pair.x[k];
        std::copy_n(x, 3, before[k].data());
        scene::Vec<double> way;
        for (std::size_t d = 0; d < 3; ++d) way[d] = x[d] - from[d] + 0.3 * most * unit();
        const double length = std::sqrt(scene::dot(way, way));
        for (std::size_t d = 0; d < 3; ++d)
          x[d] = from[d] + way[d] * (length > most ? most / length : 1);
      }
      scene::Vec<double> e1, e2, r;
      scene::Apart<double> apart;
      scene::differences_of(pair, moved.data(), e1, e2, r);
      if (scene::meet(pair, law, e1, e2, r, apart)) return true;
      const double now = missing(pair, law, moved.data());
      if (now < least)
        least = now;
      else
        for (std::size_t k = 0; k < 4; ++k)
          std::copy_n(before[k].data(), 3, moved.data() + 3 * pair.x[k]);
    }
    return false;
  };
  std::size_t tried = 0, with_more = 0;
  for (std::size_t i = 0; i < pairs.size(); i += 97) {
    if (!(pairs[i].slack > 1e-4)) continue;
    ++tried;
    EXPECT_FALSE(reached(pairs[i], 0.999)) << pairs[i].slack;
    with_more += reached(pairs[i], 3);
  }
  EXPECT_GT(tried, 50U);
  EXPECT_GT(with_more, tried / 2) << tried;
}

// Pairs are kept while they may still act: what is computed depends on the state alone.
TEST(NearPairs, ForcesDoNotDependOnWhatWasComputedBefore) {
  const Scene scene = wavy(14, 0.4);
  const SceneProblem problem(scene), other(scene);
  std::vector<double> y = problem.start(), a(y.size() / 2), b(a.size());
  const double* const v = y.data() + a.size();
  problem.acceleration(0, y.data(), v, a.data());
  std::size_t changed = 0;
  for (int k = 0; k < 30; ++k) {
    for (std::size_t i = 0; i < a.size(); ++i) y[i] += 0.002 * std::sin(0.3 * k + 5.0 * double(i));
    problem.acceleration(0, y.data(), v, a.data());
    const SceneProblem fresh(scene);
    fresh.acceleration(0, y.data(), v, b.data());
    ASSERT_EQ(a, b) << k;
    changed += a[0] != 0;
  }
  EXPECT_GT(changed, 0U);
}

}  // namespace
}  // namespace odeum::near_pairs_test
