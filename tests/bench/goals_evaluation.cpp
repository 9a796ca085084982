// SPDX-License-Identifier: BSD-3-Clause
// What a step costs beyond its right-hand side, by number of unknowns: kernels of all families on a
// ring whose right-hand side is two operations an unknown.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "goals.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/methods/dormand_nystroem64.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/gragg_bulirsch_stoer.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/rodas4.hpp"
#include "odeum/methods/seulex.hpp"
#include "odeum/solvers/enroll_method.hpp"

namespace odeum::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t steps = 4000;

template <std::size_t N>
struct Ring {
  static constexpr std::size_t dimension = N;
  void rhs(double, const double* y, double* f) const {
    for (std::size_t i = 0; i < N; ++i) f[i] = 0.1 * y[(i + 1) % N] - 0.2 * y[i];
  }
  void jacobian(double, const double*, double* j) const {
    for (std::size_t i = 0; i < N * N; ++i) j[i] = 0;
    for (std::size_t i = 0; i < N; ++i) {
      j[i * N + (i + 1) % N] += 0.1;
      j[i * N + i] -= 0.2;
    }
  }
};
/// A problem of second order: N / 2 masses.
template <std::size_t N>
struct Masses {
  static constexpr std::size_t dimension = N;
  static constexpr bool velocity_dependent = false;
  void acceleration(double, const double* q, const double*, double* a) const {
    constexpr std::size_t n = N / 2;
    for (std::size_t i = 0; i < n; ++i) a[i] = q[(i + 1) % n] - 2 * q[i];
  }
  void rhs(double t, const double* y, double* f) const { second_order_rhs(*this, N / 2, t, y, f); }
};

template <std::size_t N>
std::vector<double> start() {
  std::vector<double> y(N, 0.0);
  y[0] = 1;
  return y;
}

/// Steps of Dormand and Prince's tableau with all values in one function: what the kernel is
/// compared with, the right-hand side inlined or behind a pointer.
template <std::size_t N, class Rhs>
double plain_steps(const Rhs& rhs, std::uint64_t count, double h) {
  constexpr const auto& T = methods::dormand_prince54::tableau;
  std::array<double, N> y{1}, argument{};
  std::array<std::array<double, N>, 6> k{};
  const auto stage = [&]<std::size_t I, std::size_t... J>(std::index_sequence<J...>) {
    for (std::size_t n = 0; n < N; ++n) {
      double sum = y[n];
      ((T.a[I][J] != 0 ? void(sum += h * T.a[I][J] * k[J][n]) : void()), ...);
      argument[n] = sum;
    }
    if constexpr (I == 6)
      y = argument;
    else
      rhs(argument.data(), k[I].data());
  };
  for (std::uint64_t i = 0; i < count; ++i) [&]<std::size_t... I>(std::index_sequence<I...>) {
      (stage.template operator()<I>(std::make_index_sequence<I>()), ...);
    }
  (std::make_index_sequence<7>());
  return y[0];
}

void keep(double value) { asm volatile("" : : "m"(value)); }

/// A run with the right-hand side inlined and one behind a pointer, and what each counts.
struct Prepared {
  std::function<void()> inlined, by_pointer;
  Counters counters;
};
template <class M, class P>
Prepared prepare(Request request) {
  const auto problem = std::make_shared<const P>();
  const auto y0 = std::make_shared<const std::vector<double>>(start<P::dimension>());
  const Contest<P> guarded{problem, 0, y0, nullptr};
  const Contest<Bare<P>> bare{std::make_shared<const Bare<P>>(), 0, y0, nullptr};
  Entrant entrant;
  enroll_method<M>(erase(guarded), entrant);
  Prepared made;
  made.counters = solve_own<M>(guarded, request).counters;
  request.budget.watched = false;
  made.inlined = [bare, request] { keep(solve_own<M>(bare, request).states[0]); };
  made.by_pointer = [solve = entrant.solve, request] { keep(solve(request).states[0]); };
  return made;
}

Request fixed_request() {
  Request request;
  request.steps = steps;
  request.stops = {0.01 * static_cast<double>(steps)};
  return request;
}
Request adaptive_request() {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = 1e-6;
  request.stops = {400};
  return request;
}

