// SPDX-License-Identifier: BSD-3-Clause
// Three of ARKODE 6.4.1's implicit tables hold coefficients that violate their own order conditions
// by far more than rounding. The library alone; exits 0 while that stands, 1 when not.
//   g++ -std=c++20 sundials_table_digits.cpp -lsundials_arkode
#include <arkode/arkode.h>
#include <arkode/arkode_butcher_dirk.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

int main() {
  std::set<int> inexact;
  for (int id = ARKODE_MIN_DIRK_NUM; id <= ARKODE_MAX_DIRK_NUM; ++id) {
    ARKodeButcherTable table = ARKodeButcherTable_LoadDIRK(static_cast<ARKODE_DIRKTableID>(id));
    double consistency = -1, second = -0.5, rows = 0;  // sum b = 1, b.c = 1/2, c = A 1
    for (int i = 0; i < table->stages; ++i) {
      consistency += table->b[i];
      second += table->b[i] * table->c[i];
      double sum = -table->c[i];
      for (int j = 0; j < table->stages; ++j) sum += table->A[i][j];
      rows = std::max(rows, std::abs(sum));
    }
    const double worst = std::max({std::abs(consistency), std::abs(second), rows});
    if (worst > 1e-14)
      std::printf("table %d: sum b - 1 = %.1e, b.c - 1/2 = %.1e, rows %.1e\n", id, consistency,
                  second, rows);
    if (worst > 1e-13) inexact.insert(id);
    ARKodeButcherTable_Free(table);
  }
  return inexact == std::set<int>{ARKODE_BILLINGTON_3_3_2, ARKODE_CASH_5_2_4, ARKODE_CASH_5_3_4}
             ? 0
             : 1;
}
