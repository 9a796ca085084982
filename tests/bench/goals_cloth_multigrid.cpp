// SPDX-License-Identifier: BSD-3-Clause
// Frames of a cloth whose linear systems are solved with multigrid, beside those of the cloth's own
// solvers.
#include <fmt/format.h>

#include <cmath>

#include "goals.hpp"
#include "odeum/cases/square_cloth.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/linear/multigrid.hpp"
#include "odeum/methods/imex_verlet.hpp"
#include "odeum/scene/springs/grid_cloth.hpp"
#include "odeum/scene/springs/grid_matrix.hpp"
#include "odeum/studies/cost/cloth_lanes.hpp"

namespace odeum::bench {
namespace {

using linear::SparseMatrix;
using scene::GridLayout;
constexpr int n = 256;
constexpr double relative = 1e-2, frame = 1. / 60;

/// Bilinear interpolation from every second node of a grid of m x m (m even) to all, of vectors of
/// `components` numbers a node.
SparseMatrix bilinear(int m, int components) {
  std::vector<linear::Triplet> entries;
  const auto add = [&](int i, int j, int up, int across) {
    const int k = i / 2 + up, l = j / 2 + across;
    if ((i % 2 == 0 && up > 0) || (j % 2 == 0 && across > 0) || k >= m / 2 || l >= m / 2) return;
    for (int d = 0; d < components; ++d)
      entries.push_back({(i * m + j) * components + d, (k * (m / 2) + l) * components + d,
                         (i % 2 ? 0.5 : 1) * (j % 2 ? 0.5 : 1)});
  };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j)
      for (const int up : {0, 1})
        for (const int across : {0, 1}) add(i, j, up, across);
  return linear::from_triplets(m * m * components, m * m / 4 * components, entries);
}

std::vector<SparseMatrix> prolongations(int components) {
  std::vector<SparseMatrix> all;
  for (int fine = n; fine > 8; fine /= 2) all.push_back(bilinear(fine, components));
  return all;
}

/// Calls visit(number, place) for every particle.
template <class Visit>
void each_particle(const GridLayout& layout, Visit&& visit) {
  for (std::size_t r = 0; r < layout.rows; ++r)
    for (std::size_t c = 0; c < layout.columns; ++c)
      visit(r * layout.columns + c, layout.row(r) + c);
}

/// The cloth with its dampers solved for by conjugate gradients with multigrid, for steps of h.
class MultigridCloth : public scene::GridCloth<float> {
 public:
  MultigridCloth(const scene::Scene& scene, double h)
      : GridCloth(scene), matrix_(matrix_of(scene, h)), multigrid_(matrix_, prolongations(1)) {}

  std::uint64_t damp(float, const float*, float h, float* v, double tolerance) const {
    std::vector<float> force(3 * layout().size);
    springs().damping(v, force.data(), 0, layout().rows);
    std::vector<double> right(static_cast<std::size_t>(n) * n);
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t offset = d * layout().size;
      each_particle(layout(), [&](std::size_t i, std::size_t place) {
        right[i] = free_[i] ? static_cast<double>(h * force[offset + place]) : 0;
      });
      const linear::CgOutcome outcome =
          linear::preconditioned_cg(matrix_, multigrid_, right, {.relative_residual = tolerance});
      iterations = outcome.iterations;
      each_particle(layout(), [&](std::size_t i, std::size_t place) {
        v[offset + place] += static_cast<float>(outcome.x[i]);
      });
    }
    return iterations;
  }
  mutable std::size_t iterations = 0;

 private:
  /// M - h / 2 D of one coordinate; a fixed particle has a row of its own.
  SparseMatrix matrix_of(const scene::Scene& scene, double h) {
    std::vector<linear::Triplet> entries;
    for (int i = 0; i < n * n; ++i) {
      const scene::Particle& particle = scene.particles[static_cast<std::size_t>(i)];
      free_.push_back(!particle.fixed);
      entries.push_back({i, i, particle.mass});
    }
    for (const scene::SpringKind& kind : springs().kinds())
      for (int row = 0; row + kind.row_offset < n; ++row)
        for (int column = 0; column < n; ++column) {
          if (column + kind.column_offset < 0 || column + kind.column_offset >= n) continue;
          const int a = row * n + column, b = a + kind.row_offset * n + kind.column_offset;
          const double coupling = h / 2 * kind.damping;
          for (const auto& [from, to] : {std::pair{a, b}, {b, a}}) {
            if (!free_[from]) continue;
            entries.push_back({from, from, coupling});
            if (free_[to]) entries.push_back({from, to, -coupling});
          }
        }
    return linear::from_triplets(n * n, n * n, entries);
  }

  std::vector<bool> free_;
  SparseMatrix matrix_;
  linear::Multigrid multigrid_;
};

