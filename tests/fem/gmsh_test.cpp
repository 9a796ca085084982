// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "fuzz/read_any_mesh.hpp"
#include "odeum/fem/field_files.hpp"
#include "odeum/fem/shapes.hpp"
#include "support/damage.hpp"
#include "support/gmsh_text.hpp"

namespace odeum::fem::gmsh_test {
namespace {

using tests::gmsh_square;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string error_of(const std::string& text) {
  try {
    read_gmsh("f", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Gmsh, ReadsNodesTrianglesAndGroups) {
  const GmshMesh read = read_gmsh("f", gmsh_square);
  ASSERT_EQ(read.mesh.nodes.size(), 4U);
  ASSERT_EQ(read.mesh.triangles.size(), 2U);
  EXPECT_EQ(read.mesh.nodes[2].y, 1);
  EXPECT_EQ(read.mesh.triangles[1], (std::array<std::size_t, 3>{0, 2, 3}));
  EXPECT_EQ(read.groups, std::vector<std::string>{"lower edge"});
  EXPECT_TRUE(read.in_group({1, 0}, "lower edge"));
  EXPECT_FALSE(read.in_group({1, 2}, "lower edge"));
  EXPECT_FALSE(read.in_group({0, 1}, "plate")) << "of the surface";
}

TEST(Gmsh, ReadsBackAMesh) {
  const TriangleMesh mesh = unstructured_square(7, 3);
  const TriangleMesh read = read_gmsh("f", tests::gmsh_text(mesh)).mesh;
  EXPECT_EQ(read.triangles, mesh.triangles);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_EQ(distance(read.nodes[i], mesh.nodes[i]), 0);
  // One that is seen from below.
  TriangleMesh turned = mesh;
  for (auto& ids : turned.triangles) std::swap(ids[0], ids[1]);
  EXPECT_NO_THROW(check(read_gmsh("f", tests::gmsh_text(turned)).mesh));
}

TEST(Gmsh, BadMeshesAreRefusedWithTheLine) {
  const auto error = [](const std::string& what, const std::string& by) {
    return error_of(replaced(gmsh_square, what, by));
  };
  EXPECT_EQ(error("4 1 3 4", "4 1 4 3"), "f:36:1: triangle 4 is inverted: its nodes run clockwise");
  EXPECT_EQ(error("4 1 3 4", "4 1 3 3"), "f:36:1: triangle 4 has a node twice");
  EXPECT_EQ(error("0 1 0 0 1\n$EndNodes", "0.5 0.5 0 0 1\n$EndNodes"),
            "f:36:1: triangle 4 is degenerate: its nodes lie on a line");
  EXPECT_EQ(error("4 1 3 4", "4 2 3 1"), "f:36:1: triangle 4 is a duplicate of triangle 3");
  EXPECT_EQ(error("4 1 3 4", "4 1 3 8"),
            "f:36:7: element refers to node 8, which the file does not define (4 nodes read)");
  EXPECT_EQ(error("2 5 2 2\n3 1 2 3\n4 1 3 4", "2 5 2 1\n3 1 2 3"),
            "f:29:3: the number of elements: got 4, but 3 follow");
  EXPECT_EQ(
      error_of(replaced(replaced(gmsh_square, "2 5 2 2\n3 1 2 3\n4 1 3 4", "2 5 2 1\n3 1 2 3"),
                        "3 4 1 4", "3 3 1 4")),
      "f:26:1: node 4 belongs to no triangle");
  EXPECT_EQ(error("4 1 3 4", "3 1 3 4"), "f:36:1: element 3 is there twice");
  EXPECT_EQ(error("3\n4\n1 1", "3\n1\n1 1"), "f:24:1: node 1 is there twice")
      << "in the next block";
}

TEST(Gmsh, OtherFilesAreRefusedWithTheLine) {
  const auto error = [](const std::string& what, const std::string& by) {
    return error_of(replaced(gmsh_square, what, by));
  };
  EXPECT_EQ(error_of("x: 1"),
            "f:1:1: the file: not understood; got x:, expected $ and the name of a section");
  EXPECT_EQ(error_of(""),
            "f:1:1: the file: not understood; got the end of the file, expected $MeshFormat: a "
            "mesh of Gmsh");
  EXPECT_NE(
      error("4.1 0", "2.2 0").find("f:2:1: the version: not understood; got 2.2, expected 4.1"),
      std::string::npos);
  EXPECT_NE(error("4.1 0", "4.1 1").find("f:2:5: the kind of file"), std::string::npos);
  EXPECT_NE(error("2 5 2 2", "2 5 3 2").find("got 3, a quadrangle"), std::string::npos);
  EXPECT_NE(error("1 1 0 1 1", "1 1 2 1 1").find("f:25:1: node 3 has z = 2"), std::string::npos);
  EXPECT_NE(error("1 1 0 1 1", "1 inf 0 1 1").find("f:25:3: a coordinate"), std::string::npos);
  EXPECT_NE(error("$EndNodes", "$EndNode").find("expected $EndNodes"), std::string::npos);
  EXPECT_NE(error("\"plate\"", "plate").find("f:7:5: a physical name"), std::string::npos);
  EXPECT_NE(error("2 4 1 4", "2 99999999999999999999 1 4").find("f:16:3: the number of nodes"),
            std::string::npos);
  EXPECT_NE(error("2 5 1 2", "2 5 1 999999999999").find("node 1 is there twice"), std::string::npos)
      << "a count beyond the file costs no memory";
}

TEST(Gmsh, DamagedMeshesAreReadOrRefused) {
  std::mt19937 random(16);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same run each time
  constexpr std::string_view pieces[] = {"-1",
                                         "1e999",
                                         "nan",
                                         "$",
                                         "$Nodes\n",
                                         "\"",
                                         "0",
                                         " ",
                                         "\n",
                                         "4",
                                         "2",
                                         "\xff",
                                         "18446744073709551615",
                                         "$End"};
  std::size_t read = 0;
  for (const std::string& whole : {std::string(gmsh_square), tests::gmsh_text(unit_square(2))})
    for (int k = 0; k < 4000; ++k) {
      const std::string text = tests::damaged(whole, pieces, random);
      ASSERT_TRUE(fuzz::read_any_mesh(text)) << text;
      read += error_of(text) == "no error";
    }
  EXPECT_GT(read, 100U) << "not all damage is fatal";
}

TEST(Vtk, HasTheMeshAndItsFields) {
  const TriangleMesh mesh{{{0, 0}, {1, 0}, {0, 0.5}}, {{0, 1, 2}}};
  EXPECT_EQ(vtk_of(mesh, "a title\nof two lines", {{"u", {1, 2, 0.1}}}),
            "# vtk DataFile Version 3.0\na title of two lines\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 3 double\n0 0 0\n1 0 0\n0 0.5 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n"
            "POINT_DATA 3\nSCALARS u double 1\nLOOKUP_TABLE default\n1\n2\n0.1\n");
}

}  // namespace
}  // namespace odeum::fem::gmsh_test
