// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <limits>

#include "odeum/problem/ode_view.hpp"

/// Times at which a right-hand side changes its form, and the problem between two of them.
namespace odeum {

/// A time at which f may jump, or have a kink: one form holds up to `before` and another one from
/// `after` on, which are t or next to it.
struct Switch {
  double t, before, after;
};

/// A problem between two switches: its functions are those of the form that holds there at every
/// time, at the ends of the piece too, where the problem itself may have the other form.
class Piece {
  template <auto member, class R, class... More>
  static auto inside(R (*)(const void*, double, More...)) {
    return +[](const void* piece, double t, More... more) -> R {
      const Piece& self = *static_cast<const Piece*>(piece);
      return (self.whole_.*member)(self.whole_.problem, self.clamped(t), more...);
    };
  }
  /// For a function that takes no time.
  template <auto member, class R, class... All>
  static auto inside(R (*)(const void*, All...)) {
    return +[](const void* piece, All... all) -> R {
      const OdeView& whole = static_cast<const Piece*>(piece)->whole_;
      return (whole.*member)(whole.problem, all...);
    };
  }

 public:
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  /// The problem behind `whole` has to outlive this.
  Piece(const OdeView& whole, double first, double last)
      : whole_(whole), first_(first), last_(last) {}

  /// This must outlive the view.
  OdeView view() const {
    OdeView view = whole_;
    view.problem = this;
    view.rhs = inside<&OdeView::rhs>(whole_.rhs);
#define ODEUM_INSIDE(concept_name, function, charge, ...) \
  if (view.function) view.function = inside<&OdeView::function>(whole_.function);
    ODEUM_CAPABILITIES(ODEUM_INSIDE)
#undef ODEUM_INSIDE
    return view;
  }
  double clamped(double t) const { return std::clamp(t, first_, last_); }

 private:
  OdeView whole_;
  double first_, last_;
};

}  // namespace odeum
