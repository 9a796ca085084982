// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/kernel/iteration.hpp"
#include "odeum/kernel/quick_power.hpp"

namespace odeum {

/// In what the Newton iterations of the kernels differ. The contraction is the size of a correction
/// over that of the one before it; the remainder is what later corrections add, over the last one.
struct NewtonSettings {
  static constexpr double never = std::numeric_limits<double>::infinity();
  double divergent = 1;  ///< the contraction from which the iteration fails
  /// The contraction above which a new Jacobian is formed within the iteration: sooner for one of
  /// an earlier solve, since the next steps profit too.
  double slow_kept = never, slow_fresh = never;
  bool foresees = false;  ///< fail once the iterations left cannot suffice at this contraction
  bool smooth = false;    ///< the contraction is the geometric mean of the last two
  bool small_suffices = false;  ///< a correction within the tolerance ends it at any contraction
  /// The remainder while no contraction is known. One that an earlier solve measured does not bound
  /// it: across a contact f is another function.
  double first_remainder = 1;
};

enum class NewtonVerdict { done, go_on, slow, diverges, unsolvable };

/// The convergence of Newton iterations, for all kernels: the Jacobian is kept while the iteration
/// converges fast (Hairer, Wanner, Solving ODEs II, IV.8). A kernel that takes each correction
/// whole has its loop here; another asks for the verdict on a correction before it takes it.
template <NewtonSettings s>
class SimplifiedNewton {
 public:
  using Verdict = NewtonVerdict;
  static constexpr double no_solution = -1;

  /// `most`: iterations; `tolerance`: bound on what later corrections would add, 0: to rounding.
  /// `weight` and the `unit` of sizes are for at_rounding.
  explicit SimplifiedNewton(int most, double tolerance = 0, double weight = 1)
      : most_(most), tolerance_(tolerance), weight_(weight) {}

  /// Returns done, diverges or unsolvable. `correct()` adds a correction and returns its size, or
  /// no_solution of its linear system. `renew()` forms a Jacobian at the present state; false:
  /// singular.
  template <class Correct, class Renew>
  Verdict operator()(Correct&& correct, Renew&& renew) {
    for (iterations_ = 1; iterations_ <= most_; ++iterations_) {
      const double size = correct();
      if (size < 0) return Verdict::unsolvable;
      const Verdict verdict = judge(size);
      if (verdict == Verdict::done || verdict == Verdict::diverges) return verdict;
      taken(size);
      if (verdict == Verdict::slow && !renew()) break;
    }
    return Verdict::diverges;
  }
  /// The same with one Jacobian.
  template <class Correct>
  Verdict operator()(Correct&& correct) {
    return (*this)(correct, [] { return true; });
  }

  /// To be called before a solve.
  void begin() {
    renewed();
    fresh_ = false;
  }
  /// To be called after each renewal of the Jacobian within a solve.
  void renewed() {
    fresh_ = true;
    corrections_ = 0;
    contraction_ = 0;
  }
  void measure_in(double unit) { unit_ = unit; }

  int iterations() const { return iterations_; }       ///< of the last solve
  double contraction() const { return contraction_; }  ///< 0: not known; never: not finite
  int corrections() const { return corrections_; }     ///< since the last renewal
  bool fresh() const { return fresh_; }                ///< the Jacobian is of this solve

  /// What a correction of this size means.
  Verdict judge(double size) {
    contraction_ = std::isfinite(size) ? 0 : NewtonSettings::never;
    if (contraction_ > 0) return Verdict::diverges;
    const bool known = corrections_ > 0;
    double remainder = s.first_remainder;
    if (known) {
      const double ratio = size / last_;
      contraction_ = s.smooth && corrections_ > 1 ? std::sqrt(ratio * last_ratio_) : ratio;
      last_ratio_ = ratio;
      remainder = contraction_ < 1 ? contraction_ / (1 - contraction_) : NewtonSettings::never;
    }
    if (tolerance_ == 0 ? at_rounding(size / unit_, contraction_, known, weight_)
                        : size == 0 || remainder * size <= tolerance_ ||
                              (s.small_suffices && size <= tolerance_))
      return Verdict::done;
    if (contraction_ >= s.divergent) return Verdict::diverges;
    const int left = most_ - 1 - iterations_;
    if (known && s.foresees && left >= 0 &&
        remainder * size * power(contraction_, left) > tolerance_)
      return Verdict::diverges;
    return contraction_ > (fresh_ ? s.slow_fresh : s.slow_kept) ? Verdict::slow : Verdict::go_on;
  }
  /// To be called when the correction of this size was taken.
  void taken(double size) {
    last_ = std::max(size, std::numeric_limits<double>::min());
    ++corrections_;
  }

 private:
  int most_;
  double tolerance_, weight_, unit_ = 1, last_ = 0, last_ratio_ = 0, contraction_ = 0;
  int iterations_ = 0, corrections_ = 0;
  bool fresh_ = false;
};

}  // namespace odeum
