// SPDX-License-Identifier: BSD-3-Clause
// Ensembles in vector lanes against the same method one member after the other, on one core: see
// scripts/bench ensemble. Compiled for one instruction set; times are those of the thread, since
// other processes may share the core.
#include <fmt/format.h>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <random>

#include "ensemble_problems.hpp"
#include "goals.hpp"
#include "odeum/api/ensemble.hpp"
#include "odeum/core/clocks.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/rodas4.hpp"

namespace odeum::bench {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// With AVX-512, with AVX2, with the least of x86-64.
constexpr double goal_for(double avx512, double avx2, double sse2) {
  return vector_bytes == 64 ? avx512 : vector_bytes == 32 ? avx2 : sse2;
}

std::vector<Timing> in_turn(const std::vector<std::function<void()>>& rivals) {
  return interleave(rivals, 0.7);
}

template <template <class> class P>
struct Ensemble {
  std::vector<P<double>> members;
  std::vector<State<P<double>>> states;
};
/// Each number within a factor of 1 to 1.5 of the usual one.
template <template <class> class P>
Ensemble<P> around(const State<P<double>>& start, std::size_t count) {
  Ensemble<P> all{std::vector<P<double>>(count), std::vector<State<P<double>>>(count, start)};
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> factor(1, 1.5);
  for (std::size_t k = 0; k < count; ++k) {
    auto numbers =
        std::bit_cast<std::array<double, sizeof(P<double>) / sizeof(double)>>(all.members[k]);
    for (double& each : numbers) each *= factor(draw);
    all.members[k] = std::bit_cast<P<double>>(numbers);
    for (double& each : all.states[k]) each *= factor(draw);
  }
  return all;
}

template <template <class> class P, class M, class How>
Row row_of(const std::string& name, double goal, M method, const How& how, double end,
           const State<P<double>>& start, std::size_t count) {
  const Ensemble<P> all = around<P>(start, count);
  double steps = 0;
  const auto one_by_one = [&] {
    auto states = all.states;
    for (std::size_t k = 0; k < count; ++k)
      integrate(all.members[k], method, states[k], 0, end, how);
  };
  const auto in_lanes = [&] {
    auto states = all.states;
    steps = 0;
    for (const RunEnd& run : integrate_ensemble(all.members, method, states, 0, end, how))
      steps += static_cast<double>(run.steps + run.rejected_steps);
  };
  const std::vector<Timing> t = in_turn({in_lanes, one_by_one});
  return compare(fmt::format("{}, {}", name, M::info.id), goal, t[0], t[1],
                 fmt::format("{:.2f} ns a step and member, alone {:.1f}", 1e9 * t[0].min / steps,
                             1e9 * t[1].min / steps));
}

/// odeint's RK4 with Lanes as its number type, one register after the other, or four in turn as
/// here: the better.
template <template <class> class P>
Row against_odeint(const std::string& name, const State<P<double>>& start) {
  namespace odeint = boost::numeric::odeint;
  using S = State<P<Lanes>>;
  constexpr std::size_t registers = 64, steps = 1000, count = registers * Lanes::count;
  constexpr double h = 1e-3;
  const Ensemble<P> all = around<P>(start, count);
  const auto run_odeint = [&]<std::size_t together>() {
    detail::GivenMembers<P, methods::rk4> given(all.members, const_cast<Ensemble<P>&>(all).states);
    for (std::size_t first = 0; first < registers; first += together) {
      std::array<P<Lanes>, together> problems;
      std::array<S, together> states{};
      for (std::size_t k = 0; k < count / registers * together; ++k)
        given.seat(first * Lanes::count + k, k % Lanes::count, problems[k / Lanes::count],
                   states[k / Lanes::count]);
      std::array<odeint::runge_kutta4<S, double, S, double, odeint::array_algebra>, together>
          steppers;
      for (std::size_t i = 0; i < steps; ++i)
        for (std::size_t r = 0; r < together; ++r)
          steppers[r].do_step(
              [&](const S& y, S& f, double t) { problems[r].rhs(t, y.data(), f.data()); },
              states[r], static_cast<double>(i) * h, h);
      volatile double sink = states[0][0][0];
      (void)sink;
    }
  };
  const auto own = [&] {
    auto states = all.states;
    integrate_ensemble(all.members, methods::rk4{}, states, 0, h * steps, Step{h});
  };
  const std::vector<Timing> t = in_turn({own, [&] { run_odeint.template operator()<1>(); },
                                         [&] { run_odeint.template operator()<4>(); }});
  const std::size_t best = t[1].min < t[2].min ? 1 : 2;
  return compare(fmt::format("{}: odeint's runge_kutta4 over lanes / own rk4", name), 1.2, t[0],
                 t[best], best == 1 ? "one register at a time" : "four in turn");
}

template <template <class> class P>
Row two_threads(const std::string& name, const State<P<double>>& start) {
  const Ensemble<P> all = around<P>(start, 20'000);
  const auto run = [&](unsigned jobs) {
    auto states = all.states;
    integrate_ensemble(all.members, methods::dormand_prince54{}, states, 0, 5, Tolerance{1e-6},
                       jobs);
  };
  const std::vector<Timing> t = interleave({[&] { run(2); }, [&] { run(1); }}, 4, false);
  return compare(fmt::format("{}: two threads against one, wall time", name), 1.9, t[0], t[1]);
}

void print_rows(Printed& out) {
  const methods::rk4 rk4;
  const methods::dormand_prince54 pair;
  const methods::rodas4 rodas;
  const double fixed = goal_for(12, 9, 4), adaptive = goal_for(7, 5, none),
               stiff = goal_for(5, 3, none);
  const Step h{1e-3};
  const Tolerance r{1e-6};
  out.title("Fixed step, time of one by one / in lanes");
  out.row(row_of<Lorenz>("Lorenz", fixed, rk4, h, 1, {1, 2, 20}, 2000));
  out.row(row_of<Duffing>("Duffing", fixed, rk4, h, 1, {1, 0.2}, 2000));
  out.row(row_of<LotkaVolterra>("Lotka-Volterra", fixed, rk4, h, 1, {2, 1}, 2000));
  out.row(row_of<Kepler>("Kepler", fixed, rk4, h, 1, {1, 0, 0, 1}, 2000));
  out.row(row_of<Pendulum>("driven pendulum, sin", fixed * 2 / 3, rk4, h, 0.2, {1, 0}, 2000));
  out.title("To a tolerance of 1e-6");
  out.row(row_of<Lorenz>("Lorenz", adaptive, pair, r, 5, {1, 2, 20}, 2000));
  out.row(row_of<Duffing>("Duffing", adaptive, pair, r, 20, {1, 0.2}, 2000));
  out.row(row_of<LotkaVolterra>("Lotka-Volterra", adaptive, pair, r, 20, {2, 1}, 2000));
  out.row(row_of<Kepler>("Kepler", adaptive, pair, r, 20, {1, 0, 0, 0.8}, 2000));
  out.title("Stiff, to a tolerance of 1e-6");
  out.row(row_of<Robertson>("Robertson to 4e4", stiff, rodas, Tolerance(1e-6, 1e-10), 4e4,
                            {1, 0, 0}, 1000));
  out.row(
      row_of<Hires>("HIRES to 321.8", stiff, rodas, r, 321.8, {1, 0, 0, 0, 0, 0, 0, 0.0057}, 1000));
#ifdef ODEUM_TEXT_ROWS  // compiled for the processor at hand alone
  out.title("A problem as text");
  out.row(text_row("rk4", 0, fixed));
  out.row(text_row("dormand_prince54", 1e-6, adaptive));
  out.row(text_row("rodas4", 1e-6, stiff));
#endif
  out.title("Against others");
  out.row(against_odeint<Lorenz>("Lorenz", {1, 2, 20}));
  out.row(against_odeint<Kepler>("Kepler", {1, 0, 0, 1}));
  out.row(two_threads<Lorenz>("Lorenz, dormand_prince54", {1, 2, 20}));
}

}  // namespace
}  // namespace odeum::bench

int main() {
  using namespace odeum;
  bench::Printed out;
  out.machine();
  bench::print_rows(out);
  out.end();
}
