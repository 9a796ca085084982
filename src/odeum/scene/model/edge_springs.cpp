// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "odeum/scene/model/spring_law.hpp"
#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {

EdgeSprings::EdgeSprings(const char* name, std::vector<Spring> springs)
    : name_(name), springs_(std::move(springs)) {
  std::ranges::stable_sort(springs_, [](const Spring& l, const Spring& r) { return l.a < r.a; });
}

TermInfo EdgeSprings::info(const Bodies&) const {
  TermInfo info{.name = name_, .law = {}, .count = springs_.size(), .unit = "springs"};
  bool axial = false;
  info.linear = true;
  for (const Spring& spring : springs_) {
    info.velocity_dependent |= spring.damping != 0;
    axial |= spring.axial && spring.damping != 0;
    info.linear &= spring.rest_length == 0 && !spring.tension_only;
    if (spring.tension_only) info.order_kept = order_at_kinks;
  }
  info.linear &= !axial;
  info.law = axial                     ? "[k (l - L) + d (w.u)] u"
             : info.velocity_dependent ? "k (l - L) u + d (v_b - v_a)"
                                       : "k (l - L) u";
  return info;
}

void EdgeSprings::add(const Bodies&, const double* q, const double* v, double* force) const {
  add_spring_forces(springs_, q, v, force);
}

void EdgeSprings::add_blocks(const Bodies&, const double* q, const double* v,
                             BlockSink& sink) const {
  for (const Spring& spring : springs_) {
    const std::size_t a = 3 * spring.a, b = 3 * spring.b;
    const auto [x, y] =
        spring_derivatives(spring, difference(q + a, q + b), difference(v + a, v + b));
    sink.add_pair(spring.a, spring.b, x, y);
  }
}

double EdgeSprings::potential(const Bodies&, const double* q) const {
  double sum = 0;
  for (const Spring& spring : springs_)
    sum += spring_energy(spring, difference(q + 3 * spring.a, q + 3 * spring.b));
  return sum;
}

}  // namespace odeum::scene
