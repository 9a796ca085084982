// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstring>
#include <vector>

#include "odeum/core/lanes.hpp"
#include "odeum/scene/surface/surfaces.hpp"

namespace odeum::scene {

/// x y z of particles, each in four numbers, which a vector register takes at once.
using Quads = std::vector<double>;
inline void to_quads(const double* x, std::size_t particles, Quads& quads) {
  quads.resize(4 * particles);
  for (std::size_t i = 0; i < particles; ++i)
    for (std::size_t d = 0; d < 3; ++d) quads[4 * i + d] = x[3 * i + d];
}

/// As many pairs as a vector register holds numbers at most, of one kind, law and radius.
class PairLanes {
 public:
  static constexpr std::size_t most = Lanes::count;
  using Forces = std::array<Vec<Lanes>, 4>;  ///< on each particle of a pair

  /// The first of the pairs up to `end` that fit together, at least one; the next one.
  const SurfacePair* take(const SurfacePair* pair, const SurfacePair* end) {
    for (clear(); pair != end && takes(*pair); ++pair) add(*pair);
    return pair;
  }
  bool takes(const SurfacePair& pair) const {
    return count_ == 0 || (count_ < most && pair.kind == first().kind && pair.law == first().law &&
                           pair.radius == first().radius);
  }
  void add(const SurfacePair& pair) {
    for (std::size_t k = 0; k < 4; ++k) places_[k][count_] = 4 * pair.x[k];
    pairs_[count_++] = &pair;
  }
  void clear() { count_ = 0; }
  std::size_t count() const { return count_; }
  const SurfacePair& operator[](std::size_t lane) const { return *pairs_[lane]; }
  const SurfacePair& first() const { return *pairs_[0]; }
  std::size_t particle(std::size_t lane, std::size_t k) const { return places_[k][lane] / 4; }
  /// The lanes that hold a pair.
  LaneMask mask() const {
    LaneMask mask{};
    for (std::size_t lane = 0; lane < count_; ++lane) mask.set(lane, true);
    return mask;
  }
  /// Lanes beyond the last have the numbers of the first. After the last add().
  void fill() {
    for (std::size_t lane = count_; lane < most; ++lane)
      for (auto& places : places_) places[lane] = places[0];
  }

  /// The differences e1, e2 and r of each pair, as of one pair.
  void differences(const Quads& q, Vec<Lanes>& e1, Vec<Lanes>& e2, Vec<Lanes>& r) const {
    const bool triangle = first().kind == SurfacePair::Kind::triangle;
    const Vec<Lanes> x0 = gather(q, 0), x1 = gather(q, 1), x2 = gather(q, 2), x3 = gather(q, 3);
    for (std::size_t d = 0; d < 3; ++d) {
      e1[d] = x1[d] - x0[d];
      e2[d] = x3[d] - (triangle ? x0[d] : x2[d]);
      r[d] = x2[d] - x0[d];
    }
  }
  /// The forces on the four particles that follow from forces on r, e1 and e2.
  Forces forces_of(const Vec<Lanes>& on_r, const Vec<Lanes>& on_e1, const Vec<Lanes>& on_e2) const {
    Forces forces;
    const Lanes none(0);
    for (std::size_t d = 0; d < 3; ++d) {
      forces[2][d] = on_r[d];
      if (first().kind == SurfacePair::Kind::corner) {
        forces[0][d] = -on_r[d], forces[1][d] = forces[3][d] = none;
        continue;
      }
      forces[1][d] = on_e1[d], forces[3][d] = on_e2[d];
      forces[0][d] = -on_r[d] - on_e1[d];
      if (first().kind == SurfacePair::Kind::triangle)
        forces[0][d] = forces[0][d] - on_e2[d];
      else
        forces[2][d] = forces[2][d] - on_e2[d];
    }
    return forces;
  }
  /// Adds them pair after pair, and none of the lanes beyond the last.
  void add_to(Quads& sum, const LaneMask& mask, const Forces& forces) const {
    alignas(vector_bytes) double quads[4][most][4];
    for (std::size_t k = 0; k < 4; ++k) to_quads(mask, forces[k], quads[k]);
    for (std::size_t lane = 0; lane < count_; ++lane)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t d = 0; d < 4; ++d) sum[places_[k][lane] + d] += quads[k][lane][d];
  }

