// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {

class Surfaces;

/// The term of a scene's surfaces.
std::unique_ptr<Term> make_surface_contact(const Scene& scene);
/// The surfaces of such a term without friction, whose derivatives SurfaceStiffness has; null for
/// others.
const Surfaces* frictionless_surfaces(const Term& term);

}  // namespace odeum::scene
