// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// The table of speed goals: each row one comparison, measured on this machine.
namespace odeum::bench {

/// A goal for vectors of eight numbers, and one for narrower ones.
constexpr double by_vectors([[maybe_unused]] double wide, [[maybe_unused]] double narrow) {
#ifdef __AVX512F__
  return wide;
#else
  return narrow;
#endif
}

struct Row {
  std::string what;          ///< what is compared
  double goal = 0;           ///< NaN: shown for information
  double measured = 0;       ///< NaN where it could not be measured; `note` then says why
  double low = 0, high = 0;  ///< interval: the least time of one against the median of the other
  bool at_most = false;      ///< the goal is an upper bound
  std::string unit = "x";
  std::string note{};
  /// Other programs ran during it, and it is longer than they leave a processor alone.
  bool disturbed = false;

  bool met() const { return at_most ? measured <= goal : measured >= goal; }
  /// met, or by how much it is missed; empty without a goal.
  std::string verdict() const;
};

/// Times in seconds of one of several candidates measured in turn.
struct Timing {
  double min = 0, median = 0;
};
/// Runs all in turn, each at least three times and for `seconds` in all: on one pinned processor by
/// the time of the thread, which other programs do not lengthen, or, where they use threads of
/// their own, by wall time.
std::vector<Timing> interleave(const std::vector<std::function<void()>>& rivals, double seconds,
                               bool pinned = true);
/// How many times as long as `ours` the other takes.
Row compare(std::string what, double goal, const Timing& ours, const Timing& theirs,
            std::string note = {});

/// Prints tables row by row, as they are measured, for a terminal; or all at the end, as rows of
/// reports/measured/speed.csv, where ODEUM_BENCH_ROWS is set, as scripts/bench does.
class Printed {
 public:
  /// Processor, instruction set, compiler, load, date.
  void machine();
  void title(const std::string& text);
  void row(const Row& row);
  /// The change of the machine's own speed since machine(), as a fraction; NaN: not measured.
  void end(double drift = std::numeric_limits<double>::quiet_NaN());

 private:
  bool as_rows_ = std::getenv("ODEUM_BENCH_ROWS") != nullptr;
  std::string title_{}, date_{};
  double load_ = 0;  ///< of the machine when it began
  std::vector<std::pair<std::string, Row>> rows_{};
};

std::vector<Row> cloth_kernel_rows();
std::vector<Row> cloth_step_rows();
std::vector<Row> cloth_error_rows();
std::vector<Row> contact_rows();
std::vector<Row> fixed_step_rows();
std::vector<Row> evaluation_rows();
std::vector<Row> growth_rows();
std::vector<Row> precision_rows();
std::vector<Row> advise_rows();
std::vector<Row> sparse_rows();
std::vector<Row> fem_rows();
std::vector<Row> cloth_multigrid_rows();

/// The vectors that the program is compiled for, as AVX-512.
std::string compiled_for();
/// A number of a table with three digits; - where there is none.
std::string three_digits(double number, const std::string& unit = "");

/// The row of scripts/bench ensemble; a tolerance of 0: a fixed step.
Row text_row(const char* solver, double tolerance, double goal);

}  // namespace odeum::bench