 private:
  Vec<Lanes> gather(const Quads& q, std::size_t k) const {
    const double* const from = q.data();
    const auto& place = places_[k];
#if defined(__AVX512F__)
    // Two particles in a register, then the transposed of 4 x 4 blocks.
    const auto two = [&](std::size_t lane) {
      return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(from + place[lane])),
                                _mm256_loadu_pd(from + place[lane + 4]), 1);
    };
    const __m512d a = two(0), b = two(1), c = two(2), d = two(3);
    const __m512d low1 = _mm512_unpacklo_pd(a, b), high1 = _mm512_unpackhi_pd(a, b);
    const __m512d low2 = _mm512_unpacklo_pd(c, d), high2 = _mm512_unpackhi_pd(c, d);
    const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    return {Lanes(LaneVector(_mm512_permutex2var_pd(low1, first, low2))),
            Lanes(LaneVector(_mm512_permutex2var_pd(high1, first, high2))),
            Lanes(LaneVector(_mm512_permutex2var_pd(low1, second, low2)))};
#else
    Vec<Lanes> x{};
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t lane = 0; lane < most; ++lane) x[d].set(lane, from[place[lane] + d]);
    return x;
#endif
  }

  /// x y z and 0 of lane after lane.
  static void to_quads(const LaneMask& mask, const Vec<Lanes>& force, double (&quads)[most][4]) {
    const Lanes none(0), x = select(mask, force[0], none), y = select(mask, force[1], none),
                         z = select(mask, force[2], none);
#if defined(__AVX512F__)
    const __m512d zero = _mm512_setzero_pd(), vx = __m512d(x.v), vy = __m512d(y.v),
                  vz = __m512d(z.v);
    const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
    const __m512i second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
    const auto put = [&](std::size_t lane, __m512d xy, __m512d z0) {
      for (const auto& [at, order] : {std::pair{lane, first}, std::pair{lane + 4, second}}) {
        const __m512d two = _mm512_permutex2var_pd(xy, order, z0);
        _mm256_store_pd(quads[at], _mm512_castpd512_pd256(two));
        _mm256_store_pd(quads[at + 2], _mm512_extractf64x4_pd(two, 1));
      }
    };
    put(0, _mm512_unpacklo_pd(vx, vy), _mm512_unpacklo_pd(vz, zero));
    put(1, _mm512_unpackhi_pd(vx, vy), _mm512_unpackhi_pd(vz, zero));
#else
    for (std::size_t lane = 0; lane < most; ++lane)
      quads[lane][0] = x[lane], quads[lane][1] = y[lane], quads[lane][2] = z[lane],
      quads[lane][3] = 0;
#endif
  }

  std::array<const SurfacePair*, most> pairs_{};
  std::array<std::array<std::size_t, most>, 4> places_{};  ///< of the particles, in quads
  std::size_t count_ = 0;
};

/// Goes through pairs in their order: use(pairs, mask, apart) of those between which a force acts.
/// The numbers of a lane are those of its pair alone, rounded alike.
template <class Use>
class MeetingPairs {
 public:
  MeetingPairs(const Surfaces& surfaces, const Quads& q, const Use& use)
      : surfaces_(surfaces), q_(q), use_(use) {}

  void visit(const std::vector<SurfacePair>& pairs) {
    const SurfacePair* next = pairs.data();
    const SurfacePair* const end = next + pairs.size();
    while (next != end) {
      next = candidates_.take(next, end);
      sift();
    }
    meet_all();
  }

 private:
  /// Most pairs that may meet do not: those that do are gathered anew.
  void sift() {
    const SurfacePair& one = candidates_.first();
    LaneMask mask = candidates_.mask();
    if (one.kind != SurfacePair::Kind::corner) {
      candidates_.fill();
      candidates_.differences(q_, e1_, e2_, r_);
      Nearest<Lanes> at;
      mask = mask &
             is_near(meeting_of(one.kind), surfaces_.law(one.law), one.radius, e1_, e2_, r_, at);
      if (!any(mask)) return;
    }
    for (std::size_t lane = 0; lane < candidates_.count(); ++lane) {
      if (!mask[lane]) continue;
      if (!meeting_.takes(candidates_[lane])) meet_all();
      meeting_.add(candidates_[lane]);
    }
  }
  void meet_all() {
    if (meeting_.count() == 0) return;
    const SurfacePair& one = meeting_.first();
    meeting_.fill();
    meeting_.differences(q_, e1_, e2_, r_);
    Apart<Lanes> apart;
    const LaneMask mask = meeting_.mask() & meet(one, surfaces_.law(one.law), e1_, e2_, r_, apart);
    if (any(mask)) use_(meeting_, mask, apart);
    meeting_.clear();
  }

  const Surfaces& surfaces_;
  const Quads& q_;
  const Use& use_;
  PairLanes candidates_, meeting_;
  Vec<Lanes> e1_{}, e2_{}, r_{};
};

}  // namespace odeum::scene
