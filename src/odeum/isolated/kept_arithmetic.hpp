// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace odeum::isolated {

/// Keeps how this thread rounds and whether it flushes subnormal numbers to zero: at the end of its
/// life they are as at its start, whatever foreign code has changed, as the start of code that is
/// compiled with -Ofast does.
class KeptArithmetic {
 public:
  KeptArithmetic() = default;
  ~KeptArithmetic() {
    if (const Modes now; now != before_) before_.set();
  }
  KeptArithmetic(const KeptArithmetic&) = delete;
  KeptArithmetic& operator=(const KeptArithmetic&) = delete;

 private:
#if defined(__SSE2__)
  /// Without the flags of what has happened.
  struct Modes {
    unsigned vectors = _mm_getcsr() & ~0x3FU;
    unsigned short extended = extended_now();
    static unsigned short extended_now() {
      unsigned short word = 0;
      __asm__ volatile("fnstcw %0" : "=m"(word));
      return word;
    }
    void set() const {
      _mm_setcsr(vectors);
      __asm__ volatile("fldcw %0" : : "m"(extended));
    }
    bool operator==(const Modes&) const = default;
  };
#elif defined(__aarch64__)
  struct Modes {
    unsigned long control = now();
    static unsigned long now() {
      unsigned long word = 0;
      __asm__ volatile("mrs %0, fpcr" : "=r"(word));
      return word;
    }
    void set() const { __asm__ volatile("msr fpcr, %0" : : "r"(control)); }
    bool operator==(const Modes&) const = default;
  };
#else
  struct Modes {
    int rounding = std::fegetround();
    void set() const { std::fesetround(rounding); }
    bool operator==(const Modes&) const = default;
  };
#endif
  const Modes before_;
};

}  // namespace odeum::isolated