Row imex_row(const scene::Scene& scene) {
  const double largest = study::cloth_spring_limit * std::sqrt(scene.particles[0].mass / 10);
  const auto steps = static_cast<std::size_t>(std::ceil(frame / largest));
  const double h = frame / static_cast<double>(steps);
  const auto own = study::imex_verlet_steps(scene, relative);
  const MultigridCloth cloth(scene, h);
  methods::imex_verlet::Stepper<MultigridCloth> stepper(cloth, relative);
  std::vector<double> start;
  for (const auto& part : {&scene::Particle::position, &scene::Particle::velocity})
    for (const scene::Particle& particle : scene.particles)
      start.insert(start.end(), (particle.*part).begin(), (particle.*part).end());
  std::vector<float> y = cloth.scattered(start);
  stepper.start(0, static_cast<float>(h), y);
  const std::vector<Timing> t =
      interleave({[&] {
                    for (std::size_t i = 0; i < steps; ++i)
                      stepper.step(static_cast<float>(i), static_cast<float>(h), y);
                  },
                  [&] { own->run(h, steps); }},
                 2);
  return compare("256 x 256 cloth, IMEX frame: Chebyshev / CG with multigrid", std::nan(""), t[0],
                 t[1],
                 fmt::format("{} steps, {:.3g} ms; {} iterations; set-up not in it", steps,
                             1e3 * t[1].min, cloth.iterations));
}

/// The entries of A by products with vectors that are 1 at every fifth row and column: springs
/// reach two away.
SparseMatrix entries_of(const scene::GridMatrix& matrix, const GridLayout& layout,
                        const scene::Scene& scene) {
  std::vector<linear::Triplet> entries;
  std::vector<double> x(3 * layout.size), product(3 * layout.size);
  for (int colour = 0; colour < 75; ++colour) {
    const int row = colour / 3 % 5, column = colour / 15, component = colour % 3;
    std::fill(x.begin(), x.end(), 0);
    each_particle(layout, [&](std::size_t i, std::size_t place) {
      if (static_cast<int>(i) / n % 5 == row && static_cast<int>(i) % n % 5 == column &&
          !scene.particles[i].fixed)
        x[static_cast<std::size_t>(component) * layout.size + place] = 1;
    });
    matrix.multiply(x.data(), product.data());
    each_particle(layout, [&](std::size_t i, std::size_t place) {
      // The one particle of this colour within two rows and columns.
      const int r = static_cast<int>(i) / n, c = static_cast<int>(i) % n;
      const int near_r = r + (row - r % 5 + 7) % 5 - 2, near_c = c + (column - c % 5 + 7) % 5 - 2;
      if (near_r < 0 || near_r >= n || near_c < 0 || near_c >= n) return;
      for (int d = 0; d < 3; ++d)
        if (const double value = product[static_cast<std::size_t>(d) * layout.size + place];
            value != 0)
          entries.push_back(
              {static_cast<int>(i) * 3 + d, (near_r * n + near_c) * 3 + component, value});
    });
  }
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    if (scene.particles[i].fixed)
      for (int d = 0; d < 3; ++d)
        entries.push_back({static_cast<int>(i) * 3 + d, static_cast<int>(i) * 3 + d, 1});
  return linear::from_triplets(3 * n * n, 3 * n * n, entries);
}

/// A frame as one implicit step, whose matrix depends on the state: M - h D - h^2 K.
std::vector<Row> implicit_rows(const scene::Scene& scene) {
  const scene::GridCloth<double> cloth(scene);
  const GridLayout& layout = cloth.layout();
  std::vector<double> start, mass(layout.size);
  for (const auto& part : {&scene::Particle::position, &scene::Particle::velocity})
    for (const scene::Particle& particle : scene.particles)
      start.insert(start.end(), (particle.*part).begin(), (particle.*part).end());
  each_particle(layout, [&](std::size_t i, std::size_t place) {
    mass[place] = scene.particles[i].fixed ? 0 : scene.particles[i].mass;
  });
  const std::vector<double> y = cloth.scattered(start);
  scene::GridMatrix on_grid(cloth.springs(), mass.data());
  std::vector<double> right(3 * layout.size), x, ordered(std::size_t{3} * n * n);
  on_grid.mass_times(y.data() + 3 * layout.size, right.data());
  for (std::size_t d = 0; d < 3; ++d)
    each_particle(layout, [&](std::size_t i, std::size_t place) {
      ordered[3 * i + d] = right[d * layout.size + place];
    });
  on_grid.assemble(y.data(), frame, true);
  const SparseMatrix a = entries_of(on_grid, layout, scene);
  std::unique_ptr<linear::Multigrid> multigrid;
  const Timing set_up = interleave(
      {[&] { multigrid = std::make_unique<linear::Multigrid>(a, prolongations(3)); }}, 0)[0];
  std::size_t with = 0;
  const std::uint64_t before = on_grid.products();
  std::uint64_t solves = 0;
  const std::vector<Timing> t = interleave(
      {[&] {
         with = linear::preconditioned_cg(a, *multigrid, ordered, {.relative_residual = relative})
                    .iterations;
       },
       [&] {
         x.assign(3 * layout.size, 0);
         on_grid.solve(right.data(), x.data(), relative);
         ++solves;
       }},
      2);
  const std::string iterations =
      fmt::format("{} and {} iterations", (on_grid.products() - before) / solves, with);
  return {compare("256 x 256 cloth, implicit frame: CG / CG with multigrid by blocks", std::nan(""),
                  t[0], t[1],
                  fmt::format("{}, {:.3g} ms and {:.3g} ms", iterations, 1e3 * t[1].min,
                              1e3 * t[0].min)),
          compare("256 x 256 cloth, implicit frame: CG / set-up of multigrid", std::nan(""), set_up,
                  t[1], fmt::format("{:.3g} s a step, since A changes", set_up.min))};
}

}  // namespace

std::vector<Row> cloth_multigrid_rows() {
  const scene::Scene scene = cases::square_cloth(n, 10);
  std::vector<Row> rows{imex_row(scene)};
  for (Row& row : implicit_rows(scene)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace odeum::bench
