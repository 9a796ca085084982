// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {

/// All that came out of one pair. Who its rows are of does not stand in the record.
struct PairResult {
  std::vector<ConvergenceRow> rows;
  std::vector<TimeRow> times;
  OrderRow order;
};

/// The journal's form of a result.
std::string write_record(const PairResult& result);
/// Throws std::runtime_error for a text that is no such record.
PairResult read_record(const std::string& text);

}  // namespace odeum::study
