// SPDX-License-Identifier: BSD-3-Clause
// Malformed requests are exceptions, numerical failures are statuses.
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince54.hpp>
#include <odeum/methods/rk4.hpp>
#include <odeum/methods/rodas4.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

struct Growth {
  static constexpr std::size_t dimension = odeum::dynamic;
  std::size_t size() const { return 1; }
  void rhs(double, const double* y, double* dydt) const { dydt[0] = y[0] * y[0]; }
};

template <class Steps>
bool refused(std::vector<double> y, double t0, double t1, Steps steps) {
  try {
    odeum::integrate(Growth{}, odeum::methods::dormand_prince54{}, y, t0, t1, steps);
  } catch (const std::invalid_argument&) {
    return true;
  }
  std::printf("accepted: from %g to %g\n", t0, t1);
  return false;
}

/// y' = y^2, y(0) = 1 ends at t = 1.
template <class Method, class Steps>
bool fails(Steps steps, odeum::Status status) {
  std::vector<double> y{1};
  const odeum::RunEnd run = odeum::integrate(Growth{}, Method{}, y, 0, 3, steps);
  if (run.status == status && run.t < 3) return true;
  std::printf("%s at t = %g\n", odeum::to_string(run.status), run.t);
  return false;
}

int main() {
  using namespace odeum::methods;
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  bool right = true;
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    right = refused({1}, 0, 1, odeum::Step{bad}) && right;
    right = refused({1}, 0, 1, odeum::Tolerance{bad}) && right;
    right = refused({1}, 0, 1, odeum::Tolerance{1e-3, bad}) && right;
  }
  right = refused({1}, 0, 1, odeum::Step{1e-300}) && right;
  for (const double end : {0.0, -1.0, nan, infinity})
    right = refused({1}, 0, end, odeum::Step{0.1}) && right;
  right = refused({1, 2}, 0, 1, odeum::Step{0.1}) && right;
  right = refused({}, 0, 1, odeum::Tolerance{0.1}) && right;
  right = refused({1}, 0, 1, odeum::Tolerance{0.1, {0.1, 0.1}}) && right;
  right = fails<rk4>(odeum::Step{0.01}, odeum::Status::non_finite) && right;
  right = fails<dormand_prince54>(odeum::Tolerance{1e-6}, odeum::Status::step_too_small) && right;
  return right ? 0 : 1;
}
