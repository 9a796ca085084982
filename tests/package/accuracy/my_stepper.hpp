// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

/// The classical method of Runge and Kutta.
struct my_stepper {
  std::vector<double> k1, k2, k3, k4, u;

  template <class F>
  void step(F& f, double t, double h, std::vector<double>& y) {
    for (auto* k : {&k1, &k2, &k3, &k4, &u}) k->resize(y.size());
    const auto move = [&](double by, const std::vector<double>& k) {
      for (std::size_t i = 0; i < y.size(); ++i) u[i] = y[i] + by * k[i];
    };
    f(t, y.data(), k1.data());
    move(h / 2, k1);
    f(t + h / 2, u.data(), k2.data());
    move(h / 2, k2);
    f(t + h / 2, u.data(), k3.data());
    move(h, k3);
    f(t + h, u.data(), k4.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
};
