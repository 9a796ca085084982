// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "goals.hpp"
#include "odeum/fem/hierarchy.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/linear/linear_peer.hpp"

namespace odeum::bench {
namespace {

constexpr linear::StopRule rule{.relative_residual = 1e-8};

const fem::EllipticProblem problem{.load = [](fem::Point p) { return p.x * (1 - p.y); }};

/// The unit square in 2 n^2 triangles with n = 11 times a power of two: 704 for a million of them.
fem::Levels square(std::size_t refinements) {
  fem::Levels levels(problem, fem::vertex_rule());
  levels.add(fem::unit_square(11));
  for (std::size_t k = 0; k < refinements; ++k) levels.add(fem::refined(levels.finest().mesh));
  return levels;
}

/// Every byte of the matrix is read once.
double streamed(const linear::SparseMatrix& a) {
  double sums[8] = {};
  const std::size_t whole = a.value.size() / 8 * 8;
  for (std::size_t i = 0; i < whole; i += 8)
    for (std::size_t k = 0; k < 8; ++k) sums[k] += a.value[i + k];
  const long structure = std::accumulate(a.column.begin(), a.column.end(), 0L) +
                         std::accumulate(a.start.begin(), a.start.end(), 0L);
  return std::accumulate(sums, sums + 8, static_cast<double>(structure));
}

Row assembly_row(const fem::Levels& levels) {
  const auto& [mesh, system] = levels.finest();
  volatile double sink = 0;
  const std::vector<Timing> t =
      interleave({[&, &m = mesh] { fem::assemble(m, problem, fem::vertex_rule()); },
                  [&, &a = system.matrix] { sink = streamed(a); }},
                 5);
  Row row = compare("assembly with its checks / streaming the matrix once", 2, t[1], t[0],
                    fmt::format("{} triangles, {:.0f} ns each", mesh.triangles.size(),
                                1e9 * t[0].min / static_cast<double>(mesh.triangles.size())));
  row.at_most = true;
  return row;
}

Row eigen_row(const fem::Levels& levels) {
  const auto& system = levels.finest().system;
  const linear::IncompleteCholesky own(system.matrix);
  for (const linear::LinearPeerInfo& info : linear::linear_peers()) {
    if (info.id != "eigen/cg_ic_natural") continue;
    const auto peer = info.set_up(system.matrix);
    std::vector<double> x;
    std::size_t ours = 0, theirs = 0;
    const std::vector<Timing> t = interleave(
        {[&] {
           ours = linear::preconditioned_cg(system.matrix, own, system.right, rule).iterations;
         },
         [&] { theirs = peer->solve(system.right, x, rule.relative_residual, 100'000); }},
        5);
    return compare("PCG with incomplete Cholesky: Eigen's time / own, equal residual", 1, t[0],
                   t[1],
                   fmt::format("{} unknowns, {} iterations, {} of Eigen's", system.right.size(),
                               ours, theirs));
  }
  return {.what = "PCG with incomplete Cholesky", .goal = 1, .measured = std::nan("")};
}

/// Set-up and solution, as one system needs them.
std::function<void()> multigrid_run(const fem::Levels& levels) {
  return [&levels] {
    const linear::Multigrid m = levels.multigrid(levels.size() - 1);
    linear::preconditioned_cg(levels.finest().system.matrix, m, levels.finest().system.right, rule);
  };
}

/// Bilinear interpolation from every second node of a grid of n x n (n even) to all.
linear::SparseMatrix bilinear(int n) {
  std::vector<linear::Triplet> entries;
  const auto add = [&](int i, int j, int up, int across) {
    const int k = i / 2 + up, l = j / 2 + across;
    if ((i % 2 == 0 && up > 0) || (j % 2 == 0 && across > 0) || k >= n / 2 || l >= n / 2) return;
    entries.push_back({i * n + j, k * (n / 2) + l, (i % 2 ? 0.5 : 1) * (j % 2 ? 0.5 : 1)});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (const int up : {0, 1})
        for (const int across : {0, 1}) add(i, j, up, across);
  return linear::from_triplets(n * n, n * n / 4, entries);
}

/// I + h / 2 M^-1 D of one coordinate of the cloth of 256 x 256 of the group `steps`, whose damping
/// by the trapezoidal rule is what its IMEX frame solves, to a residual of 1e-2.
Row cloth_row(double h, const char* what) {
  constexpr int n = 256;
  constexpr double damping = 0.05, mass = 3. / (n * n);
  const double coupling = h / 2 * damping / mass;
  std::vector<linear::Triplet> entries;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * n + j;
      entries.push_back({a, a, 1});
      for (const int reach : {1, 2})
        for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
          const int k = i + reach * down, l = j + reach * right, b = k * n + l;
          if (k >= n || l >= n || l < 0) continue;
          for (const auto& [row, column] : {std::pair{a, b}, {b, a}})
            entries.push_back({row, row, coupling}), entries.push_back({row, column, -coupling});
        }
    }
  const linear::SparseMatrix a = linear::from_triplets(n * n, n * n, entries);
  std::vector<linear::SparseMatrix> prolongations;
  for (int fine = n; fine > 8; fine /= 2) prolongations.push_back(bilinear(fine));
  const linear::Multigrid m(a, std::move(prolongations));
  std::vector<double> b;
  for (int i = 0; i < n * n; ++i) b.push_back(std::sin(0.1 * (i / n)) * std::cos(0.5 * (i % n)));
  const auto solve = [&](const linear::Preconditioner& by) {
    return linear::preconditioned_cg(a, by, b, {.relative_residual = 1e-2}).iterations;
  };
  std::size_t with = 0, without = 0;
  const linear::NoPreconditioner none(a);
  const std::vector<Timing> t =
      interleave({[&] { with = solve(m); }, [&] { without = solve(none); }}, 1);
  return compare(fmt::format("256 x 256 cloth, {}: damping by CG / with multigrid", what),
                 std::nan(""), t[0], t[1],
                 fmt::format("{} and {} iterations; the set-up is not in it", without, with));
}

}  // namespace

std::vector<Row> fem_rows() {
  const fem::Levels fine = square(6), quarter = square(5), small = square(4);
  const auto& system = fine.finest().system;
  const std::vector<Timing> t =
      interleave({multigrid_run(fine),
                  [&] {
                    const linear::IncompleteCholesky m(system.matrix);
                    linear::preconditioned_cg(system.matrix, m, system.right, rule);
                  },
                  multigrid_run(quarter)},
                 10);
  Row linear_row =
      compare("multigrid: time per unknown / that with a quarter of the unknowns", 1.5, t[2], t[0]);
  const double factor = static_cast<double>(quarter.finest().system.right.size()) /
                        static_cast<double>(system.right.size());
  linear_row.measured *= factor, linear_row.low *= factor, linear_row.high *= factor;
  linear_row.at_most = true;
  return {assembly_row(fine),
          eigen_row(small),
          compare("a million triangles: PCG with incomplete Cholesky / with multigrid", 10, t[0],
                  t[1], fmt::format("{} unknowns, {:.2g} s", system.right.size(), t[0].min)),
          linear_row,
          cloth_row(1. / 60 / 14, "14 steps a frame"),
          cloth_row(1. / 60, "a step a frame")};
}

}  // namespace odeum::bench
