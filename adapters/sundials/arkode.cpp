// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/arkode.hpp"

#include <arkode/arkode_arkstep.h>

#include <cctype>
#include <string_view>
#include <utility>

namespace odeum::adapters::sundials {
namespace {

template <class Id>
using Names = std::vector<std::pair<Id, const char*>>;

/// Reads the orders from the tables.
template <class Id>
std::vector<BuiltInTable<Id>> load(const Names<Id>& names, ARKodeButcherTable (*load_table)(Id)) {
  std::vector<BuiltInTable<Id>> tables;
  for (const auto& [id, name] : names) {
    const ButcherTable table(load_table(id));
    if (!table) continue;
    std::string method = name;
    for (char& c : method) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    tables.push_back({id, name, method, table->q, table->d ? table->p : 0});
  }
  return tables;
}

#define ODEUM_TABLE(name) \
  { ARKODE_##name, #name }

}  // namespace

// The library has no function from an id to its name, so the names are listed; a test compares the
// lists with the ranges of the enumerations.
const std::vector<ExplicitTable>& explicit_tables() {
  static const std::vector<ExplicitTable> tables = load(
      Names<ARKODE_ERKTableID>{ODEUM_TABLE(HEUN_EULER_2_1_2), ODEUM_TABLE(BOGACKI_SHAMPINE_4_2_3),
                               ODEUM_TABLE(ARK324L2SA_ERK_4_2_3), ODEUM_TABLE(ZONNEVELD_5_3_4),
                               ODEUM_TABLE(ARK436L2SA_ERK_6_3_4), ODEUM_TABLE(SAYFY_ABURUB_6_3_4),
                               ODEUM_TABLE(CASH_KARP_6_4_5), ODEUM_TABLE(FEHLBERG_6_4_5),
                               ODEUM_TABLE(DORMAND_PRINCE_7_4_5), ODEUM_TABLE(ARK548L2SA_ERK_8_4_5),
                               ODEUM_TABLE(VERNER_8_5_6), ODEUM_TABLE(FEHLBERG_13_7_8),
                               ODEUM_TABLE(KNOTH_WOLKE_3_3), ODEUM_TABLE(ARK437L2SA_ERK_7_3_4),
                               ODEUM_TABLE(ARK548L2SAb_ERK_8_4_5)},
      ARKodeButcherTable_LoadERK);
  return tables;
}

const std::vector<ImplicitTable>& implicit_tables() {
  static const std::vector<ImplicitTable> tables =
      load(Names<ARKODE_DIRKTableID>{ODEUM_TABLE(SDIRK_2_1_2),
                                     ODEUM_TABLE(BILLINGTON_3_3_2),
                                     ODEUM_TABLE(TRBDF2_3_3_2),
                                     ODEUM_TABLE(KVAERNO_4_2_3),
                                     ODEUM_TABLE(ARK324L2SA_DIRK_4_2_3),
                                     ODEUM_TABLE(CASH_5_2_4),
                                     ODEUM_TABLE(CASH_5_3_4),
                                     ODEUM_TABLE(SDIRK_5_3_4),
                                     ODEUM_TABLE(KVAERNO_5_3_4),
                                     ODEUM_TABLE(ARK436L2SA_DIRK_6_3_4),
                                     ODEUM_TABLE(KVAERNO_7_4_5),
                                     ODEUM_TABLE(ARK548L2SA_DIRK_8_4_5),
                                     ODEUM_TABLE(ARK437L2SA_DIRK_7_3_4),
                                     ODEUM_TABLE(ARK548L2SAb_DIRK_8_4_5),
                                     ODEUM_TABLE(ESDIRK324L2SA_4_2_3),
                                     ODEUM_TABLE(ESDIRK325L2SA_5_2_3),
                                     ODEUM_TABLE(ESDIRK32I5L2SA_5_2_3),
                                     ODEUM_TABLE(ESDIRK436L2SA_6_3_4),
                                     ODEUM_TABLE(ESDIRK43I6L2SA_6_3_4),
                                     ODEUM_TABLE(QESDIRK436L2SA_6_3_4),
                                     ODEUM_TABLE(ESDIRK437L2SA_7_3_4),
                                     ODEUM_TABLE(ESDIRK547L2SA_7_4_5),
                                     ODEUM_TABLE(ESDIRK547L2SA2_7_4_5)},
           ARKodeButcherTable_LoadDIRK);
  return tables;
}

std::string default_of(const std::string& name) {
  // The change log of SUNDIALS 7.3.0: the default of an order before, and since.
  struct Change {
    int order;
    std::string_view until, since;
  };
  static constexpr Change changes[] = {{2, "HEUN_EULER_2_1_2", "RALSTON_3_1_2"},
                                       {4, "ZONNEVELD_5_3_4", "SOFRONIOU_SPALETTA_5_3_4"},
                                       {5, "CASH_KARP_6_4_5", "TSITOURAS_7_4_5"},
                                       {6, "VERNER_8_5_6", "VERNER_9_5_6"},
                                       {8, "FEHLBERG_13_7_8", "VERNER_13_7_8"},
                                       {2, "SDIRK_2_1_2", "ARK2_DIRK_3_1_2"},
                                       {3, "ARK324L2SA_DIRK_4_2_3", "ESDIRK325L2SA_5_2_3"},
                                       {4, "SDIRK_5_3_4", "ESDIRK436L2SA_6_3_4"},
                                       {5, "ARK548L2SA_DIRK_8_4_5", "ESDIRK547L2SA2_7_4_5"},
                                       {4, "ARK436L2SA_6_3_4", "ARK437L2SA_7_3_4"},
                                       {5, "ARK548L2SA_8_4_5", "ARK548L2SAb_8_4_5"}};
  for (const Change& change : changes) {
    const std::string order = ", default of order " + std::to_string(change.order);
    if (change.until == name) return order + " until SUNDIALS 7.2.1";
    if (change.since == name) return order + " since SUNDIALS 7.3.0";
  }
  return {};
}

void create_arkstep(Session& session, ARKRhsFn explicit_part, ARKRhsFn implicit_part) {
  session.adopt(
      ARKStepCreate(explicit_part, implicit_part, session.t0(), session.y(), session.context()));
  // The default interpolant is Hermite's, of degree 5 at most. It predicts implicit stages, so that
  // another one would change the run: their steps end on their outputs.
  if (!implicit_part && session.interpolate_outputs()) return;
  // Every stop is the end of a step, so nothing is interpolated: an interpolant of the lowest
  // degree saves the default's extra evaluation per step.
  void* const arkstep = session.integrator();
  check(ARKStepSetInterpolantType(arkstep, ARK_INTERP_LAGRANGE), "setting the interpolant");
  check(ARKStepSetInterpolantDegree(arkstep, 1), "setting the interpolant's degree");
}

SolverInfo describe_table(std::string method, const char* family, int order, int order_embedded,
                          std::string source) {
  SolverInfo info;
  info.library = "arkode";
  info.method = std::move(method);
  info.family = family;
  info.order = order;
  info.adaptive = order_embedded != 0;
  if (info.adaptive) info.controller = "embedded pair, the library's default (PID) controller";
  info.source = std::move(source);
  return info;
}

}  // namespace odeum::adapters::sundials
