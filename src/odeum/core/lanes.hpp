// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

// Units compiled for wider vectors than the rest of the program have these under a name of their
// own.
#if defined(__AVX512F__)
#define ODEUM_LANES lanes_64
#elif defined(__AVX__)
#define ODEUM_LANES lanes_32
#else
#define ODEUM_LANES lanes_16
#endif

// Functions of all lanes at once from glibc's libmvec (part of -lm), which is within 4 units in the
// last place where the scalar ones are within 1. Others, and other systems, take lane after lane.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(ODEUM_SCALAR_FUNCTIONS)
#if __GLIBC_PREREQ(2, 35)
#define ODEUM_VECTOR_FUNCTIONS
#endif
#endif

namespace odeum {
inline namespace ODEUM_LANES {

/// The bytes of the widest vector register.
#if defined(__AVX512F__)
inline constexpr std::size_t vector_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t vector_bytes = 32;
#else
inline constexpr std::size_t vector_bytes = 16;  // SSE2, NEON
#endif

using LaneVector __attribute__((vector_size(vector_bytes))) = double;
using LaneBits __attribute__((vector_size(vector_bytes))) = std::int64_t;

// clang-format off
#define ODEUM_EACH_FUNCTION(ONE, TWO)                                           \
  ONE(sin) ONE(cos) ONE(tan) ONE(asin) ONE(acos) ONE(atan) ONE(sinh) ONE(cosh)  \
  ONE(tanh) ONE(exp) ONE(log) ONE(log10) ONE(cbrt)                              \
  TWO(pow) TWO(atan2) TWO(hypot)
// clang-format on
#ifdef ODEUM_VECTOR_FUNCTIONS
#if defined(__AVX512F__)
#define ODEUM_VECTOR_NAME(arguments, name) _ZGVeN8##arguments##_##name
#elif defined(__AVX2__)
#define ODEUM_VECTOR_NAME(arguments, name) _ZGVdN4##arguments##_##name
#elif defined(__AVX__)
#define ODEUM_VECTOR_NAME(arguments, name) _ZGVcN4##arguments##_##name
#else
#define ODEUM_VECTOR_NAME(arguments, name) _ZGVbN2##arguments##_##name
#endif
extern "C" {
#define ODEUM_FUNCTION(name) LaneVector ODEUM_VECTOR_NAME(v, name)(LaneVector);
#define ODEUM_FUNCTION_OF_TWO(name) LaneVector ODEUM_VECTOR_NAME(vv, name)(LaneVector, LaneVector);
ODEUM_EACH_FUNCTION(ODEUM_FUNCTION, ODEUM_FUNCTION_OF_TWO)
#undef ODEUM_FUNCTION
#undef ODEUM_FUNCTION_OF_TWO
}
#endif

/// A truth value for each lane, which chooses among numbers: select(x < y, x, y).
struct LaneMask {
  LaneBits bits;
  bool operator[](std::size_t lane) const { return bits[lane] != 0; }
  void set(std::size_t lane, bool value) { bits[lane] = value ? -1 : 0; }
  [[gnu::always_inline]] friend LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return {a.bits & b.bits};
  }
  [[gnu::always_inline]] friend LaneMask operator!(const LaneMask& a) { return {~a.bits}; }
  friend bool any(const LaneMask& mask) { return !all(!mask); }
  /// Whether it is true in every lane.
  [[gnu::always_inline]] friend bool all(const LaneMask& mask) {
#if defined(__AVX512F__)
    return _mm512_test_epi64_mask(__m512i(mask.bits), __m512i(mask.bits)) == 0xff;
#elif defined(__AVX__)
    return _mm256_movemask_pd(__m256d(mask.bits)) == 0xf;
#elif defined(__SSE2__)
    return _mm_movemask_pd(__m128d(mask.bits)) == 0x3;
#else
    return mask[0] && mask[1];
#endif
  }
};

/// A number for the member in each lane of a vector register, in the compiler's own vector types:
/// the number type (`real`) of a problem whose members are computed together. Each lane is rounded
/// as a double is, but for functions of ODEUM_VECTOR_FUNCTIONS. Functions of <cmath> are found
/// where they are called without std::, after `using std::sin;`.
struct Lanes {
  static constexpr std::size_t count = vector_bytes / sizeof(double);
  LaneVector v;

