// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "odeum/brought/candidate.hpp"
#include "odeum/brought/trajectory.hpp"

namespace odeum::brought {

/// Compares rows of a file with what candidates make of them: the first ten, where methods start,
/// and thirty others. Case and run have to outlive it.
class Comparison {
 public:
  Comparison(const Case& c, const Trajectory& run);

  std::size_t rows() const { return firsts_.size(); }
  bool mechanical() const { return problem_.second_order(); }

  /// Whether all rows are the candidate's, with steps `factor` times those of the times, which is
  /// known to `unsure`: they are off by no more than half a unit in the last place of the numbers
  /// written, and some roundings, explain.
  bool fits(const Candidate& candidate, double factor = 1, double unsure = 0) const;
  /// What the candidate is off by in the first row after the start; empty: it can't step there.
  std::vector<double> defect(const Candidate& candidate) const;
  /// The factor of the steps with which the candidate fits in place of 1, if there is one.
  std::optional<double> other_step(const Candidate& candidate) const;

 private:
  std::size_t n() const { return problem_.size(); }
  bool is_finite_to(std::size_t row) const;
  Rows rows_at(const Candidate& candidate, std::size_t first, double factor) const;
  bool defect_at(const Candidate& candidate, const Rows& rows, std::vector<double>& defect) const;
  bool fits_at(const Candidate& candidate, std::size_t first, double factor, double unsure) const;
  double factor_at(const Candidate& candidate, std::size_t first) const;

  Problem problem_;
  const Trajectory& run_;
  std::vector<std::size_t> firsts_;
};

/// The component that differs most between two defects of one candidate: that of a secant.
std::size_t most_moved(const std::vector<double>& at, const std::vector<double>& next);

}  // namespace odeum::brought
