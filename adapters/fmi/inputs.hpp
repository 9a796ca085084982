// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fmi/description.hpp"
#include "fmi/setting.hpp"
#include "odeum/problem/piece.hpp"

namespace odeum::adapters::fmi {

/// Inputs over time from a file of `time,name,...`: continuous ones piecewise linear, discrete ones
/// held from row to row, all held before the first row and after the last. Two rows of one time are
/// a jump at it.
class Inputs {
 public:
  struct Column {
    Variable variable;
    bool linear = false;
    std::vector<double> values;      ///< of one that is linear
    std::vector<std::string> cells;  ///< of all, as written
  };

  /// Throws InputError, with line and column, for a file that is none, for a name that is not an
  /// input of the model, and for times and values that are not in order or not finite.
  Inputs(const std::string& file, const Description& description);

  const std::vector<Column>& columns() const { return columns_; }
  /// The value at t of a column that is linear; at a jump the one before it, unless t <= passed.
  double at(const Column& column, double t, double passed) const;
  /// The cell that holds from t on.
  const std::string& cell(const Column& column, double t) const;
  /// Its text at the start.
  std::string start(const Column& column, double t) const;
  /// The first time after t at which a column jumps; infinite: there is none.
  double next_jump(double t) const;
  const std::vector<Switch>& kinks() const { return kinks_; }
  /// The rows' times just before t and after it, infinite where there is none.
  std::pair<double, double> around(double t) const;
  std::string words() const;  ///< for people

 private:
  void read_header(std::string_view line, std::size_t number, const Description& description);
  void read_row(std::string_view line, std::size_t number);
  void find_changes();

  std::string file_;
  std::vector<double> times_, jumps_;
  char separator_ = ',';
  std::vector<Column> columns_;
  std::vector<Switch> kinks_;
};

}  // namespace odeum::adapters::fmi
