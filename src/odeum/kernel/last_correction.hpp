// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include "odeum/kernel/components.hpp"

namespace odeum {

/// The last correction of a Newton iteration, of which less may be taken afterwards. State and
/// increment are kept apart, not y = base + increment: at a stiff step base is far larger than y,
/// whose digits would be lost.
template <class S>
class LastCorrection {
 public:
  explicit LastCorrection(const S& like) : by_(like), from_(like), increment_from_(like) {}

  /// Takes the whole of a correction, whose contents become undefined.
  void take(S& correction, S& y, S& increment) {
    std::swap(by_, correction);
    from_ = y;
    increment_from_ = increment;
    take_share(1, y, increment);
  }
  /// Takes a share of it instead.
  void take_share(double share, S& y, S& increment) {
    share_ = share;
    each_component(y, [&](std::size_t i) {
      y[i] = from_[i] + share * by_[i];
      increment[i] = increment_from_[i] + share * by_[i];
    });
  }
  void forget_share() { share_ = 1; }
  double share() const { return share_; }

 private:
  S by_, from_, increment_from_;
  double share_ = 1;
};

}  // namespace odeum
