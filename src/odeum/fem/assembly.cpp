// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "odeum/fem/element.hpp"
#include "odeum/fem/half_edges.hpp"

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
  const Tensor a = problem.diffusion(at);
  if (!std::isfinite(a.xx) || !std::isfinite(a.xy) || !std::isfinite(a.yy))
    refuse("the tensor a is not finite", at);
  if (!(a.xx > 0 && a.xx * a.yy > a.xy * a.xy))
    refuse(fmt::format("the tensor a is not positive definite: [[{0}, {1}], [{1}, {2}]]", a.xx,
                       a.xy, a.yy),
           at);
  return a;
}

/// One assembly. Rows of the matrix are numbered as the nodes are, so that those of a node's
/// neighbours come out sorted, and no entry is sorted or looked for beyond its row.
class Assembly {
 public:
  Assembly(const TriangleMesh& mesh, const EllipticProblem& problem, const HalfEdges& edges,
           Undetermined undetermined, Team& team)
      : mesh_(mesh), problem_(problem), edges_(edges), team_(team), load_(mesh.nodes.size()) {
    system_.unknown.assign(mesh.nodes.size(), 0);
    system_.given.assign(mesh.nodes.size(), 0);
    for (const auto& [a, b] : edges.boundary)
      add_boundary_edge(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
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
    set_structure();
    take_load_at_nodes(rule);
    add_triangles(rule);
    if (!determined_) balance();
    for (std::size_t i = 0; i < load_.size(); ++i)
      if (system_.unknown[i] >= 0) system_.right[system_.unknown[i]] += load_[i];
    return std::move(system_);
  }

 private:
  void add_boundary_edge(std::size_t from, std::size_t to) {
    const Point a = mesh_.nodes[from], b = mesh_.nodes[to];
    if (!problem_.is_dirichlet || problem_.is_dirichlet(middle(a, b))) {
      determined_ = true;
      for (const std::size_t i : {from, to}) {
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
        load_[from] += (1 - s) * part, load_[to] += s * part;
        absolute_ += std::abs(part);
      }
    }
  }

  /// All entries 0: the unknowns among a node and its neighbours, which are the ends of its edges
  /// and, on the boundary, the one from which an edge comes alone.
  void set_structure() {
    linear::SparseMatrix& a = system_.matrix;
    a.rows = a.columns = static_cast<int>(system_.right.size());
    a.start.resize(system_.right.size() + 1);
    a.column.resize(edges_.to.size() + edges_.boundary.size() + system_.right.size());
    diagonal_.resize(system_.right.size());
    std::vector<std::array<int, 2>> incoming;  // node, the one from which the edge comes
    for (const auto& [from, to] : edges_.boundary) incoming.push_back({to, from});
    std::ranges::sort(incoming);
    std::size_t in = 0;
    int* end = a.column.data();
    for (int node = 0; node + 1 < static_cast<int>(edges_.start.size()); ++node) {
      const std::size_t first_in = in;
      while (in < incoming.size() && incoming[in][0] == node) ++in;
      const int row = system_.unknown[node];
      if (row < 0) continue;
      int* const begin = end;
      int place = -1;  // of the diagonal entry
      for (int k = edges_.start[node]; k < edges_.start[node + 1]; ++k) {
        const int column = system_.unknown[edges_.to[k]];
        if (place < 0 && edges_.to[k] > node) place = static_cast<int>(end - begin), *end++ = row;
        if (column >= 0) *end++ = column;
      }
      if (place < 0) place = static_cast<int>(end - begin), *end++ = row;
      for (std::size_t k = first_in; k < in; ++k)
        if (const int column = system_.unknown[incoming[k][1]]; column >= 0) *end++ = column;
      if (in > first_in) {
        std::sort(begin, end);
        place = static_cast<int>(std::find(begin, end, row) - begin);
      }
      diagonal_[row] = static_cast<int>(begin - a.column.data()) + place;
      a.start[row + 1] = static_cast<int>(end - a.column.data());
    }
    a.column.resize(static_cast<std::size_t>(end - a.column.data()));
    a.value.assign(a.column.size(), 0);
  }

  /// Where the rule takes f at nodes, once for all triangles of a node.
  void take_load_at_nodes(const Rule& rule) {
    corners_.assign(rule.nodes.size(), 3);
    for (std::size_t k = 0; k < rule.nodes.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i)
        if (rule.nodes[k].at[i] == 1) corners_[k] = i;
    if (std::ranges::all_of(corners_, [](std::size_t k) { return k == 3; })) return;
    at_nodes_.reserve(mesh_.nodes.size());
    for (const Point p : mesh_.nodes)
      at_nodes_.push_back(finite(problem_.load(p), "the load f", p));
  }

  /// A thread adds to the rows of its nodes, in the order of the triangles: sums are the same bits
  /// whatever the number of threads.
  void add_triangles(const Rule& rule) {
    if (team_.size() == 1 || !determined_) return add_rows(rule, 0, mesh_.nodes.size());
    std::atomic<bool> failed = false;
    team_.run(mesh_.nodes.size(), [&](std::size_t first, std::size_t end) {
      try {
        add_rows(rule, first, end);
      } catch (...) {
        failed = true;
      }
    });
    if (failed) throw std::runtime_error("a thread of the assembly failed");
  }

  void add_rows(const Rule& rule, std::size_t first, std::size_t end) {
    const auto mine = [=](std::size_t node) { return node >= first && node < end; };
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& ids = mesh_.triangles[t];
      const bool own[3] = {mine(ids[0]), mine(ids[1]), mine(ids[2])};
      if (!own[0] && !own[1] && !own[2]) continue;
      const Element element(mesh_, t);
      add_load(rule, element, ids, own);
      add_stiffness(element, ids, own);
    }
  }

