// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {

/// The term of a scene's surfaces.
std::unique_ptr<Term> make_surface_contact(const Scene& scene);

}  // namespace odeum::scene
