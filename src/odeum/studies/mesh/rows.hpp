// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/studies/study.hpp"

namespace odeum::study {

/// One square sheet of particles and springs: a line of mesh.csv. Every sheet has the same edge
/// (1 m), mass (1 kg, in equal parts) and, at the coarsest mesh, stiffness of a spring (200 N/m).
struct MeshRow {
  std::string springs;  ///< structural, shear (and structural), bend (and both)
  /// How the stiffness of a spring follows the mesh: `constant`, `per_length` (k ~ 1 / length, as
  /// of a thread cut shorter) or `per_count` (k ~ 1 / springs along an edge).
  std::string scaling;
  std::string status, detail;
  std::size_t particles = 0;  ///< along an edge
  double stiffness = nan;     ///< of a spring, N/m
  double extension = nan;     ///< hung by its upper edge, mean over the lower one, m
  double period = nan;        ///< of its slowest vertical oscillation, s
  double sag = nan;  ///< of its centre line below two opposite edges that are held level, m
  /// How far its lowest particle hangs below the two upper corners that hold it, m; NaN without
  /// shear springs.
  double drape = nan;
  /// What every stiffness must be multiplied by for the extension of the coarsest mesh.
  double factor = nan;

  static constexpr const char* file = "mesh.csv";
  static constexpr const char* shown =
      "springs scaling particles stiffness extension:.4f period:.4f sag:.4f drape:.4f factor:.3f "
      "status";
  ODEUM_COLUMNS(springs, scaling, status, detail, particles, stiffness, extension, period, sag,
                drape, factor)
};

inline constexpr double sheet_edge = 1, sheet_mass = 1;  ///< m, kg

struct MeshResult {
  std::vector<MeshRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

inline constexpr int coarsest_mesh = 6;  ///< particles along an edge
inline const Option finest_mesh =
    whole_number("most", coarsest_mesh, 192, "particles along an edge of the finest", 96);

/// Equilibria by relaxation and periods by undamped runs of meshes from the coarsest to the finest,
/// each twice as fine as the one before. Throws Interrupted.
MeshResult measure_mesh(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
