// SPDX-License-Identifier: BSD-3-Clause
// odeum poisson and odeum classify as a user runs them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "odeum/fem/shapes.hpp"
#include "support/gmsh_text.hpp"
#include "support/page_data.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::poisson_command_test {
namespace {

using std::numbers::pi;
using tests::Result;
using tests::shell;

void expect_refused(const std::string& arguments, const std::string& sentence) {
  const Result result = shell("odeum " + arguments);
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_NE(result.output.find(sentence), std::string::npos) << result.output;
}

TEST(PoissonCommand, SolvesOnAMeshFileAndWritesVtk) {
  const tests::TemporaryFolder root;
  const std::string mesh = (root.path() / "a.msh").string(), out = (root.path() / "out").string();
  tests::write_text(mesh, tests::gmsh_text(fem::unstructured_square(8, 16)));
  const Result result =
      shell("odeum poisson " + mesh +
            " --load \"5*pi^2*sin(pi*x)*sin(2*pi*y)\" --exact \"sin(pi*x)*sin(2*pi*y)\" --refine 3 "
            "--out " +
            out);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("8192       3969"), std::string::npos) << result.output;
  // Orders 2 and 1 in the last line of the table.
  const std::size_t at = result.output.find("8192       3969");
  const std::string line = result.output.substr(at, result.output.find('\n', at) - at);
  const std::size_t orders = line.rfind("  ");
  double l2 = 0, h1 = 0;
  ASSERT_EQ(std::sscanf(line.c_str() + orders, "%lf, %lf", &l2, &h1), 2) << line;
  EXPECT_NEAR(l2, 2, 0.05);
  EXPECT_NEAR(h1, 1, 0.05);
  const std::string vtk = tests::text_of(out + "/solution.vtk");
  EXPECT_NE(vtk.find("CELL_TYPES 8192"), std::string::npos);
  EXPECT_NE(vtk.find("SCALARS error"), std::string::npos);
  // The page draws the same triangles.
  EXPECT_EQ(tests::json_of(out + "/page.json")["runs"]["kind"], "field");
  EXPECT_EQ(tests::table_in(out, "triangles")["rows"], 8192);
  const auto x = tests::column_in(out, "triangles", "x1"),
             y = tests::column_in(out, "triangles", "y1"),
             u = tests::column_in(out, "triangles", "u1"),
             error = tests::column_in(out, "triangles", "error1");
  for (std::size_t i = 0; i < 8192; ++i)
    EXPECT_NEAR(u[i].get<double>() - error[i].get<double>(),
                std::sin(pi * x[i].get<double>()) * std::sin(2 * pi * y[i].get<double>()), 1e-6);
}

TEST(PoissonCommand, APageOfAFineMeshSaysThatItIsNotDrawn) {
  const tests::TemporaryFolder root;
  const std::string out = (root.path() / "out").string();
  const Result result = shell("odeum poisson square:101 --load \"</script>\" --out " + out);
  EXPECT_EQ(result.code, 2) << "no expression";
  const Result fine = shell("odeum poisson square:101 --out " + out);
  EXPECT_EQ(fine.code, 0) << fine.output;
  EXPECT_EQ(tests::table_in(out, "triangles")["rows"], 0);
  const auto page = tests::json_of(out + "/page.json");
  EXPECT_EQ(page["runs"]["facts"][0][1], "square:101, 20402 triangles, too many to draw");
  EXPECT_NE(tests::text_of(out + "/solution.vtk").find("CELL_TYPES 20402"), std::string::npos);
  EXPECT_NE(tests::text_of(out + "/index.html").find("viewer/fields.js"), std::string::npos);
}

// u = 1 - y: 0 on the upper edge by a group, flux 1 through the lower one and 0 through the sides.
TEST(PoissonCommand, TakesGroupsAndFluxes) {
  const tests::TemporaryFolder root;
  const std::string mesh = (root.path() / "a.msh").string();
  tests::write_text(mesh, tests::gmsh_square);
  const std::string arguments = "poisson " + mesh +
                                " --load 0 --on \"lower edge\" --value 1 --flux \"if(y > 0.999, "
                                "-1, 0)\" --exact \"1 - y\" --refine 2";
  const Result result = shell("odeum " + arguments);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("u lies between "), std::string::npos) << result.output;
  // The solution is linear: the error is what the residual leaves, below 1e-9.
  const std::size_t line = result.output.find("        32 ");
  double l2 = 1;
  ASSERT_NE(line, std::string::npos) << result.output;
  ASSERT_EQ(std::sscanf(result.output.c_str() + line, "%*d %*d %*g %*d %*g %lf", &l2), 1);
  EXPECT_LT(l2, 1e-9);
  expect_refused("poisson " + mesh + " --on \"lower edgy\"", "did you mean lower edge?");
}

