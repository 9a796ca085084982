// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/fem/second_order_pde.hpp"
#include "odeum/formula/parser.hpp"

namespace odeum::fem::classify_test {
namespace {

PdePoint point_of(const std::string& text, double x = 0, double y = 0) {
  return SecondOrderPde(text).at(x, y);
}
PdeType type_of(const std::string& text, double x = 0, double y = 0) {
  return point_of(text, x, y).type;
}
std::string error_of(const std::string& text) {
  try {
    const SecondOrderPde pde(text);
  } catch (const formula::ExpressionError& error) {
    return std::to_string(error.at()) + ' ' + error.what();
  }
  return "no error";
}

TEST(Classify, TheEquationsOfTextbooks) {
  EXPECT_EQ(type_of("u_xx + u_yy = 0"), PdeType::elliptic);
  EXPECT_EQ(type_of("u_xx + u_yy + 3*u = sin(x)"), PdeType::elliptic);
  EXPECT_EQ(type_of("u_t = u_xx"), PdeType::parabolic);
  EXPECT_EQ(type_of("u_tt = 4*u_xx"), PdeType::hyperbolic);
  EXPECT_EQ(type_of("u_xy = 0"), PdeType::hyperbolic);
  EXPECT_EQ(type_of("y*u_xx + u_yy = 0", 0, 2), PdeType::elliptic);
  EXPECT_EQ(type_of("y*u_xx + u_yy = 0", 0, -2), PdeType::hyperbolic);
  EXPECT_EQ(type_of("y*u_xx + u_yy = 0", 3, 0), PdeType::parabolic);
  EXPECT_EQ(type_of("x*u_x + u = 1"), PdeType::first_order);
  EXPECT_EQ(type_of("u_xx/x + u_yy"), PdeType::undefined);
  // Nonlinear in lower terms alone: semilinear.
  EXPECT_EQ(type_of("u_xx + u_yy = exp(u) + u_x^2"), PdeType::elliptic);
  EXPECT_EQ(SecondOrderPde("if(x == 0, u_tt, 1) = 0").second(), "t");
}

TEST(Classify, LimitsAreNotLostToRounding) {
  EXPECT_EQ(type_of("0.1*u_xx + 0.2*u_xy + 0.1*u_yy = u_x"), PdeType::parabolic);
  EXPECT_EQ(type_of("u_xx + 2*u_xy + (1 + 1e-15)*u_yy"), PdeType::elliptic);
  EXPECT_EQ(type_of("u_xx + 2*u_xy + (1 - 1e-15)*u_yy"), PdeType::hyperbolic);
  EXPECT_EQ(type_of("1e-300*u_xx - 1e-300*u_yy"), PdeType::hyperbolic) << "no underflow";
  EXPECT_EQ(type_of("1e300*u_xx + 1e300*u_yy"), PdeType::elliptic) << "no overflow";
  EXPECT_EQ(type_of("1e-300*u_xy"), PdeType::hyperbolic);
}

// a dy^2 - b dx dy + c dx^2 = 0.
TEST(Classify, CharacteristicsFulfilTheirEquation) {
  for (const char* text :
       {"u_tt = 4*u_xx", "u_xy = 0", "u_xx + 3*u_xy", "3*u_xy - u_yy", "u_xx - 1e8*u_xy + u_yy",
        "u_t = u_xx", "u_x = u_yy", "u_xx + 2*u_xy + u_yy = u_x"}) {
    const PdePoint point = point_of(text);
    EXPECT_EQ(point.characteristics.size(), point.type == PdeType::hyperbolic ? 2U : 1U) << text;
    const auto a = static_cast<double>(point.a), b = static_cast<double>(point.b),
               c = static_cast<double>(point.c);
    for (const auto& [dx, dy] : point.characteristics) {
      EXPECT_NEAR(std::hypot(dx, dy), 1, 1e-15) << text;
      // Rounding of the directions and of three terms.
      EXPECT_LE(std::abs(a * dy * dy - b * dx * dy + c * dx * dx),
                4e-16 * (std::abs(a * dy * dy) + std::abs(b * dx * dy) + std::abs(c * dx * dx)))
          << text;
    }
  }
  // x - 2 t and x + 2 t are constant along those of the wave equation.
  EXPECT_NEAR(std::abs(point_of("u_tt = 4*u_xx").characteristics[0][1] /
                       point_of("u_tt = 4*u_xx").characteristics[0][0]),
              0.5, 1e-15);
}

TEST(Classify, DegenerateEquationsAreTold) {
  EXPECT_FALSE(point_of("u_t = u_xx").degenerate);
  EXPECT_TRUE(point_of("u_xx + u_x = 0").degenerate) << "no derivative by y";
  EXPECT_FALSE(point_of("u_xx + u_y = 0").degenerate);
  EXPECT_TRUE(point_of("u_xx + 2*u_xy + u_yy = u_x + u_y").degenerate);
  EXPECT_FALSE(point_of("u_xx + 2*u_xy + u_yy = u_x - u_y").degenerate);
  EXPECT_FALSE(SecondOrderPde("1", "0", "0").at(0, 0).degenerate) << "lower terms are not known";
}

TEST(Classify, WhatHasNoTypeOfItsOwnIsRefused) {
  EXPECT_NE(error_of("u*u_xx + u_yy").find("quasilinear"), std::string::npos);
  EXPECT_NE(error_of("u_xx*u_yy - u_xy^2 = 1").find("not linear"), std::string::npos);
  EXPECT_EQ(error_of("u_xx = u_yy = 1").substr(0, 2), "12");
  EXPECT_EQ(error_of("u_xx + z").substr(0, 2), "7 ");
  EXPECT_EQ(error_of("u_xx = 2*(u_yy").substr(0, 2), "14");
  EXPECT_NE(error_of("u_tt = u_yy").find("u_yy"), std::string::npos) << "x and t only";
}

TEST(Classify, TheCurveWhereTheTypeChangesIsFound) {
  // Elliptic inside of the circle of radius 1/2; no node of the grid is on it.
  const PdeMap map =
      map_types(SecondOrderPde("u_xx + (0.25 - x^2 - y^2)*u_yy"), {-1, 1, -1, 1}, 51);
  EXPECT_GT(map.changes.size(), 60U);
  for (const auto& [x, y] : map.changes) EXPECT_NEAR(std::hypot(x, y), 0.5, 1e-14);
  EXPECT_NEAR(map.share(PdeType::elliptic), 3.14159 / 16, 0.01);
  EXPECT_EQ(map.share(PdeType::parabolic), 0);
  // Along a line of the grid itself.
  const PdeMap tricomi = map_types(SecondOrderPde("y", "0", "1"), {-1, 1, -1, 1}, 10);
  ASSERT_EQ(tricomi.changes.size(), 11U);
  for (const auto& [x, y] : tricomi.changes) EXPECT_EQ(y, 0);
  // A pole changes the sign without a curve on which the equation is parabolic.
  EXPECT_TRUE(map_types(SecondOrderPde("1/x", "0", "1"), {-1, 1, -1, 1}, 10).changes.empty());
  EXPECT_TRUE(map_types(SecondOrderPde("u_t = u_xx"), {-1, 1, 0, 1}, 10).changes.empty());
  EXPECT_THROW(map_types(SecondOrderPde("u_xx"), {1, -1, 0, 1}, 10), std::invalid_argument);
}

}  // namespace
}  // namespace odeum::fem::classify_test
