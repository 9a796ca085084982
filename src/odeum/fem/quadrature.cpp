// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/quadrature.hpp"

#include <cmath>

namespace odeum::fem {
namespace {

constexpr double third = 1. / 3;

Rule make_degree_5() {
  Rule rule{"degree_5", 5, {{{third, third, third}, 9. / 40}}};
  const double root = std::sqrt(15.);
  for (const double sign : {-1., 1.}) {
    const double a = (6 + sign * root) / 21, weight = (155 + sign * root) / 1200;
    rule.nodes.push_back({{a, a, 1 - 2 * a}, weight});
    rule.nodes.push_back({{a, 1 - 2 * a, a}, weight});
    rule.nodes.push_back({{1 - 2 * a, a, a}, weight});
  }
  return rule;
}

}  // namespace

const Rule& one_point_rule() {
  static const Rule rule{"one_point", 1, {{{third, third, third}, 1}}};
  return rule;
}

const Rule& vertex_rule() {
  static const Rule rule{"vertex", 1, {{{1, 0, 0}, third}, {{0, 1, 0}, third}, {{0, 0, 1}, third}}};
  return rule;
}

const Rule& degree_5_rule() {
  static const Rule rule = make_degree_5();
  return rule;
}

}  // namespace odeum::fem
