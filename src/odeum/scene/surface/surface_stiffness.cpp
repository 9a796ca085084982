// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/surface/surface_stiffness.hpp"

#include <utility>

#include "odeum/scene/surface/near_pairs.hpp"
#include "odeum/scene/surface/slopes.hpp"

namespace odeum::scene {
namespace {

using Real = Slopes<9, Lanes>;

Vec<Real> unknowns_of(const Vec<Lanes>& x, std::size_t first) {
  return {Real(x[0], first), Real(x[1], first + 1), Real(x[2], first + 2)};
}

/// phi''(d).
Lanes curvature(const SelfContact& law, const Lanes& d) {
  const Lanes x = d / law.thickness, rest = 1 - x;
  return 0.8 * law.stiffness * rest * rest * (1 + x * (2 + 3 * x)) / (x * x * x);
}

}  // namespace

void SurfaceStiffness::assemble(const double* q, bool clamped) {
  to_quads(q, particles(), places_);
  pairs_.clear();
  const auto use = [&](const PairLanes& lanes, const LaneMask& mask, const Apart<Lanes>& plain) {
    Pairs& pairs = pairs_.emplace_back(Pairs{lanes, {}});
    const SurfacePair& one = lanes.first();
    const SelfContact& law = surfaces_.law(one.law);
    const Lanes none(0);
    std::size_t entry = 0;
    const auto add = [&](const auto& derivative) {
      for (std::size_t row = 0; row < unknowns; ++row)
        for (std::size_t column = row; column < unknowns; ++column)
          pairs.entries[entry++] = select(mask, derivative(row, column), none);
    };
    if (clamped) {
      // The distance grows by n (dr - u de1 - v de2).
      const Lanes scale = plain.weight * curvature(law, plain.distance);
      const Lanes factors[] = {Lanes(1), -plain.u, -plain.v};
      return add([&](std::size_t row, std::size_t column) {
        return -(scale * (factors[row / 3] * plain.normal[row % 3]) *
                 (factors[column / 3] * plain.normal[column % 3]));
      });
    }
    Vec<Lanes> e1, e2, r;
    lanes.differences(places_, e1, e2, r);
    Apart<Real> apart;
    meet(one, law, unknowns_of(e1, 3), unknowns_of(e2, 6), unknowns_of(r, 0), apart);
    const Vec<Real>* const on[] = {&apart.on_r, &apart.on_e1, &apart.on_e2};
    add([&](std::size_t row, std::size_t column) { return (*on[row / 3])[row % 3].by[column]; });
  };
  MeetingPairs(surfaces_, places_, use).visit(NearPairs::of_thread().at(surfaces_, q));
}

void SurfaceStiffness::add_product(const Quads& x, double factor, Quads& product) const {
  const Lanes all(factor);
  for (const Pairs& pairs : pairs_) {
    Vec<Lanes> in[3], out[3];
    pairs.lanes.differences(x, in[1], in[2], in[0]);
    for (std::size_t row = 0; row < unknowns; ++row) {
      Lanes sum = pairs.at(row, 0) * in[0][0];
      for (std::size_t column = 1; column < unknowns; ++column)
        sum += pairs.at(row, column) * in[column / 3][column % 3];
      out[row / 3][row % 3] = all * sum;
    }
    pairs.lanes.add_to(product, pairs.lanes.mask(), pairs.lanes.forces_of(out[0], out[1], out[2]));
  }
}

void SurfaceStiffness::add_diagonal(double factor,
                                    std::vector<std::array<double, 6>>& blocks) const {
  constexpr std::pair<std::size_t, std::size_t> entries[] = {{0, 0}, {0, 1}, {0, 2},
                                                             {1, 1}, {1, 2}, {2, 2}};
  for (const Pairs& pairs : pairs_) {
    const Shares share = shares_of(pairs.lanes.first().kind);
    for (std::size_t k = 0; k < 4; ++k) {
      const double shares[] = {share.r[k], share.e1[k], share.e2[k]};
      for (std::size_t e = 0; e < 6; ++e) {
        Lanes sum(0);
        for (std::size_t f = 0; f < 3; ++f)
          for (std::size_t x = 0; x < 3; ++x)
            if (const double both = factor * shares[f] * shares[x]; both != 0)
              sum += both * pairs.at(3 * f + entries[e].first, 3 * x + entries[e].second);
        for (std::size_t lane = 0; lane < pairs.lanes.count(); ++lane)
          blocks[pairs.lanes.particle(lane, k)][e] += sum[lane];
      }
    }
  }
}

}  // namespace odeum::scene
