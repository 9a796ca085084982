// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/core/guard.hpp"
#include "odeum/scene/model/scene.hpp"
#include "odeum/scene/problem/scene_problem.hpp"

class btSoftBody;

namespace odeum::adapters::bullet {

/// The terms of a scene that an engine has no kind of, as forces on the nodes of its body, computed
/// at the start of each step: uniform forces and penalty contacts as a scene's problem has them.
class Exerted {
 public:
  /// Exerts the terms of a scene other than gravity; its springs too where `springs` says so. A
  /// velocity matrix is left out.
  Exerted(const scene::Scene& scene, bool springs);

  bool any() const { return !problem_.structure().terms.empty(); }
  /// Calls add(particle, force) with the three components of the force on each free particle, N.
  /// `matrix` (1/s, row-major) adds the force m B v.
  template <class Add>
  void visit(double t, const btSoftBody& body, const scene::Mat3& matrix, Guard& guard,
             const Add& add) {
    compute(t, body, matrix, guard);
    const scene::Bodies& bodies = problem_.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (bodies.free(i)) {
        const double* const a = &a_[3 * i];
        const double m = bodies.mass[i];
        add(i, scene::Vec3{a[0] * m, a[1] * m, a[2] * m});
      }
  }

 private:
  void compute(double t, const btSoftBody& body, const scene::Mat3& matrix, Guard& guard);

  scene::SceneProblem problem_;
  std::vector<double> q_, v_, a_;
};

}  // namespace odeum::adapters::bullet
