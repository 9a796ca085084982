// SPDX-License-Identifier: BSD-3-Clause
// Starts of surfaces through each other, inside of each other, and too thick for their edges.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "odeum/input/yaml_tree.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/surface/surfaces.hpp"
#include "support/wavy_sheet.hpp"

namespace odeum::piercing_test {
namespace {

using scene::Scene;
using tests::wavy;

// A triangle, and a second surface of its own corners, which take up lines from 7 on.
std::string second_surface(const std::string& corners, const std::string& faces) {
  return "duration: 1\nsolver: {type: rk4, timestep: 0.1}\nparticles:\n"
         "  - {pos: [0, 0, 0], mass: 1}\n  - {pos: [1, 0, 0], mass: 1}\n"
         "  - {pos: [0, 1, 0], mass: 1}\n" +
         corners +
         "surfaces:\n  - {faces: [[0, 1, 2]], self_contact: {thickness: 0.01, stiffness: 10}}\n"
         "  - {faces: " +
         faces + ", self_contact: {thickness: 0.01, stiffness: 10}}\n";
}
std::string error_of(const std::string& text) {
  try {
    scene::read_scene("s.yaml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Piercing, IsRefusedWithItsPlace) {
  EXPECT_EQ(error_of(second_surface("  - {pos: [0.2, 0.3, -1], mass: 1}\n"
                                    "  - {pos: [0.2, 0.3, 1], mass: 1}\n"
                                    "  - {pos: [5, 5, 0], mass: 1}\n",
                                    "[[3, 4, 5]]")),
            "s.yaml:11:5: surfaces[0]: starts through a surface; got the edge of particles 1 and "
            "2, which goes through the triangle of 3, 4 and 5, expected surfaces that do not go "
            "through each other");
}

TEST(Piercing, AStartInsideOfAClosedSurfaceIsRefused) {
  const char* const high =
      "  - {pos: [-9, -9, 1], mass: 1}\n  - {pos: [9, -9, 1], mass: 1}\n"
      "  - {pos: [0, 9, 1], mass: 1}\n  - {pos: [0, 0, 9], mass: 1}\n";
  std::string low = high;
  for (std::size_t at = 0; (at = low.find(" 1], mass", at)) != std::string::npos; at += 3)
    low.replace(at, 2, " -1");
  const char* const closed = "[[3, 4, 5], [4, 3, 6], [5, 4, 6], [3, 5, 6]]";
  EXPECT_EQ(error_of(second_surface(low, closed)),
            "s.yaml:12:5: surfaces[0]: starts inside a body; got particle 0 at (0, 0, 0) in a "
            "closed surface, expected a start outside of all bodies");
  EXPECT_EQ(error_of(second_surface(high, closed)), "");
  EXPECT_EQ(error_of(second_surface(low, "[[3, 4, 5], [4, 3, 6], [5, 4, 6]]")), "") << "open";
}

// All pairs of an edge and a triangle are tried by the sides of planes, in place of those in
// neighbouring cells: each end of the edge on another side of the triangle's plane, and the line of
// the edge on one side of all three of the triangle's edges.
TEST(Piercing, TheFirstEdgeThroughATriangleIsFound) {
  const Scene scene = wavy(14, 0.4);
  const scene::Surfaces surfaces(scene);
  std::vector<double> q = scene::start_of(scene);
  EXPECT_FALSE(surfaces.pierced(q.data()));
  const auto volume = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const auto x = [&](std::size_t i, std::size_t k) { return q[3 * i + k] - q[3 * a + k]; };
    return x(b, 0) * (x(c, 1) * x(d, 2) - x(c, 2) * x(d, 1)) +
           x(b, 1) * (x(c, 2) * x(d, 0) - x(c, 0) * x(d, 2)) +
           x(b, 2) * (x(c, 0) * x(d, 1) - x(c, 1) * x(d, 0));
  };
  std::mt19937_64 bits(3);
  std::size_t through = 0;
  for (int trial = 0; trial < 40; ++trial) {
    q = scene::start_of(scene);
    q[3 * (bits() % scene.size()) + bits() % 3] += 0.1;
    bool any = false;
    for (const auto& one : scene.surfaces[0].faces)
      for (std::size_t k = 0; k < 3; ++k)
        for (const auto& [c, d, e] : scene.surfaces[0].faces) {
          const std::size_t a = one[k], b = one[(k + 1) % 3];
          if (a == c || a == d || a == e || b == c || b == d || b == e) continue;
          const bool first = volume(a, b, c, d) > 0;
          any |= volume(a, c, d, e) * volume(b, c, d, e) < 0 && first == (volume(a, b, d, e) > 0) &&
                 first == (volume(a, b, e, c) > 0);
        }
    through += any;
    EXPECT_EQ(surfaces.pierced(q.data()).has_value(), any) << trial;
  }
  EXPECT_GT(through, 5U);
  EXPECT_LT(through, 40U);
}

TEST(Piercing, AThicknessAboveTheEdgesIsWarnedOf) {
  const char* const text =
      "duration: 1\nsolver: {{type: rk4, timestep: 0.001}}\ncloth: [{{rows: 5, columns: 5, "
      "row_edge: [1, 0, 0], column_edge: [0, 1, 0], mass: 1, structural: {{stiffness: 10}}, "
      "self_contact: {{thickness: {}, stiffness: 10}}}}]\n";
  EXPECT_TRUE(scene::read_scene("s.yaml", fmt::format(fmt::runtime(text), 0.2)).warnings.empty());
  const auto warnings = scene::read_scene("s.yaml", fmt::format(fmt::runtime(text), 0.3)).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("the thickness, 0.3 m, is above the shortest edge, 0.25 m"),
            std::string::npos)
      << warnings[0];
}

}  // namespace
}  // namespace odeum::piercing_test
