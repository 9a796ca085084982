// SPDX-License-Identifier: BSD-3-Clause
// Own implicit methods beside CVODE with its direct solvers, a band or KLU, at equal error: the
// Brusselator with diffusion of 1,000 and of 100,000 unknowns, heat in a plate, MEDAKZO. How time
// and memory grow with the unknowns.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <string>

#include "goals.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/set_problem.hpp"
#include "problems/two_species.hpp"

namespace odeum::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double end = 2;

Case reaction(std::size_t cells) {
  Case c;
  c.y0 = cases::brusselator_1d_start(cells);
  c.stops = {end};
  cases::set_problem(c, cases::brusselator_1d_problem(cells));
  return c;
}

Outcome solve(const Case& c, const std::string& id, double tolerance) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = c.stops;
  request.budget.evaluations = 20'000;
  for (const Entrant& entrant : c.entrants)
    if (entrant.info.id() == id) return entrant.solve(request);
  return {};
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

struct Choice {
  std::string id;
  double tolerance = 0, error = 0, seconds = std::numeric_limits<double>::infinity();
};

/// The fastest of the runs whose error is at most `wanted`.
Choice fastest(const Case& c, const std::vector<std::string>& ids, double wanted,
               const std::vector<double>& truth) {
  Choice best;
  for (const std::string& id : ids)
    for (double tolerance = 1e-2; tolerance > 1e-11; tolerance /= std::sqrt(10.0)) {
      Outcome outcome;
      const Timing once = interleave({[&] { outcome = solve(c, id, tolerance); }}, 0).front();
      if (outcome.status != Status::ok) break;
      const double error = distance(outcome.states, truth);
      if (error > wanted) continue;
      if (once.min < best.seconds) best = {id, tolerance, error, once.min};
      break;
    }
  return best;
}

/// A size of this process in bytes, by its name in /proc/self/status.
double process_size(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == name + ":" && status >> kilobytes) return 1024 * kilobytes;
  return nan;
}

/// The largest rise of this process's memory during `run`, in bytes. Memory that was freed before
/// is given back and the peak is reset, so that rows measured earlier change nothing.
double peak_growth(const std::function<void()>& run) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  const double before = process_size("VmRSS");
  run();
  return process_size("VmHWM") - before;
}

void add_growth(std::vector<Row>& rows) {
  constexpr std::size_t small = 12'500, large = 50'000;
  std::vector<Timing> times;
  std::vector<double> bytes;
  for (const std::size_t cells : {small, large}) {
    const double growth = peak_growth([&] {
      const Case c = reaction(cells);
      times.push_back(interleave({[&] { solve(c, "odeum/radau_iia5", 1e-5); }}, 0).front());
    });
    bytes.push_back(growth / static_cast<double>(2 * cells));
  }
  rows.push_back(
      {.what = "time of radau_iia5, 100,000 / 25,000 unknowns",
       .goal = 4.8,
       .measured = times[1].min / times[0].min,
       .at_most = true,
       .note = fmt::format("{:.3g} s / {:.3g} s; 4 is linear", times[1].min, times[0].min)});
  rows.push_back({.what = "memory of radau_iia5 an unknown, 100,000 / 25,000 unknowns",
                  .goal = 1.3,
                  .measured = bytes[1] / bytes[0],
                  .at_most = true,
                  .note = fmt::format("{:.0f} / {:.0f} bytes an unknown", bytes[1], bytes[0])});
}

/// `known`: the error of the truth itself.
Row against_cvode(const Case& c, const std::string& name, double wanted,
                  const std::vector<double>& truth, double known) {
  Row row{.what = fmt::format("{}, at {:.0e}: CVODE / own", name, wanted),
          .goal = 2,
          .measured = nan,
          .note = fmt::format("the truth is known to {:.1e}", known)};
  if (!(known < wanted / 10)) return row;
  const Choice own = fastest(c,
                             {"odeum/rodas4", "odeum/rodas5p", "odeum/radau_iia5",
                              "odeum/radau_iia9", "odeum/seulex", "odeum/bdf_variable"},
                             wanted, truth);
  const Choice peer = fastest(c, {"cvode/bdf"}, wanted, truth);
  if (own.id.empty() || peer.id.empty()) return row;
  const std::vector<Timing> times = interleave(
      {[&] { solve(c, own.id, own.tolerance); }, [&] { solve(c, peer.id, peer.tolerance); }}, 0.2);
  return compare(row.what, row.goal, times[0], times[1],
                 fmt::format("{} in {:.3g} s, errors {:.1e} and {:.1e}; {}", own.id, times[0].min,
                             own.error, peer.error, row.note));
}

}  // namespace

std::vector<Row> sparse_rows() {
  std::vector<Row> rows;
  add_growth(rows);  // first: a peak of memory is seen once
  for (const Case& c : all_cases()) {
    if (c.id != "brusselator_1d" && c.id != "heat_2d" && c.id != "medakzo") continue;
    std::vector<double> truth(c.stops.size() * c.y0.size());
    for (std::size_t k = 0; k < c.stops.size(); ++k)
      c.truth.at(c.stops[k], truth.data() + k * c.y0.size());
    for (const double wanted : {1e-3, 1e-6})
      rows.push_back(against_cvode(c, fmt::format("{}, {} unknowns", c.title, c.y0.size()), wanted,
                                   truth, c.truth.floor));
  }
  const Case c = reaction(50'000);
  const Outcome tight = solve(c, "odeum/radau_iia5", 1e-10), other = solve(c, "cvode/bdf", 1e-10);
  for (const double wanted : {1e-3, 1e-6})
    rows.push_back(against_cvode(c, "Brusselator, 100,000 unknowns", wanted, tight.states,
                                 distance(tight.states, other.states)));
  return rows;
}

}  // namespace odeum::bench
