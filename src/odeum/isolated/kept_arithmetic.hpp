// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace odeum::isolated {

/// How this thread rounds and whether it flushes subnormal numbers to zero, without the flags of
/// what has happened.
class Arithmetic {
 public:
  void set() const;
  bool operator==(const Arithmetic&) const = default;

 private:
#if defined(__SSE2__)
  static unsigned short extended_now() {
    unsigned short word = 0;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    return word;
  }
  unsigned vectors_ = _mm_getcsr() & ~0x3FU;
  unsigned short extended_ = extended_now();
#elif defined(__aarch64__)
  static unsigned long control_now() {
    unsigned long word = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return word;
  }
  unsigned long control_ = control_now();
#else
  int rounding_ = std::fegetround();
#endif
};

inline void Arithmetic::set() const {
#if defined(__SSE2__)
  _mm_setcsr(vectors_);
  __asm__ volatile("fldcw %0" : : "m"(extended_));
#elif defined(__aarch64__)
  __asm__ volatile("msr fpcr, %0" : : "r"(control_));
#else
  std::fesetround(rounding_);
#endif
}

/// Keeps the arithmetic of this thread: at the end of its life that is as at its start, whatever
/// foreign code has changed, as the start of code that is compiled with -Ofast does.
class KeptArithmetic {
 public:
  KeptArithmetic() = default;
  ~KeptArithmetic() {
    if (before_ != Arithmetic()) before_.set();
  }
  KeptArithmetic(const KeptArithmetic&) = delete;
  KeptArithmetic& operator=(const KeptArithmetic&) = delete;

 private:
  Arithmetic before_;
};

}  // namespace odeum::isolated
