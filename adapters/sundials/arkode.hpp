// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdio>  // the library's header of tables uses FILE without it

#include <arkode/arkode.h>
#include <arkode/arkode_butcher.h>
#include <arkode/arkode_butcher_dirk.h>
#include <arkode/arkode_butcher_erk.h>

#include <memory>
#include <string>
#include <vector>

#include "odeum/tableau/tableau.hpp"
#include "sundials/handles.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {

using ButcherTable = std::unique_ptr<ARKodeButcherTableMem, Destroy<&ARKodeButcherTable_Free>>;

/// Properties of ARKODE's built-in tables, without the coefficients.
template <class Id>
struct BuiltInTable {
  Id id;
  std::string name;        ///< as in the enumeration, without ARKODE_
  std::string method;      ///< the same in lower case
  int order = 0;           ///< of the propagated solution
  int order_embedded = 0;  ///< 0: none
};
using ExplicitTable = BuiltInTable<ARKODE_ERKTableID>;
using ImplicitTable = BuiltInTable<ARKODE_DIRKTableID>;

/// Every built-in table, in the order of the library's enumerations.
const std::vector<ExplicitTable>& explicit_tables();
const std::vector<ImplicitTable>& implicit_tables();

/// Since when, and until when, a table was the default of its order: ", default of order 5 until
/// SUNDIALS 7.2.1"; empty where no release that is described here has it so. `name`: as in the
/// enumerations.
std::string default_of(const std::string& name);

/// Creates ARKStep in a session for y' = explicit_part + implicit_part, one of which is null.
void create_arkstep(Session& session, ARKRhsFn explicit_part, ARKRhsFn implicit_part);

/// Description of a solver with a given table; adaptive where the table has an embedded row.
SolverInfo describe_table(std::string method, const char* family, int order, int order_embedded,
                          std::string source);

/// An own tableau as a table of the library; null where memory ran out.
template <std::size_t S>
ButcherTable as_butcher_table(const Tableau<S>& tableau) {
  ButcherTable table(ARKodeButcherTable_Alloc(static_cast<int>(S), tableau.embedded()));
  if (!table) return table;
  table->q = tableau.order;
  table->p = tableau.order_hat;
  for (std::size_t i = 0; i < S; ++i) {
    table->c[i] = tableau.c(i);
    table->b[i] = tableau.b[i];
    if (tableau.embedded()) table->d[i] = tableau.b_hat[i];
    for (std::size_t j = 0; j < S; ++j) table->A[i][j] = tableau.a[i][j];
  }
  return table;
}

}  // namespace odeum::adapters::sundials
