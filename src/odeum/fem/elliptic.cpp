// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/elliptic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "odeum/fem/element.hpp"

namespace odeum::fem {
namespace {

[[noreturn]] void refuse(const std::string& what, Point at) {
  throw ProblemError(fmt::format("{} at ({:.6g}, {:.6g})", what, at.x, at.y));
}

double finite(double value, const char* what, Point at) {
  if (!std::isfinite(value)) refuse(fmt::format("{} is {}", what, value), at);
  return value;
}

Tensor diffusion_at(const EllipticProblem& problem, Point at) {
  if (!problem.diffusion) return {};
  const Tensor a = problem.diffusion(at);
  if (!std::isfinite(a.xx) || !std::isfinite(a.xy) || !std::isfinite(a.yy))
    refuse("the tensor a is not finite", at);
  if (!(a.xx > 0 && a.xx * a.yy > a.xy * a.xy))
    refuse(fmt::format("the tensor a is not positive definite: [[{0}, {1}], [{1}, {2}]]", a.xx,
                       a.xy, a.yy),
           at);
  return a;
}

/// The matrix of the unknowns that share a triangle, all entries 0: rows are counted, filled and
/// sorted, which takes a tenth of the time that sorting all entries takes.
linear::SparseMatrix structure_of(const TriangleMesh& mesh, const std::vector<int>& unknown,
                                  int n) {
  linear::SparseMatrix a;
  a.rows = a.columns = n;
  std::vector<int> begin(static_cast<std::size_t>(n) + 1);
  for (const auto& ids : mesh.triangles)
    for (const std::size_t i : ids)
      if (unknown[i] >= 0) begin[static_cast<std::size_t>(unknown[i]) + 1] += 3;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  // Each neighbour as often as it shares a triangle.
  std::vector<int> columns(static_cast<std::size_t>(begin.back())), end(begin.begin(), begin.end());
  for (const auto& ids : mesh.triangles)
    for (const std::size_t i : ids) {
      if (unknown[i] < 0) continue;
      for (const std::size_t j : ids)
        if (unknown[j] >= 0)
          columns[static_cast<std::size_t>(end[static_cast<std::size_t>(unknown[i])]++)] =
              unknown[j];
    }
  a.start.reserve(begin.size());
  a.column.reserve(columns.size() / 2);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    std::sort(columns.begin() + begin[i], columns.begin() + end[i]);
    const auto last = std::unique(columns.begin() + begin[i], columns.begin() + end[i]);
    a.column.insert(a.column.end(), columns.begin() + begin[i], last);
    a.start.push_back(static_cast<int>(a.column.size()));
  }
  a.value.assign(a.column.size(), 0);
  return a;
}

/// One assembly.
class Assembly {
 public:
  Assembly(const TriangleMesh& mesh, const EllipticProblem& problem, Undetermined undetermined)
      : mesh_(mesh), problem_(problem), load_(mesh.nodes.size()) {
    system_.unknown.assign(mesh.nodes.size(), 0);
    system_.given.assign(mesh.nodes.size(), 0);
    for (const auto& edge : boundary_edges(mesh)) add_boundary_edge(edge);
    if (!determined_) {
      if (undetermined == Undetermined::refuse)
        throw ProblemError(
            "u is given nowhere on the boundary (no Dirichlet condition): the system is singular, "
            "its solution is determined up to a constant; ask for the solution of mean 0, or give "
            "u on a part of the boundary");
      system_.unknown[0] = -1;
    }
    int count = 0;
    for (int& unknown : system_.unknown)
      if (unknown == 0) unknown = count++;
    if (count == 0)
      throw ProblemError("u is given at every node: nothing is left to solve for; refine the mesh");
    system_.right.assign(static_cast<std::size_t>(count), 0);
  }

  EllipticSystem run(const Rule& rule) {
    system_.matrix = structure_of(mesh_, system_.unknown, static_cast<int>(system_.right.size()));
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) add_triangle(t, rule);
    if (!determined_) balance();
    for (std::size_t i = 0; i < load_.size(); ++i)
      if (system_.unknown[i] >= 0) system_.right[system_.unknown[i]] += load_[i];
    return std::move(system_);
  }

