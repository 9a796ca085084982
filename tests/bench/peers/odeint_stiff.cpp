// SPDX-License-Identifier: BSD-3-Clause
// C++17, see CMakeLists.txt.
#include "bench/peers/odeint_stiff.hpp"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <exception>
#include <utility>

namespace odeum::peers {
namespace {
struct TooMany {};
}  // namespace

long run_rosenbrock4(const OdeView& ode, double t0, const std::vector<double>& stops,
                     const RosenbrockSettings& settings, const std::function<bool()>& admit,
                     std::vector<double>& y) {
  namespace odeint = boost::numeric::odeint;
  using Vector = boost::numeric::ublas::vector<double>;
  using Matrix = boost::numeric::ublas::matrix<double>;
  const auto rhs = [&](const Vector& x, Vector& f, double t) {
    if (!admit()) throw TooMany();
    ode.rhs(ode.problem, t, x.data().begin(), f.data().begin());
  };
  const auto jacobian = [&](const Vector& x, Matrix& j, double t, Vector& dfdt) {
    ode.jacobian(ode.problem, t, x.data().begin(), &j(0, 0));
    std::fill(dfdt.begin(), dfdt.end(), 0.0);  // the cases are autonomous
  };
  const auto system = std::make_pair(rhs, jacobian);
  Vector x(y.size());
  std::copy(y.begin(), y.end(), x.begin());
  std::vector<double> times{t0};
  times.insert(times.end(), stops.begin(), stops.end());
  const auto controller =
      odeint::make_controlled<odeint::rosenbrock4<double>>(settings.absolute, settings.relative);
  std::size_t steps = 0;
  const auto ignore = [](const Vector&, double) {};
  try {
    if (settings.dense)
      steps = odeint::integrate_times(
          odeint::rosenbrock4_dense_output<std::decay_t<decltype(controller)>>(controller), system,
          x, times.begin(), times.end(), settings.first_step, ignore);
    else
      steps = odeint::integrate_times(controller, system, x, times.begin(), times.end(),
                                      settings.first_step, ignore);
  } catch (const TooMany&) {
    return -1;
  } catch (const std::exception&) {
    return -1;
  }
  std::copy(x.begin(), x.end(), y.begin());
  return static_cast<long>(steps);
}

}  // namespace odeum::peers
