// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>
#include <vector>

#include "odeum/judge/order_fit.hpp"

namespace odeum::study {

/// Why a pair has no order, in words, and what would give it one.
struct OrderClass {
  judge::NoOrder why;
  std::string_view name, settles;
};

/// Of a verdict `failed` or `undetermined`; null for other verdicts.
const OrderClass* class_of(const judge::OrderFit& fit);

/// Every class, in the order in which pages list them.
const std::vector<OrderClass>& order_classes();

}  // namespace odeum::study
