// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "fuzz/has_place.hpp"
#include "odeum/fem/gmsh_reader.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::fuzz {

/// Whether the reader of meshes returns one that the check accepts, or an error that begins with
/// the place.
inline bool read_any_mesh(const std::string& text) {
  try {
    const fem::GmshMesh mesh = fem::read_gmsh("f", text);
    fem::check(mesh.mesh);
    for (const auto& line : mesh.lines)
      for (const std::size_t node : line.nodes)
        if (node >= mesh.mesh.nodes.size()) return false;
    return true;
  } catch (const InputError& error) {
    return has_place(error.what());
  }
}

}  // namespace odeum::fuzz
