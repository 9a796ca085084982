// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/tableau/tableau.hpp"

namespace odeum {

/// A Runge-Kutta tableau whose number of stages is known at run time only, over any number type.
/// Unlike Tableau it stores the nodes: a user may state nodes that contradict the row sums.
template <class Number>
struct DynamicTableau {
  std::size_t stages = 0;
  std::vector<Number> a;      ///< row-major, stages x stages
  std::vector<Number> b, c;   ///< `stages` each
  std::vector<Number> b_hat;  ///< empty where there is no embedded row
  int order = 0;              ///< claimed; 0: no claim
  int order_hat = 0;          ///< claimed for b_hat; 0: no claim

  const Number& at(std::size_t i, std::size_t j) const { return a[i * stages + j]; }
  Number& at(std::size_t i, std::size_t j) { return a[i * stages + j]; }
  bool embedded() const { return !b_hat.empty(); }
  Number row_sum(std::size_t i) const {
    Number sum = at(i, 0);
    for (std::size_t j = 1; j < stages; ++j) sum += at(i, j);
    return sum;
  }
  void set_nodes_to_row_sums() {
    c.clear();
    for (std::size_t i = 0; i < stages; ++i) c.push_back(row_sum(i));
  }
  bool is_explicit() const { return zero_from(0); }
  /// No stage depends on a later one: they are solved one after the other.
  bool is_diagonally_implicit() const { return zero_from(1); }

 private:
  bool zero_from(std::size_t beyond) const {
    for (std::size_t i = 0; i < stages; ++i)
      for (std::size_t j = i + beyond; j < stages; ++j)
        if (at(i, j) != 0) return false;
    return true;
  }
};

template <std::size_t S>
DynamicTableau<double> dynamic_tableau(const Tableau<S>& tableau) {
  DynamicTableau<double> t;
  t.stages = S;
  for (const auto& row : tableau.a) t.a.insert(t.a.end(), row.begin(), row.end());
  t.b.assign(tableau.b.begin(), tableau.b.end());
  if (tableau.embedded()) t.b_hat.assign(tableau.b_hat.begin(), tableau.b_hat.end());
  for (std::size_t i = 0; i < S; ++i) t.c.push_back(tableau.c(i));
  t.order = tableau.order;
  t.order_hat = tableau.order_hat;
  return t;
}

}  // namespace odeum
