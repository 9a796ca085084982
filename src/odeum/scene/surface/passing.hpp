// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/scene/surface/surfaces.hpp"

/// What the surfaces of a scene did where a method put them: a potential keeps the exact motion
/// from passing through, and no method.
namespace odeum::scene {

/// The pairs that touch at the places q, and the one that is deepest in its thickness.
struct Touching {
  std::size_t pairs = 0;
  double deepest = 0;    ///< the thickness less the distance, m
  double thickness = 0;  ///< of that pair
  SurfacePair pair;
};
/// Appends to `particles` those of the pairs, some of them several times.
Touching touching_at(const Surfaces& surfaces, const double* q,
                     std::vector<std::uint32_t>* particles = nullptr);

/// The pairs that pass through each other on straight ways from the places q to those of `to`: the
/// four points are in one plane at a root of a cubic, and the point is in the triangle then, or the
/// edges cross. A corner passes into a ball where it comes nearer to the centre than the radius.
std::vector<SurfacePair> passed_between(const Surfaces& surfaces, const double* q,
                                        const double* to);

}  // namespace odeum::scene
