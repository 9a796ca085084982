// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <type_traits>

#include "odeum/core/lanes.hpp"

/// As many numbers as the widest vector register holds, in the compiler's own vector types.
namespace odeum::scene {
inline namespace ODEUM_LANES {

template <class Real>
struct Lanes {
  using Vector __attribute__((vector_size(vector_bytes))) = Real;
  static constexpr std::size_t count = vector_bytes / sizeof(Real);
};
template <class Real>
using Vector = typename Lanes<Real>::Vector;

/// At any address: loads and stores go through a type that asks for no alignment.
template <class Real>
[[gnu::always_inline]] inline Vector<Real> load(const Real* from) {
  using Anywhere __attribute__((vector_size(vector_bytes), aligned(alignof(Real)), may_alias)) =
      Real;
  return *reinterpret_cast<const Anywhere*>(from);
}
template <class Real>
[[gnu::always_inline]] inline void store(Real* to, Vector<Real> v) {
  using Anywhere __attribute__((vector_size(vector_bytes), aligned(alignof(Real)), may_alias)) =
      Real;
  *reinterpret_cast<Anywhere*>(to) = v;
}

/// A first guess of 1 / sqrt(x), x > 0: the relative error is below 2^-14 with AVX-512, 4 % else.
[[gnu::always_inline]] inline Vector<double> guess_inverse_sqrt(Vector<double> x) {
#if defined(__AVX512F__)
  return Vector<double>(_mm512_maskz_rsqrt14_pd(0xff, __m512d(x)));
#else
  using Bits __attribute__((vector_size(vector_bytes))) = long long;
  return Vector<double>(0x5fe6eb50c7b537a9 - (Bits(x) >> 1));
#endif
}
[[gnu::always_inline]] inline Vector<float> guess_inverse_sqrt(Vector<float> x) {
#if defined(__AVX512F__)
  return Vector<float>(_mm512_maskz_rsqrt14_ps(0xffff, __m512(x)));
#else
  using Bits __attribute__((vector_size(vector_bytes))) = int;
  return Vector<float>(0x5f375a86 - (Bits(x) >> 1));
#endif
}

/// 1 / sqrt(x) for normal x > 0, to about 2 roundings. With r = 1 - x y^2 for a guess y, the answer
/// is y (1 - r)^(-1/2), whose series in r is cut where r^n is a rounding. A square root and a
/// division cost several times as much.
template <class Real>
[[gnu::always_inline]] inline Vector<Real> inverse_sqrt(Vector<Real> x) {
  Vector<Real> y = guess_inverse_sqrt(x);
#if !defined(__AVX512F__)
  for (int i = 0; i < 2; ++i) y += Real(0.5) * y * (Real(1) - x * y * y);  // 4 % to 4e-6
#endif
  const Vector<Real> r = Real(1) - x * y * y;
  if constexpr (std::is_same_v<Real, float>) return y + y * r * Real(0.5);
  return y + y * r * (Real(0.5) + r * (Real(0.375) + r * Real(0.3125)));
}

template <class Real>
[[gnu::always_inline]] inline Vector<Real> larger(Vector<Real> a, std::type_identity_t<Real> b) {
  return a > b ? a : b;
}

}  // namespace ODEUM_LANES
}  // namespace odeum::scene