TEST(PoissonCommand, BadInputIsRefusedWithASentence) {
  expect_refused("poisson square:4 --load \"1/(x - 0.5)\" --a \"x - 0.6\"",
                 "the tensor a is not positive definite");
  expect_refused("poisson square:4 --load \"sqrt(x - 0.5)\"", "the load f is");
  expect_refused("poisson square:4 --on none", "no Dirichlet condition");
  expect_refused("poisson square:4 --on none --mean-zero", "add up to 1 instead of 0");
  expect_refused("poisson square:4 --mean-zero", "add --on none");
  expect_refused("poisson square:4 --load \"2*z\"", "--load, character 3: unknown name");
  expect_refused("poisson square:0", "with N from 1");
  expect_refused("poisson nowhere.msh", "nowhere.msh");
  const Result balanced = shell(
      "odeum poisson square:8 --on none --mean-zero --load \"cos(pi*x)\" "
      "--exact \"cos(pi*x)/pi^2\" --refine 2");
  EXPECT_EQ(balanced.code, 0) << balanced.output;
  const tests::TemporaryFolder root;
  const std::string mesh = (root.path() / "two.msh").string();
  fem::TriangleMesh two = fem::unit_square(1);
  for (const auto& p : fem::unit_square(1).nodes) two.nodes.push_back({p.x + 2, p.y});
  two.triangles.push_back({4, 5, 7}), two.triangles.push_back({4, 7, 6});
  tests::write_text(mesh, tests::gmsh_text(two));
  expect_refused("poisson " + mesh, "two.msh:29:1: the mesh is in more than one piece: triangle 3");
}

TEST(ClassifyCommand, TellsTheTypeAndDrawsIt) {
  const tests::TemporaryFolder root;
  const std::string out = (root.path() / "out").string();
  const Result tricomi = shell("odeum classify \"y*u_xx + u_yy = 0\" --out " + out);
  EXPECT_EQ(tricomi.code, 0) << tricomi.output;
  EXPECT_NE(tricomi.output.find("the type changes at 121 points"), std::string::npos);
  EXPECT_EQ(tests::text_of(out + "/classify.csv").substr(0, 12), "schema,x,y,t");
  const auto page = tests::json_of(out + "/page.json")["runs"];
  EXPECT_EQ(page["kind"], "types");
  EXPECT_EQ(page["title"], "y*u_xx + u_yy = 0");
  EXPECT_EQ(page["region"], nlohmann::json::array({-1, 1, -1, 1}));
  EXPECT_EQ(page["second"], "y");
  // A rectangle for each of 120 rows of cells, of the type of its lower edge.
  const auto types = tests::column_in(out, "types", "type"),
             low = tests::column_in(out, "types", "y0"),
             left = tests::column_in(out, "types", "x0"),
             right = tests::column_in(out, "types", "x1");
  ASSERT_EQ(types.size(), 120U);
  for (std::size_t i = 0; i < types.size(); ++i) {
    const double y = low[i];
    EXPECT_EQ(types[i], y < -1e-9 ? "hyperbolic" : y > 1e-9 ? "elliptic" : "parabolic") << y;
    EXPECT_EQ(left[i], -1);
    EXPECT_EQ(right[i], 1);
  }
  EXPECT_EQ(tests::table_in(out, "type_changes")["rows"], 121);
  // y dy^2 + dx^2 = 0: two directions below the axis, one on it, none above.
  const auto x = tests::column_in(out, "characteristics", "dx"),
             dy = tests::column_in(out, "characteristics", "dy"),
             at = tests::column_in(out, "characteristics", "y");
  ASSERT_GT(at.size(), 500U);
  for (std::size_t i = 0; i < at.size(); ++i) {
    EXPECT_LE(at[i].get<double>(), 1e-12);
    EXPECT_NEAR(
        at[i].get<double>() * std::pow(dy[i].get<double>(), 2) + std::pow(x[i].get<double>(), 2), 0,
        1e-7);
  }
  const Result numbers = shell("odeum classify 1 -2 1");
  EXPECT_NE(numbers.output.find("type             parabolic"), std::string::npos) << numbers.output;
  expect_refused("classify 1 2", "got 2 arguments");
  expect_refused("classify \"u*u_xx + u_yy\"", "quasilinear");
  expect_refused("classify \"u_xx + u_yz\"", "character 8: unknown name");
}

TEST(ClassifyCommand, PrintsTheMatrixOfOneStepBesideTheSlidesCriterion) {
  const Result result = shell(
      "odeum classify damped_oscillator_undamped --solver explicit_euler --solver implicit_euler "
      "--step 0.1");
  EXPECT_EQ(result.code, 0) << result.output;
  for (const char* line :
       {"A            [0 1; -5 0]", "solution     y = -5*cos(2.236067977*t)",
        "R            [1 0.1; -0.5 1]", "spectral radius 1.024695077, diverges as 1.024695077^n",
        "no divergence if 1 + h sqrt(K/m) < 1, here 1.22361", "1 - h sqrt(K/m) < 1, here 0.776393",
        "e^(h A) has 1, stays bounded"})
    EXPECT_NE(result.output.find(line), std::string::npos) << line << "\n" << result.output;
  expect_refused("classify lotka_volterra", "expected u' = A u + b");
  expect_refused("classify free_fall --step 0.1", "expected both or none");
  expect_refused("classify free_fall --solver cvode/bdf --step 0.1", "takes no fixed steps");
  expect_refused("classify \"u_xx + u_yy\" --step 0.1", "for a linear problem");
}

// What odeum converge does with problems that have a mesh in place of steps.
TEST(ConvergeCommand, MeasuresOrdersInTheMeshSize) {
  const tests::TemporaryFolder root;
  const std::string out = (root.path() / "out").string();
  const Result result = shell("odeum converge poisson_l_shape --out " + out);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("reentrant corner"), std::string::npos) << result.output;
  EXPECT_EQ(result.output.find("poisson_disc"), std::string::npos);
  EXPECT_NE(shell("odeum list cases").output.find("poisson_l_shape "), std::string::npos);
  expect_refused("drift --case \"poisson_l*\" --out " + out, "odeum converge measure");
  expect_refused("run poisson_disc --solver rk4 --step 0.1", "odeum converge measure");
}

}  // namespace
}  // namespace odeum::poisson_command_test