  Lanes() = default;
  [[gnu::always_inline]] Lanes(double all) : v(LaneVector{} + all) {}
  [[gnu::always_inline]] explicit Lanes(LaneVector lanes) : v(lanes) {}
  double operator[](std::size_t lane) const { return v[lane]; }
  std::array<double, count> numbers() const { return std::bit_cast<std::array<double, count>>(v); }
  static Lanes of(const std::array<double, count>& numbers) {
    return Lanes(std::bit_cast<LaneVector>(numbers));
  }
  void set(std::size_t lane, double x) { v[lane] = x; }

#define ODEUM_OPERATOR(op)                                                          \
  [[gnu::always_inline]] friend Lanes operator op(const Lanes& a, const Lanes& b) { \
    return Lanes(a.v op b.v);                                                       \
  }                                                                                 \
  [[gnu::always_inline]] Lanes& operator op##=(const Lanes& b) {                    \
    v = v op b.v;                                                                   \
    return *this;                                                                   \
  }
  ODEUM_OPERATOR(+)
  ODEUM_OPERATOR(-)
  ODEUM_OPERATOR(*)
  ODEUM_OPERATOR(/)
#undef ODEUM_OPERATOR
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return Lanes(-a.v); }
#define ODEUM_COMPARISON(op)                                                           \
  [[gnu::always_inline]] friend LaneMask operator op(const Lanes& a, const Lanes& b) { \
    return {LaneBits(a.v op b.v)};                                                     \
  }
  ODEUM_COMPARISON(<)
  ODEUM_COMPARISON(<=)
  ODEUM_COMPARISON(>)
  ODEUM_COMPARISON(>=)
#undef ODEUM_COMPARISON
  /// Equal in all lanes.
  friend bool operator==(const Lanes& a, const Lanes& b) {
    return all(LaneMask{LaneBits(a.v == b.v)});
  }

  [[gnu::always_inline]] friend Lanes select(const LaneMask& m, const Lanes& a, const Lanes& b) {
    return Lanes(m.bits ? a.v : b.v);
  }
  [[gnu::always_inline]] friend Lanes abs(const Lanes& a) {
    return Lanes(LaneVector(LaneBits(a.v) & INT64_MAX));
  }
  [[gnu::always_inline]] friend Lanes min(const Lanes& a, const Lanes& b) {
    return select(b < a, b, a);
  }
  [[gnu::always_inline]] friend Lanes max(const Lanes& a, const Lanes& b) {
    return select(a < b, b, a);
  }
  [[gnu::always_inline]] friend Lanes sqrt(const Lanes& a) {
#if defined(__AVX512F__)
    return Lanes(LaneVector(_mm512_maskz_sqrt_pd(0xff, __m512d(a.v))));
#elif defined(__AVX__)
    return Lanes(LaneVector(_mm256_sqrt_pd(__m256d(a.v))));
#elif defined(__SSE2__)
    return Lanes(LaneVector(_mm_sqrt_pd(__m128d(a.v))));
#elif defined(__aarch64__)
    return Lanes(LaneVector(vsqrtq_f64(float64x2_t(a.v))));
#else
    return each_lane([](double x) { return std::sqrt(x); }, a);
#endif
  }

  /// f of the numbers of each lane.
  template <class F, class... More>
  static Lanes each_lane(F f, const Lanes& a, const More&... more) {
    Lanes result = 0;
    for (std::size_t lane = 0; lane < count; ++lane) result.set(lane, f(a[lane], more[lane]...));
    return result;
  }
#ifdef ODEUM_VECTOR_FUNCTIONS
#define ODEUM_FUNCTION(name) \
  friend Lanes name(const Lanes& a) { return Lanes(ODEUM_VECTOR_NAME(v, name)(a.v)); }
#define ODEUM_FUNCTION_OF_TWO(name)                      \
  friend Lanes name(const Lanes& a, const Lanes& b) {    \
    return Lanes(ODEUM_VECTOR_NAME(vv, name)(a.v, b.v)); \
  }
#else
#define ODEUM_FUNCTION(name)                                    \
  friend Lanes name(const Lanes& a) {                           \
    return each_lane([](double x) { return std::name(x); }, a); \
  }
#define ODEUM_FUNCTION_OF_TWO(name)                                             \
  friend Lanes name(const Lanes& a, const Lanes& b) {                           \
    return each_lane([](double x, double y) { return std::name(x, y); }, a, b); \
  }
#endif
  ODEUM_EACH_FUNCTION(ODEUM_FUNCTION, ODEUM_FUNCTION_OF_TWO)
#undef ODEUM_FUNCTION
#undef ODEUM_FUNCTION_OF_TWO
};

}  // namespace ODEUM_LANES

}  // namespace odeum
