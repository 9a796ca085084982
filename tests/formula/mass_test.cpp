// SPDX-License-Identifier: BSD-3-Clause
// Problems with a mass matrix: M v' = F.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_case.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::mass_test {
namespace {

using formula::Problem;

Case shipped(const std::string& name, const formula::Overrides& set = {}) {
  const std::string file = ODEUM_SOURCE_DIR "/cases/problems/" + name + ".yaml";
  return case_of(
      cases::text_statements(file, read_text_file(file, "problem", 100'000), name, set).front());
}

std::string fact(const Case& c, const std::string& name) {
  for (const auto& [key, text] : c.facts)
    if (key == name) return text;
  return "none";
}

// The coordinates of the second files are linear in those of the first.
void to_second(const std::string& name, const std::vector<double>& y, std::vector<double>& z) {
  const double scale = name == "two_masses" ? 1 : 1 / std::sqrt(2.0);
  const double sign = name == "two_masses" ? 1 : -1;
  for (std::size_t i = 0; i < 4; i += 2) {
    z[i] = scale * (y[i] + y[i + 1]);
    z[i + 1] = scale * sign * (y[i] - y[i + 1]);
  }
}

// One motion in two coordinates: the same accelerations, the same kinetic energy to nine digits.
TEST(MassMatrix, DoesNotChangeTheMotion) {
  for (const std::string name : {"two_masses", "double_elevator"})
    for (const formula::Overrides& set :
         {formula::Overrides{}, {{"m1", "7"}}, {{"m1", "2"}, {"m2", "2"}}}) {
      SCOPED_TRACE(name);
      const Case a = shipped(name, set), b = shipped(name + "_sum", set);
      EXPECT_EQ(fact(a, "kinetic"), fact(b, "kinetic"));
      EXPECT_TRUE(fact(a, "kinetic").starts_with("energy v M v / 2 = ")) << fact(a, "kinetic");
      // Elevators of equal masses have the same matrix in turned coordinates.
      if (set.empty()) {
        EXPECT_NE(fact(a, "mass"), fact(b, "mass"));
      }
      for (const double t : {0.0, 3.1}) {
        const std::vector<double> y{0.3, -0.7, 1.1, 0.4};
        std::vector<double> z(4), fy(4), fz(4), expected(4);
        to_second(name, y, z);
        a.problem.view.rhs(a.problem.view.problem, t, y.data(), fy.data());
        b.problem.view.rhs(b.problem.view.problem, t, z.data(), fz.data());
        to_second(name, fy, expected);
        // Some ten roundings of numbers up to 10.
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(fz[i], expected[i], 2e-14) << i;
      }
    }
}

TEST(MassMatrix, IsOfSecondOrder) {
  const Case made = shipped("two_masses_sum");
  EXPECT_EQ(made.tags, (std::vector<std::string>{"second_order", "separable"}));
  ASSERT_TRUE(made.energy);
  // The energy worked out by hand, in the positions of the masses.
  const double x1 = 0.75, x2 = 0.25, v1 = -0.15, v2 = 0.15;
  EXPECT_NEAR(made.energy(made.y0.data()),
              (v1 * v1 + 3 * v2 * v2 + 4 * x1 * x1 + 5 * x2 * x2 + 2 * (x1 - x2) * (x1 - x2)) / 2,
              1e-14);
}

struct Fault {
  const char *mass, *sentence;
};

TEST(MassMatrix, RefusesWhatIsNone) {
  const Fault faults[] = {
      {"{v: {v: 1, w: 0.5}, w: {v: 0.4, w: 1}}", "not symmetric"},
      {"{v: {v: 1, w: 2}, w: {v: 2, w: 1}}", "not positive definite"},
      {"{v: {v: -1}}", "not positive definite"},
      {"{v: {v: 0}}", "not positive definite"},
      {"{u: {v: 1}}", "no state; got u"},
      {"{v: {w: 1}}", "no row of that name; got w"},
      {"{v: {v: x}}", "unknown name; got x"},
      {"{v: 2}", "not a mapping"},
      {"{}", "empty"},
  };
  for (const Fault& fault : faults) {
    const std::string text = std::string("states: {x: 1, y: 0, v: 0, w: 0}\n") +
                             "equations: {x: v, y: w, v: -x, w: -y}\n" + "mass: " + fault.mass +
                             "\ntime: {end: 1}\n";
    try {
      formula::read_problem("f.yaml", text);
      ADD_FAILURE() << fault.mass;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(fault.sentence), std::string::npos) << error.what();
      EXPECT_TRUE(std::string(error.what()).starts_with("f.yaml:3:")) << error.what();
    }
  }
}

}  // namespace
}  // namespace odeum::mass_test
