// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/eigen_solvers.hpp"
#include "odeum/solvers/variants.hpp"
#include "odeum_adapters_linear.hpp"    // generated: linear.hpp of every library that is built in
#include "odeum_adapters_variants.hpp"  // generated: variants.hpp of these

// lists/*.inc are generated: the libraries that have these headers.
namespace odeum {

const std::vector<linear::LinearPeerInfo>& linear::linear_peers() {
  static const std::vector<LinearPeerInfo> all = [] {
    std::vector<LinearPeerInfo> list;
    add_eigen_peers(list);
#define ODEUM_ITEM(library) adapters::library::add_linear_peers(list);
#include "lists/adapters_linear.inc"
#undef ODEUM_ITEM
    return list;
  }();
  return all;
}

std::vector<Variant> variants_of(const std::string& solver) {
  static const std::map<std::string, std::vector<Variant>> all = [] {
    std::map<std::string, std::vector<Variant>> by_solver;
#define ODEUM_ITEM(library) adapters::library::add_variants(by_solver);
#include "lists/adapters_variants.inc"
#undef ODEUM_ITEM
    return by_solver;
  }();
  const auto tuned = all.find(solver);
  return tuned == all.end() ? std::vector<Variant>{} : tuned->second;
}

}  // namespace odeum
