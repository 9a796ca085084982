// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// Trajectories that other programs wrote: their files, and what they are against the truth.
namespace odeum::brought {

/// A column of numbers of a file.
struct Column {
  std::string name;            ///< in the header; empty: there is none
  std::vector<double> values;  ///< infinite or NaN where the file says so
  int digits = 17;             ///< significant digits that are written, at most
  int decimals = -1;           ///< places after the point, where all numbers have as many; else -1
  bool single = false;         ///< every value is a number of single precision

  /// Half a unit of the last place that is written of a value, in the column's unit: what the
  /// number may be off for being written.
  double half_place(double value) const;
};

/// A file of numbers, a row a time.
struct TableFile {
  std::string path;
  std::vector<Column> columns;     ///< of the same length, at least two rows
  std::vector<std::size_t> lines;  ///< of each row in the file, from 1; of an array its number
};

/// Reads a text of columns (separated by commas, semicolons, tabs or spaces; decimal commas beside
/// the latter three; lines that begin with # or % are comments, the last of which may be the
/// header; names in quotes), or an array of NumPy (.npy, one or two dimensions, real). An array
/// with few rows of which the first ascends is taken as its transpose. Throws InputError with line
/// and column for what is none of these.
TableFile read_table(const std::string& path);

/// The rows of an array that NumPy's save() wrote. Throws InputError for another text.
std::vector<std::vector<double>> read_npy(const std::string& path, const std::string& bytes,
                                          bool& single);

}  // namespace odeum::brought
