// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "odeum/brought/table_file.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::brought {

/// A component of a case, or `t`, and the column of a file that has it.
struct ColumnOf {
  std::string component, column;  ///< a name of the header, or a number from 1
  double factor = 1;              ///< by which the column is multiplied
};

/// `x=col2` or `x=col2*0.001`. Throws InputError.
ColumnOf column_of(const std::string& text);

/// What a user says of files, in place of a guess.
struct Reading {
  std::vector<ColumnOf> columns = {};
  std::vector<double> steps = {};  ///< one a file; empty: from names, columns or times
};

/// A run of another program, in the components of a case.
struct Trajectory {
  std::string file;
  std::string series;  ///< its name without the step: the runs of one program
  std::vector<double> times;
  /// Row after row as many numbers as the case's y0, and half a unit of their last written place;
  /// NaN for a component that the file has not.
  std::vector<double> states, half_places;
  std::vector<std::size_t> components;  ///< that it has, ascending
  double apart = 0;                     ///< the time between rows; 0: it is not always the same
  double step = 0;                      ///< 0: its steps are not equal, and not known
  std::size_t steps_a_row = 1;          ///< between two rows, where they are known to be equal
  std::vector<std::string> remarks;     ///< sentences on how it was read

  std::size_t rows() const { return times.size(); }
  const double* state(std::size_t row) const {
    return states.data() + row * (states.size() / times.size());
  }
  const double* half_place(std::size_t row) const {
    return half_places.data() + row * (states.size() / times.size());
  }
  bool is_whole(const Case& c) const { return components.size() == c.y0.size(); }
};

/// Reads a file as a run of the case. Columns go by their names (t, time; those of the components,
/// whatever their case, with a unit or an argument behind them), where none fits by their order;
/// the step is `step`, or where that is 0 the one that the file's name says (h0.1, dt=0.1, n100),
/// or the time between rows. Throws InputError for numbers that are not a run (with line, column
/// and what was expected) and for columns that are not there.
Trajectory read_trajectory(const Case& c, const std::string& path, const Reading& reading,
                           double step);

}  // namespace odeum::brought
