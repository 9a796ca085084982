// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include "odeum_methods.hpp"
#include "support/order.hpp"

/// The methods of q'' = a(t, q) that are made of coefficients: symplectic splittings, and
/// Runge-Kutta-Nystroem methods.
namespace odeum::tests {

template <class M>
concept IsSplitting = requires {
  M::splitting.symmetric();
};
template <class M>
concept IsNystroem = requires {
  M::nystroem.reuses_last_stage();
};

template <class Visit>
void for_each_splitting(Visit&& visit) {
  methods::All::for_each([&]<class M>() {
    if constexpr (IsSplitting<M>) visit.template operator()<M>();
  });
}
template <class Visit>
void for_each_nystroem(Visit&& visit) {
  methods::All::for_each([&]<class M>() {
    if constexpr (IsNystroem<M>) visit.template operator()<M>();
  });
}

template <class M>
void expect_claimed_order() {
  const int p = M::info.order;
  // At steps that are not tiny the next power of h contributes to the slope of a halving.
  EXPECT_NEAR(measured_order<M::template Stepper>(Kepler{}, 0.2, 2.3, p), p, 0.3) << M::info.id;
  EXPECT_NEAR(measured_order<M::template Stepper>(Driven{}, 0.2, 1.7, p), p, 0.3) << M::info.id;
}

}  // namespace odeum::tests
