// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::tests {

/// A scene of two free particles a metre apart, six lines.
inline constexpr const char* two_particles =
    "gravity: 0\nduration: 1\nsolver: {type: rk4, timestep: 0.01}\nparticles:\n"
    "  - {pos: [0, 0, 0], mass: 1}\n  - {pos: [1, 0, 0], mass: 2}\n";

/// The same with more keys after it.
inline std::string with_particles(const std::string& more) { return two_particles + more; }

}  // namespace odeum::tests
