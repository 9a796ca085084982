// SPDX-License-Identifier: BSD-3-Clause
// C++17, see tests/CMakeLists.txt.
#include "adapters/odeint_alone.hpp"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <utility>

namespace odeum::test {
namespace {
struct TooManySteps {};
}  // namespace

bool rosenbrock4_alone(const OdeView& ode, double t0, const std::vector<double>& stops,
                       double tolerance, std::vector<double>& y) {
  namespace odeint = boost::numeric::odeint;
  using Vector = boost::numeric::ublas::vector<double>;
  using Matrix = boost::numeric::ublas::matrix<double>;
  const auto rhs = [&](const Vector& x, Vector& f, double t) {
    ode.rhs(ode.problem, t, x.data().begin(), f.data().begin());
  };
  const auto jacobian = [&](const Vector& x, Matrix& j, double t, Vector& dfdt) {
    ode.jacobian(ode.problem, t, x.data().begin(), &j(0, 0));
    std::fill(dfdt.begin(), dfdt.end(), 0.0);  // the hard cases are autonomous
  };
  Vector x(y.size());
  std::copy(y.begin(), y.end(), x.begin());
  int steps = 0;
  const auto count = [&](const Vector&, double) {
    if (++steps > 10'000) throw TooManySteps();
  };
  constexpr double h = 1e-6;
  try {
    for (const double stop : stops) {
      odeint::integrate_adaptive(
          odeint::make_controlled<odeint::rosenbrock4<double>>(tolerance, tolerance),
          std::make_pair(rhs, jacobian), x, t0, stop, h, count);
      t0 = stop;
    }
  } catch (const TooManySteps&) {
    return false;
  } catch (const odeint::odeint_error&) {
    return false;
  }
  std::copy(x.begin(), x.end(), y.begin());
  return true;
}

}  // namespace odeum::test
