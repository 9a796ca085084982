// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/proof/pair_quality.hpp"
#include "odeum/tableau/character.hpp"
#include "odeum/tableau/tableau_file.hpp"

namespace odeum::proof {

/// The order conditions of one row, in numbers that a reader can check.
struct RowProof {
  std::string row;             ///< b or b_hat
  int claimed = 0, order = 0;  ///< claimed 0: no claim
  bool at_limit = false;       ///< no condition fails up to the highest order that is checked
  std::string tree, residual;  ///< the first condition that fails; residual exact where it can be
  int failing = 0, of = 0;     ///< conditions of the next order
  bool reached() const { return claimed == 0 || order >= claimed; }
};

/// A node that is not the sum of its row.
struct NodeFault {
  std::size_t stage = 0;  ///< from 1
  std::string stated, row_sum;
};

/// An order measured by running the tableau, and whether it is the one of the conditions.
struct MeasuredRow {
  std::string row, test_problem;
  judge::OrderFit fit;
  bool agrees = false;
  std::string note;  ///< why a higher order agrees; may be empty
};

struct Verification {
  RowProof main, embedded;  ///< embedded.row is empty where there is none
  std::vector<NodeFault> nodes;
  Structure structure;
  StabilityClass stability;
  double real_limit = 0, imaginary_limit = 0;
  std::vector<MeasuredRow> measured;
  PairQuality quality;

  /// Claims are met, nodes are the row sums, and measured orders agree with the conditions.
  bool passed() const;
  std::string text(const TableauFile& file) const;
};

Verification verify(const TableauFile& file);

}  // namespace odeum::proof