  void add_load(const Rule& rule, const Element& element, const std::array<std::size_t, 3>& ids,
                const bool* own) {
    double sums[3] = {};
    double absolute = 0;
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const Rule::Node& node = rule.nodes[k];
      const double weight = node.weight * element.area;
      if (const std::size_t corner = corners_[k]; corner < 3) {
        const double part = weight * at_nodes_[ids[corner]];
        sums[corner] += part, absolute += std::abs(part);
        continue;
      }
      const Point at = element.at(node.at);
      const double part = weight * finite(problem_.load(at), "the load f", at);
      for (std::size_t i = 0; i < 3; ++i) sums[i] += node.at[i] * part;
      absolute += std::abs(part);
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (own[i]) load_[ids[i]] += sums[i];
    if (!determined_) absolute_ += absolute;
  }

  void add_stiffness(const Element& element, const std::array<std::size_t, 3>& ids,
                     const bool* own) {
    const Tensor a = problem_.diffusion
                         ? diffusion_at(problem_, element.at({1. / 3, 1. / 3, 1. / 3}))
                         : Tensor{};
    const ElementMatrix entries = element.stiffness(a);
    for (std::size_t i = 0; i < 3; ++i) {
      const int row = system_.unknown[ids[i]];
      if (row < 0 || !own[i]) continue;
      system_.matrix.value[diagonal_[row]] += entries[i][i];
      for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) add_entry(row, ids[j], entries[i][j]);
    }
  }

  void add_entry(int row, std::size_t node, double value) {
    const int column = system_.unknown[node];
    if (column < 0) {
      system_.right[row] -= value * system_.given[node];
      return;
    }
    const int* place = system_.matrix.column.data() + system_.matrix.start[row];
    while (*place != column) ++place;
    system_.matrix.value[place - system_.matrix.column.data()] += value;
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
  const HalfEdges& edges_;
  Team& team_;
  EllipticSystem system_;
  std::vector<double> load_;          // by node, with those where u is given
  std::vector<int> diagonal_;         // by row: the place of the diagonal entry
  std::vector<std::size_t> corners_;  // by node of the rule: the corner that it is, or 3
  std::vector<double> at_nodes_;      // f
  double absolute_ = 0;
  bool determined_ = false;
};

}  // namespace

EllipticSystem assemble(const TriangleMesh& mesh, const EllipticProblem& problem, const Rule& load,
                        Undetermined undetermined, std::size_t threads) {
  try {
    Team team(threads);
    if (const auto edges = half_edges(mesh, team))
      return Assembly(mesh, problem, *edges, undetermined, team).run(load);
  } catch (const std::runtime_error&) {
    check(mesh);  // what is wrong with a mesh is said first
    // One thread finds the first error.
    if (threads > 1) return assemble(mesh, problem, load, undetermined);
    throw;
  }
  check(mesh);
  throw std::logic_error("a mesh without edges of its own passed its check");
}

}  // namespace odeum::fem
