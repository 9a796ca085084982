// SPDX-License-Identifier: BSD-3-Clause
#include "exerted.hpp"

#include <BulletSoftBody/btSoftBody.h>

namespace odeum::adapters::bullet {
namespace {

scene::Scene terms_of(scene::Scene scene, bool springs) {
  scene.gravity = {};
  scene.velocity_matrix = {};
  if (!springs) scene.springs.clear();
  return scene;
}

}  // namespace

Exerted::Exerted(const scene::Scene& scene, bool springs)
    : problem_(terms_of(scene, springs)),
      q_(3 * scene.size()),
      v_(3 * scene.size()),
      a_(3 * scene.size()) {}

void Exerted::compute(double t, const btSoftBody& body, const scene::Mat3& matrix, Guard& guard) {
  for (std::size_t i = 0; i < a_.size(); ++i) {
    const btSoftBody::Node& node = body.m_nodes[static_cast<int>(i / 3)];
    q_[i] = node.m_x[static_cast<int>(i % 3)];
    v_[i] = node.m_v[static_cast<int>(i % 3)];
  }
  problem_.acceleration(t, q_.data(), v_.data(), a_.data());
  for (std::size_t i = 0; i < a_.size(); i += 3)
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        a_[i + row] += matrix[3 * row + column] * v_[i + column];
  guard.inspect(t, a_.data(), a_.size());
}

}  // namespace odeum::adapters::bullet
