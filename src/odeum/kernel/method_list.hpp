// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace odeum::methods {

/// A list of method types; `for_each` calls visit.template operator()<M>() for each.
template <class... M>
struct MethodList {
  static constexpr std::size_t size = sizeof...(M);
  template <class Visit>
  static void for_each(Visit&& visit) {
    (visit.template operator()<M>(), ...);
  }
};

}  // namespace odeum::methods
