// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/core/status.hpp"
#include "odeum/problem/concepts.hpp"

/// What multistep methods at a fixed step share.
namespace odeum {

/// The last `Depth` states or slopes of a run, newest first.
template <std::size_t Depth, class S>
class History {
 public:
  explicit History(const S& zero) { entries_.fill(zero); }
  /// Room for the next newest entry, which the caller fills.
  S& push() {
    newest_ = (newest_ + Depth - 1) % Depth;
    if (count_ < Depth) ++count_;
    return entries_[newest_];
  }
  const S& operator[](std::size_t age) const { return entries_[(newest_ + age) % Depth]; }
  /// Where the entries lie, by age: sums over them need no index arithmetic.
  auto places() const {
    std::array<decltype(entries_[0].data()), Depth> places{};
    for (std::size_t age = 0; age < Depth; ++age) places[age] = (*this)[age].data();
    return places;
  }
  bool full() const { return count_ == Depth; }
  void clear() { count_ = 0; }

 private:
  std::array<S, Depth> entries_;
  std::size_t newest_ = 0, count_ = 0;
};

/// Starting values of a multistep method, by substeps of a one-step method whose order is the
/// multistep method's or one less: its local error is then of the right order, and the substeps
/// keep it below the errors of the steps that follow.
template <class OneStep, Ode P>
class StartingProcedure {
 public:
  explicit StartingProcedure(const P& problem) : one_step_(problem) {}
  Status advance(double t, double h, State<P>& y) {
    constexpr int substeps = 4;
    for (int i = 0; i < substeps; ++i) {
      const Status status = one_step_.step(t + i * (h / substeps), h / substeps, y);
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }

 private:
  OneStep one_step_;
};

}  // namespace odeum
