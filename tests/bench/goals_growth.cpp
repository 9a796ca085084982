// SPDX-License-Identifier: BSD-3-Clause
// What a step costs an unknown as problems grow, from some ten to a million: explicit, with banded
// and with sparse factors, and the kernel of a cloth. Beside each time stands how much memory a
// step goes through, and the cache that holds it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "goals.hpp"
#include "grid_forces.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/square_cloth.hpp"

namespace odeum::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Heat on a grid of `columns` by `rows` places, zero beyond: a row is a band, a square is not.
struct Heat {
  static constexpr std::size_t dimension = dynamic;
  std::size_t columns, rows;
  Sparsity pattern;

  Heat(std::size_t wide, std::size_t high) : columns(wide), rows(high) {
    for (std::size_t i = 0; i < size(); ++i) {
      std::vector<int> row;
      for_each_neighbour(i, [&](std::size_t j) { row.push_back(static_cast<int>(j)); });
      row.push_back(static_cast<int>(i));
      pattern.add_row(row);
    }
  }
  template <class Visit>
  void for_each_neighbour(std::size_t i, Visit&& visit) const {
    const std::size_t x = i % columns, y = i / columns;
    if (y > 0) visit(i - columns);
    if (x > 0) visit(i - 1);
    if (x + 1 < columns) visit(i + 1);
    if (y + 1 < rows) visit(i + columns);
  }
  std::size_t size() const { return columns * rows; }
  void rhs(double, const double* y, double* f) const {
    if (rows > 1) {
      for (std::size_t i = 0; i < size(); ++i) {
        double sum = -4 * y[i];
        for_each_neighbour(i, [&](std::size_t j) { sum += y[j]; });
        f[i] = sum;
      }
      return;
    }
    const std::size_t last = columns - 1;
    f[0] = y[1] - 2 * y[0];
    for (std::size_t i = 1; i < last; ++i) f[i] = y[i - 1] - 2 * y[i] + y[i + 1];
    f[last] = y[last - 1] - 2 * y[last];
  }
  const Sparsity* sparsity() const { return &pattern; }
  void jacobian_entries(double, const double*, double* values) const {
    for (std::size_t i = 0; i < size(); ++i)
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        values[k] = static_cast<std::size_t>(pattern.column[k]) != i ? 1 : rows > 1 ? -4 : -2;
  }
};

/// The smallest cache of the processor that holds so many bytes.
std::string holder(double bytes) {
  const std::pair<const char*, int> caches[] = {{"the first cache", _SC_LEVEL1_DCACHE_SIZE},
                                                {"the second cache", _SC_LEVEL2_CACHE_SIZE},
                                                {"the third cache", _SC_LEVEL3_CACHE_SIZE}};
  for (const auto& [name, key] : caches)
    if (bytes <= static_cast<double>(sysconf(key))) return name;
  return "memory";
}

/// One family at all sizes: seconds of a step, and bytes that it goes through.
struct Sized {
  std::size_t unknowns;
  double seconds, bytes;
};

void add_rows(std::vector<Row>& rows, const std::string& name, const std::vector<Sized>& all,
              double goal) {
  const auto each = [](const Sized& s) {
    return 1e9 * s.seconds / static_cast<double>(s.unknowns);
  };
  for (const Sized& s : all)
    rows.push_back({.what = fmt::format("{}, {} unknowns", name, s.unknowns),
                    .goal = nan,
                    .measured = each(s),
                    .unit = " ns",
                    .note = fmt::format("a step goes through {} kB: {}",
                                        three_digits(s.bytes / 1e3), holder(s.bytes))});
  const auto least = std::min_element(
      all.begin(), all.end(), [&](const Sized& a, const Sized& b) { return each(a) < each(b); });
  rows.push_back({.what = fmt::format("{}: {} unknowns over the least", name, all.back().unknowns),
                  .goal = goal,
                  .measured = each(all.back()) / each(*least),
                  .at_most = true,
                  .note = fmt::format("the least is at {} unknowns", least->unknowns)});
}

/// A step of a solver on heat of each size: three times as many steps less once as many, so that
/// what is done once a run, such as the order of elimination, is left out.
std::vector<Sized> steps_of(const std::string& id, const std::vector<Heat>& problems,
                            double numbers_a_unknown) {
  std::vector<Sized> all;
  for (const Heat& problem : problems) {
    const std::size_t n = problem.size();
    Case c;
    c.y0.assign(n, 1.0);
    cases::set_problem(c, problem);
    const Entrant* const solver = c.entrants.find(id);
    const std::uint64_t steps = std::max<std::uint64_t>(1, 200'000 / n);
    const auto run = [&](std::uint64_t count) {
      return [solver, count] {
        Request request{.steps = count, .stops = {0.01 * static_cast<double>(count)}};
        request.budget.watched = false;
        solver->solve(request);
      };
    };
    const auto t = interleave({run(steps), run(3 * steps)}, 0.1);
    all.push_back({n, std::max(0.0, t[1].min - t[0].min) / (2 * static_cast<double>(steps)),
                   8 * numbers_a_unknown * static_cast<double>(n)});
  }
  return all;
}

std::vector<Sized> cloths() {
  std::vector<Sized> all;
  for (const std::size_t side : {4, 13, 41, 129, 408}) {
    GridForces<double> grid(cases::square_cloth(side, 10));
    const std::size_t n = 6 * side * side, times = 1 + 2'000'000 / n;
    const auto t = interleave({[&] {
                                for (std::size_t k = 0; k < times; ++k) grid.forces();
                              }},
                              0.3);
    all.push_back(
        {n, t[0].min / static_cast<double>(times), 8 * 3 * static_cast<double>(grid.layout.size)});
  }
  return all;
}

}  // namespace

std::vector<Row> growth_rows() {
  std::vector<Heat> lines, squares;
  for (const std::size_t n : {10, 100, 1000, 10'000, 100'000, 1'000'000}) lines.emplace_back(n, 1);
  for (const std::size_t n : {3, 10, 32, 100, 200}) squares.emplace_back(n, n);
  std::vector<Row> rows;
  // Numbers of a step: states and stages, and for factors those of the band.
  add_rows(rows, "explicit, rk4", steps_of("odeum/rk4", lines, 6), 3);
  add_rows(rows, "banded factors, rodas4", steps_of("odeum/rodas4", lines, 18), 3);
  add_rows(rows, "sparse factors, rodas4", steps_of("odeum/rodas4", squares, 60), nan);
  rows.back().note +=
      "; Eigen's SparseLU in the order of COLAMD, where the best order of a square grid takes "
      "n^1.5 operations";
  add_rows(rows, "forces of a cloth, grid kernel", cloths(), 3);
  return rows;
}

}  // namespace odeum::bench
