// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <limits>
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

/// Loads from any address: loads and stores go through a type that asks for no alignment.
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

template <class Real>
using VectorBits __attribute__((vector_size(vector_bytes))) =
    std::conditional_t<sizeof(Real) == 8, long long, int>;

/// Whether the processor's instruction for a first guess of 1 / sqrt(x) is one for floats alone.
#if defined(__SSE2__) && !defined(__AVX512F__)
inline constexpr bool guessed_as_float = true;
#else
inline constexpr bool guessed_as_float = false;
#endif

/// The least x of inverse_sqrt; of a double that is `moderate`, if its guess is as a float.
template <class Real, bool moderate>
inline constexpr Real least_square = moderate&& guessed_as_float
                                         ? static_cast<Real>(std::numeric_limits<float>::min())
                                         : std::numeric_limits<Real>::min();

/// A first guess of 1 / sqrt(x) for normal x > 0, and a bound of its relative error. If x is
/// `moderate`, its exponent is one of a float, or the guess is 0 where it is larger.
inline constexpr double guess_error =
#if defined(__AVX512F__)
    0x1p-14;
#elif defined(__SSE2__)
    0x1.8p-12;
#elif defined(__aarch64__)
    0x1p-8;
#else
    0.035;
#endif
template <bool>
[[gnu::always_inline]] inline Vector<float> guess_inverse_sqrt(Vector<float> x) {
#if defined(__AVX512F__)
  return Vector<float>(_mm512_maskz_rsqrt14_ps(0xffff, __m512(x)));
#elif defined(__AVX__)
  return Vector<float>(_mm256_rsqrt_ps(__m256(x)));
#elif defined(__SSE2__)
  return Vector<float>(_mm_rsqrt_ps(__m128(x)));
#elif defined(__aarch64__)
  return Vector<float>(vrsqrteq_f32(float32x4_t(x)));
#else
  return Vector<float>(0x5f375a86 - (VectorBits<float>(x) >> 1));
#endif
}
template <bool moderate>
[[gnu::always_inline]] inline Vector<double> guess_inverse_sqrt(Vector<double> x) {
#if defined(__AVX512F__)
  return Vector<double>(_mm512_maskz_rsqrt14_pd(0xff, __m512d(x)));
#elif defined(__SSE2__)
  if constexpr (moderate) {
#if defined(__AVX__)
    return Vector<double>(_mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(__m256d(x)))));
#else
    return Vector<double>(_mm_cvtps_pd(_mm_rsqrt_ps(_mm_cvtpd_ps(__m128d(x)))));
#endif
  }
  // The guess of floats serves, which have fewer exponents: x = 4^k f with f in [1/2, 2), which
  // fits the lower half of each number as a float with the upper digits of x; k goes to the guess's
  // exponent.
  using Bits = VectorBits<double>;
  const Bits bits = Bits(x), float_of = ((bits >> 29) & 0xffffff) | 0x3f000000;
  const Bits guess = Bits(guess_inverse_sqrt<true>(Vector<float>(float_of)));
  return Vector<double>((guess << 29) + (0x57f0000000000000 - ((bits >> 1) & 0x3ff0000000000000)));
#elif defined(__aarch64__)
  return Vector<double>(vrsqrteq_f64(float64x2_t(x)));
#else
  return Vector<double>(0x5fe6eb50c7b537a9 - (VectorBits<double>(x) >> 1));
#endif
}

/// 1 / sqrt(x) for normal x > 0 (see guess_inverse_sqrt), to about 2 roundings. With r = 1 - x y^2
/// for a guess y, the answer is y (1 - r)^(-1/2), whose series in r is cut where r^n is a rounding.
/// A square root and a division cost several times as much.
template <class Real, bool moderate = false>
[[gnu::always_inline]] inline Vector<Real> inverse_sqrt(Vector<Real> x) {
  Vector<Real> y = guess_inverse_sqrt<moderate>(x);
  Vector<Real> r = Real(1) - x * y * y;
  if constexpr (guess_error > 1e-3) {
    y += y * r * (Real(0.5) + r * Real(0.375));  // to 2e-5 and better
    r = Real(1) - x * y * y;
  }
  constexpr bool longer = guess_error < 1e-3 && guess_error > 1e-4;
  if constexpr (std::is_same_v<Real, float>)
    return y + y * r * (longer ? Real(0.5) + r * Real(0.375) : Vector<Real>{} + Real(0.5));
  else
    return y + y * r *
                   (Real(0.5) + r * (Real(0.375) + r * (longer ? Real(0.3125) + r * Real(0.2734375)
                                                               : Vector<Real>{} + Real(0.3125))));
}

template <class Real>
[[gnu::always_inline]] inline Vector<Real> larger(Vector<Real> a, std::type_identity_t<Real> b) {
  return a > b ? a : b;
}

}  // namespace ODEUM_LANES
}  // namespace odeum::scene
