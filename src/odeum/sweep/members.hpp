// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// Many runs of one problem with other values of its parameters:
///
///     const Members members({axis_of("k=1..2:11"), axis_of("m=1,2,5")}, 0, 1);
///     members.values(1);  // k = 1, m = 2: member 1 of 33
namespace odeum::sweep {

/// A parameter with its values: those of a grid, or a distribution from which they are drawn.
struct Axis {
  enum class Kind { grid, uniform, log_uniform, normal };
  std::string name;
  Kind kind = Kind::grid;
  std::vector<double> values = {};  ///< of a grid
  double first = 0, second = 0;     ///< the ends of a distribution, or mean and standard deviation
  double drawn(double u, double v) const;  ///< u and v: uniform in (0, 1)
};

/// `NAME=A..B:N` (N equal steps from A to B, both among them), `NAME=A..B:logN` (equal ratios),
/// `NAME=A,B,...`, `NAME~uniform(A,B)`, `NAME~loguniform(A,B)`, `NAME~normal(MEAN,DEVIATION)`.
/// Throws std::invalid_argument with what was expected.
Axis axis_of(const std::string& text);

inline constexpr std::uint64_t most_members = 10'000'000;

/// The values of the parameters of each member, which follow from its number alone, so that any
/// part of a sweep can be run anywhere.
class Members {
 public:
  /// Every combination of the grids, the last axis fastest; with distributions `sample` draws for
  /// each. Throws std::invalid_argument for a name that stands twice, for too many members, and
  /// where `sample` (0: not given) and the axes do not fit. The draws follow from `seed`.
  Members(std::vector<Axis> axes, std::uint64_t sample, std::uint64_t seed);
  /// From a CSV file: a header of names, then a line of numbers for each member. Throws
  /// std::invalid_argument with the line.
  static Members of_csv(const std::string& name, const std::string& text);

  std::uint64_t size() const { return size_; }
  const std::vector<std::string>& names() const { return names_; }
  /// The axes, in the order given; empty for a table.
  const std::vector<Axis>& axes() const { return axes_; }
  /// The parameter values of a member < size(), in the order of names(). Thread-safe.
  std::vector<double> values(std::uint64_t member) const;

 private:
  Members() = default;
  void require_names() const;

  std::vector<std::string> names_;
  std::vector<Axis> axes_;
  std::vector<double> table_;  ///< by member, one a name; empty: from the axes
  std::uint64_t size_ = 0, sample_ = 1, seed_ = 0;
};

}  // namespace odeum::sweep