/// The explicit kernel against the plain program, the pointer, and the adaptive part.
template <std::size_t N>
void explicit_rows(std::vector<Row>& rows) {
  using M = methods::dormand_prince54;
  const auto fixed = prepare<M, Ring<N>>(fixed_request());
  const auto adaptive = prepare<M, Ring<N>>(adaptive_request());
  const Ring<N> ring;
  decltype(OdeView::rhs) volatile unknown_to_the_compiler = view_of(ring).rhs;
  const auto rhs = unknown_to_the_compiler;
  const auto inlined_rhs = [&](const double* y, double* f) { ring.rhs(0, y, f); };
  const auto called_rhs = [&](const double* y, double* f) { rhs(&ring, 0, y, f); };
  const std::vector<Timing> t = interleave(
      {[&] { keep(plain_steps<N>(inlined_rhs, steps, 0.01)); }, fixed.inlined, fixed.by_pointer,
       adaptive.inlined, [&] { keep(plain_steps<N>(called_rhs, steps, 0.01)); }},
      0.5);
  constexpr double evaluations = 6 * static_cast<double>(steps);
  // Each stage waits for its rates and the right-hand side for its argument, both through memory,
  // so that a call costs a program with stages more than its jump.
  const double call = std::max(0.0, t[4].min - t[0].min) / evaluations;
  Row inlined = compare(fmt::format("explicit, {}: inlined / plain program", N), 1.2, t[0], t[1],
                        fmt::format("{:.2f} ns an evaluation", 1e9 * t[1].min / evaluations));
  inlined.at_most = true;
  rows.push_back(std::move(inlined));
  const double pointer = t[2].min / evaluations, direct = t[1].min / evaluations;
  rows.push_back({.what = fmt::format("explicit, {}: by pointer / (1.2 inlined + the call)", N),
                  .goal = 1,
                  .measured = pointer / (1.2 * direct + call),
                  .at_most = true,
                  .note = fmt::format("{:.2f} ns an evaluation, {:.2f} of them the call",
                                      1e9 * pointer, 1e9 * call)});
  const Counters& c = adaptive.counters;
  const auto trials = static_cast<double>(c.steps + c.rejected_steps);
  const double beyond =
      1e9 * (t[3].min / trials - static_cast<double>(c.rhs_evaluations) / trials * direct);
  rows.push_back({.what = fmt::format("explicit, {}: adaptive part of a step", N),
                  .goal = N == 4 ? 15 : nan,
                  .measured = beyond,
                  .at_most = true,
                  .unit = " ns"});
}

/// Any family: nanoseconds an evaluation of an adaptive run, by pointer over inlined.
template <class M, class P>
void family_row(std::vector<Row>& rows) {
  const auto run = prepare<M, P>(adaptive_request());
  const std::vector<Timing> t = interleave({run.inlined, run.by_pointer}, 0.2);
  const auto evaluations = static_cast<double>(run.counters.rhs_evaluations);
  const auto trials = static_cast<double>(run.counters.steps + run.counters.rejected_steps);
  Row row = compare(fmt::format("{}, {}: by pointer / inlined", M::info.id, P::dimension), nan,
                    t[0], t[1],
                    fmt::format("{:.1f} ns an evaluation, {:.0f} ns a step inlined",
                                1e9 * t[0].min / evaluations, 1e9 * t[0].min / trials));
  rows.push_back(std::move(row));
}

template <std::size_t... N>
void explicit_kernel(std::vector<Row>& rows, std::index_sequence<N...>) {
  (explicit_rows<N>(rows), ...);
}
/// Without a goal, so that a few numbers of unknowns tell enough: each is compiled anew.
template <std::size_t... N>
void families(std::vector<Row>& rows, std::index_sequence<N...>) {
  (family_row<methods::dormand_nystroem64, Masses<(N + 1) / 2 * 2>>(rows), ...);
  (family_row<methods::gragg_bulirsch_stoer, Ring<N>>(rows), ...);
  (family_row<methods::rodas4, Ring<N>>(rows), ...);
  (family_row<methods::radau_iia5, Ring<N>>(rows), ...);
  (family_row<methods::seulex, Ring<N>>(rows), ...);
}

}  // namespace

std::vector<Row> evaluation_rows() {
  std::vector<Row> rows;
  explicit_kernel(rows, std::index_sequence<2, 3, 4, 6, 8, 12, 16, 28>());
  families(rows, std::index_sequence<3, 8, 28>());
  rows.front().note += ", on " + cpu_model();
  return rows;
}

}  // namespace odeum::bench
