// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "goals.hpp"
#include "odeum/core/numbers.hpp"

namespace odeum::bench {

/// The regret of the advice for one question, a case and an error.
struct Regret {
  std::string case_id{};
  double error = 0;           ///< asked
  double advised = infinity;  ///< over the best; infinite without an answer
  double kept = nan;          ///< error over that asked
  double seconds = 0;         ///< that the advice took
  double best_ns = nan;       ///< time of the best run
  bool stiff = false, scene = false;
  std::size_t states = 0;
  std::map<std::string, double> others{};  ///< of each solver that has the error
  std::string advised_id{}, best_id{};
  std::string failure{};  ///< why there is no answer

  std::string question() const;
  /// The solver advised, the best one and its time; or why there is no answer.
  std::string text() const;
};

/// Writes the questions as rows of reports/measured/regret.csv.
void write_regret(const std::vector<Regret>& all, const std::string& file);

/// Rows of the advice over all questions, and beside it of what is done without a measurement.
/// `unanswered`: questions that no solver has the error of.
std::vector<Row> regret_rows(const std::vector<Regret>& all, std::size_t unanswered);

}  // namespace odeum::bench