 private:
  void add_boundary_edge(const std::array<std::size_t, 2>& edge) {
    const Point a = mesh_.nodes[edge[0]], b = mesh_.nodes[edge[1]];
    if (!problem_.is_dirichlet || problem_.is_dirichlet(middle(a, b))) {
      determined_ = true;
      for (const std::size_t i : edge) {
        system_.unknown[i] = -1;
        if (problem_.boundary_value)
          system_.given[i] =
              finite(problem_.boundary_value(mesh_.nodes[i]), "the boundary value", mesh_.nodes[i]);
      }
    } else if (problem_.flux) {
      const double length = distance(a, b);
      // The triangle lies left of the edge.
      const Point normal{(b.y - a.y) / length, (a.x - b.x) / length};
      const double offset = std::sqrt(1. / 12);  // Gauss' rule of two nodes, degree 3
      for (const double s : {0.5 - offset, 0.5 + offset}) {
        const Point at{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
        const double part = length / 2 * finite(problem_.flux(at, normal), "the flux", at);
        load_[edge[0]] += (1 - s) * part, load_[edge[1]] += s * part;
        absolute_ += std::abs(part);
      }
    }
  }

  void add_triangle(std::size_t t, const Rule& rule) {
    const Element element(mesh_, t);
    const auto& ids = mesh_.triangles[t];
    for (const Rule::Node& node : rule.nodes) {
      const Point at = element.at(node.at);
      const double part = node.weight * element.area * finite(problem_.load(at), "the load f", at);
      for (std::size_t i = 0; i < 3; ++i) load_[ids[i]] += node.at[i] * part;
      absolute_ += std::abs(part);
    }
    const auto stiffness =
        element.stiffness(diffusion_at(problem_, element.at({1. / 3, 1. / 3, 1. / 3})));
    for (std::size_t i = 0; i < 3; ++i) {
      const int row = system_.unknown[ids[i]];
      if (row < 0) continue;
      for (std::size_t j = 0; j < 3; ++j)
        if (const int column = system_.unknown[ids[j]]; column >= 0)
          entry(row, column) += stiffness[i][j];
        else
          system_.right[row] -= stiffness[i][j] * system_.given[ids[j]];
    }
  }

  /// One of the few of its row.
  double& entry(int row, int column) {
    int k = system_.matrix.start[row];
    while (system_.matrix.column[k] != column) ++k;
    return system_.matrix.value[k];
  }

  /// Subtracts from the load what it adds up to.
  void balance() {
    constexpr double most = 0.01;
    const double sum = std::accumulate(load_.begin(), load_.end(), 0.0);
    system_.imbalance = absolute_ > 0 ? sum / absolute_ : 0;
    if (std::abs(system_.imbalance) > most)
      throw ProblemError(fmt::format(
          "no solution: u is given nowhere, and load and flux add up to {:.3g} instead of 0", sum));
    double area = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) area += doubled_area(mesh_, t) / 2;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::size_t i : mesh_.triangles[t])
        load_[i] -= sum * doubled_area(mesh_, t) / (6 * area);
  }

  const TriangleMesh& mesh_;
  const EllipticProblem& problem_;
  EllipticSystem system_;
  std::vector<double> load_;  // by node, with those where u is given
  double absolute_ = 0;
  bool determined_ = false;
};

}  // namespace

std::vector<double> EllipticSystem::nodal(const std::vector<double>& x) const {
  std::vector<double> values = given;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (unknown[i] >= 0) values[i] = x[unknown[i]];
  return values;
}

EllipticSystem assemble(const TriangleMesh& mesh, const EllipticProblem& problem, const Rule& load,
                        Undetermined undetermined) {
  check(mesh);
  return Assembly(mesh, problem, undetermined).run(load);
}

std::vector<double> nodal_of_mean_zero(const TriangleMesh& mesh, const EllipticSystem& system,
                                       const std::vector<double>& x) {
  std::vector<double> values = system.nodal(x);
  double sum = 0, area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double part = doubled_area(mesh, t) / 2;
    area += part;
    for (const std::size_t i : mesh.triangles[t]) sum += part / 3 * values[i];
  }
  for (double& value : values) value -= sum / area;
  return values;
}

linear::SparseMatrix mass_matrix(const TriangleMesh& mesh) {
  std::vector<linear::Triplet> entries;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto mass = Element(mesh, t).mass();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        entries.push_back({static_cast<int>(mesh.triangles[t][i]),
                           static_cast<int>(mesh.triangles[t][j]), mass[i][j]});
  }
  const auto n = static_cast<int>(mesh.nodes.size());
  return linear::from_triplets(n, n, entries);
}

linear::SparseMatrix prolongation(const Refined& refined, const EllipticSystem& coarse,
                                  const EllipticSystem& fine) {
  std::vector<linear::Triplet> entries;
  for (std::size_t i = 0; i < refined.parents.size(); ++i)
    if (fine.unknown[i] >= 0)
      for (const std::size_t parent :
           refined.parents[i])  // both halves of a node of the coarse one
        if (coarse.unknown[parent] >= 0)
          entries.push_back({fine.unknown[i], coarse.unknown[parent], 0.5});
  return linear::from_triplets(static_cast<int>(fine.right.size()),
                               static_cast<int>(coarse.right.size()), entries);
}

FieldErrors field_errors(const TriangleMesh& mesh, const std::vector<double>& nodal,
                         const std::function<double(Point)>& value,
                         const std::function<Point(Point)>& gradient) {
  FieldErrors errors;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Element element(mesh, t);
    const auto& ids = mesh.triangles[t];
    Point slope;
    for (std::size_t i = 0; i < 3; ++i) {
      slope.x += nodal[ids[i]] * element.gradients[i].x;
      slope.y += nodal[ids[i]] * element.gradients[i].y;
      errors.maximum =
          std::fmax(errors.maximum, std::abs(nodal[ids[i]] - value(mesh.nodes[ids[i]])));
    }
    for (const Rule::Node& node : degree_5_rule().nodes) {
      const Point at = element.at(node.at), exact = gradient(at);
      double found = -value(at);
      for (std::size_t i = 0; i < 3; ++i) found += node.at[i] * nodal[ids[i]];
      const double weight = node.weight * element.area;
      errors.l2 += weight * found * found;
      errors.h1 += weight * (std::pow(slope.x - exact.x, 2) + std::pow(slope.y - exact.y, 2));
      errors.maximum = std::fmax(errors.maximum, std::abs(found));
    }
  }
  errors.l2 = std::sqrt(errors.l2), errors.h1 = std::sqrt(errors.h1);
  return errors;
}

}  // namespace odeum::fem
