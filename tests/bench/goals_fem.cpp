// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <cmath>
#include <numeric>
#include <utility>

#include "goals.hpp"
#include "odeum/fem/hierarchy.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/linear/linear_peer.hpp"
#include "odeum/linear/sparse_eigen.hpp"

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

Row assembly_row(const fem::Levels& levels, std::size_t threads) {
  const auto& [mesh, system] = levels.finest();
  volatile double sink = 0;
  const std::vector<Timing> t = interleave({[&, &m = mesh] {
                                              fem::assemble(m, problem, fem::vertex_rule(),
                                                            fem::Undetermined::refuse, threads);
                                            },
                                            [&, &a = system.matrix] { sink = streamed(a); }},
                                           5, threads == 1);
  Row row =
      compare(fmt::format("assembly with its checks, {} thread(s) / streaming the matrix", threads),
              8, t[1], t[0],
              fmt::format("{} triangles, {:.0f} ns each", mesh.triangles.size(),
                          1e9 * t[0].min / static_cast<double>(mesh.triangles.size())));
  row.at_most = true;
  return row;
}

/// What no assembly can leave out: every triangle's area, and a matrix that is written. The copy
/// goes into memory that is there already.
Row assembly_bound_row(const fem::Levels& levels) {
  const auto& [mesh, system] = levels.finest();
  linear::SparseMatrix written = system.matrix;
  volatile double sink = 0;
  const std::vector<Timing> t = interleave({[&, &m = mesh, &from = system.matrix] {
                                              double sum = 0;
                                              for (std::size_t k = 0; k < m.triangles.size(); ++k)
                                                sum += fem::doubled_area(m, k);
                                              written = from;
                                              sink = sum;
                                            },
                                            [&, &a = system.matrix] { sink = streamed(a); }},
                                           5);
  return compare("areas of the triangles and a copy of the matrix / streaming it", std::nan(""),
                 t[1], t[0]);
}

/// Own incomplete Cholesky as Eigen's solvers take a preconditioner.
class InEigen {
 public:
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic };
  void use(const linear::Preconditioner& m) { m_ = &m; }
  template <class Matrix>
  InEigen& analyzePattern(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  InEigen& factorize(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  InEigen& compute(const Matrix&) {
    return *this;
  }
  Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& r) const {
    Eigen::VectorXd z(r.size());
    m_->apply(r.data(), z.data());
    return z;
  }
  Eigen::ComputationInfo info() const { return Eigen::Success; }

 private:
  const linear::Preconditioner* m_ = nullptr;
};

/// Eigen's factor keeps the largest entries of each column, not those where the matrix has some: in
/// this row both have the same one.
Row same_preconditioner_row(const fem::Levels& levels) {
  const auto& system = levels.finest().system;
  const linear::IncompleteCholesky m(system.matrix);
  const linear::EigenRows a = linear::eigen_map(system.matrix);
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(
      system.right.data(), static_cast<Eigen::Index>(system.right.size()));
  Eigen::ConjugateGradient<linear::EigenRows, Eigen::Lower | Eigen::Upper, InEigen> cg;
  cg.preconditioner().use(m);
  cg.compute(a);
  cg.setTolerance(rule.relative_residual);
  Eigen::VectorXd x;
  std::size_t ours = 0;
  const std::vector<Timing> t = interleave(
      {[&] { ours = linear::preconditioned_cg(system.matrix, m, system.right, rule).iterations; },
       [&] { x = cg.solve(b); }},
      5);
  return compare("PCG with one and the same incomplete Cholesky: Eigen's time / own", 1, t[0], t[1],
                 fmt::format("{} and {} iterations", ours, cg.iterations()));
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
std::function<void()> multigrid_run(const fem::Levels& levels, std::size_t threads = 1) {
  return [&levels, threads] {
    const linear::Multigrid m = levels.multigrid(levels.size() - 1, threads);
    linear::preconditioned_cg(levels.finest().system.matrix, m, levels.finest().system.right, rule,
                              {}, threads);
  };
}

/// The solution alone: coarser matrices are made by one thread.
Row threads_row(const fem::Levels& levels) {
  const auto& system = levels.finest().system;
  const linear::Multigrid one = levels.multigrid(levels.size() - 1),
                          two = levels.multigrid(levels.size() - 1, 2);
  const std::vector<Timing> t = interleave(
      {[&] { linear::preconditioned_cg(system.matrix, one, system.right, rule); },
       [&] { linear::preconditioned_cg(system.matrix, two, system.right, rule, {}, 2); }},
      5, false);
  return compare("PCG with multigrid, solution: one thread / two", std::nan(""), t[1], t[0]);
}

/// The time per unknown of one problem against that of a quarter of it.
Row linear_row(const fem::Levels& fine, const fem::Levels& quarter, double goal) {
  const auto all = static_cast<double>(fine.finest().system.right.size()),
             part = static_cast<double>(quarter.finest().system.right.size());
  const std::vector<Timing> t = interleave({multigrid_run(fine), multigrid_run(quarter)}, 3);
  Row row = compare(
      fmt::format("multigrid, {:.0f} unknowns: time per unknown / that of {:.0f}", all, part), goal,
      t[1], t[0], fmt::format("{:.0f} ns an unknown", 1e9 * t[0].min / all));
  row.measured *= part / all, row.low *= part / all, row.high *= part / all;
  row.at_most = true;
  return row;
}

}  // namespace

/// Sizes whose matrices lie in the processor's cache (3 and 10 MB), and that do not (43 and 173
/// MB).
std::vector<Row> fem_rows() {
  const fem::Levels fine = square(6);
  // First, since memory that is new to the process takes time too, more of it after larger
  // problems.
  std::vector<Row> rows{assembly_row(fine, 1), assembly_row(fine, 2), assembly_bound_row(fine)};
  const fem::Levels huge = square(7), quarter = square(5), small = square(4);
  const auto& system = fine.finest().system;
  const std::vector<Timing> t =
      interleave({multigrid_run(fine),
                  [&] {
                    const linear::IncompleteCholesky m(system.matrix);
                    linear::preconditioned_cg(system.matrix, m, system.right, rule);
                  }},
                 10);
  for (Row& row : std::vector<Row>{
           same_preconditioner_row(small), eigen_row(small),
           compare("a million triangles: PCG with incomplete Cholesky / with multigrid", 10, t[0],
                   t[1], fmt::format("{} unknowns, {:.2g} s", system.right.size(), t[0].min)),
           linear_row(quarter, small, std::nan("")), linear_row(fine, quarter, std::nan("")),
           linear_row(huge, fine, 1.5), threads_row(fine)})
    rows.push_back(std::move(row));
  for (Row& row : cloth_multigrid_rows()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace odeum::bench
