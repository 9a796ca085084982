// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// What the components of a solution are from its start up to a time.
struct Along {
  std::vector<double> largest;  ///< magnitudes; 0: zero throughout, or a rounding of others
  std::vector<double> lowest;   ///< values, with their signs
  /// Positive where the component, which keeps its sign, has been below a thousandth of its largest
  /// and has risen tenfold from there, and is larger later where it was larger there: the least
  /// magnitude before the rise. An error that is small beside the largest may be as large as the
  /// component there, and rises with it. A component that a source lifts forgets its errors.
  std::vector<double> dips;
  /// From where on it stays where a condition changes, so that nothing is known beyond; infinite:
  /// it does not.
  double slides_from = std::numeric_limits<double>::infinity();
  bool whole = false;  ///< it was seen up to the last stop
};

/// Sees the states of a run at the ends of its steps.
class Watched {
 public:
  explicit Watched(std::size_t states) : all_(states) {}
  void take(const State& y);
  /// Marks a time that was asked for.
  void mark() { marks_.push_back(all_); }
  /// Takes the last mark back.
  void unmark() { marks_.pop_back(); }
  /// The sizes up to a mark.
  Along at(std::size_t mark) const;
  /// The first mark after a component with a dip has risen, as it was seen at a mark.
  std::size_t risen_before(std::size_t component, std::size_t mark) const {
    return (mark < marks_.size() ? marks_[mark] : all_)[component].risen_before;
  }

 private:
  struct Seen {
    Real first = 0, last = 0, largest = 0, lowest = 0;
    Real low = 0;         ///< least magnitude since it fell, or since a start that is not 0
    Real risen_from = 0;  ///< the least of these from which it has risen
    std::size_t risen_before = 0;
    bool begun = false, changed_sign = false;
  };
  std::vector<Seen> all_;
  std::vector<std::vector<Seen>> marks_;
};

/// Along the solution to the last stop that a run reaches, or as far as it comes where it reaches
/// none: to few digits of each component, and as many more as it takes for sizes that do not change
/// with them. Each run is bounded in operations. Nothing where it does not come far.
std::optional<Along> look_along(const System& system, const std::vector<double>& stops);

/// As text, to be kept in a file, and back; nothing for a text that is damaged or of other sizes.
std::string to_text(const Along& along);
std::optional<Along> along_from(const std::string& text, std::size_t states);

}  // namespace odeum::truth
