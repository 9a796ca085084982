// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/studies/mesh/rows.hpp"

namespace odeum::study {
namespace {

constexpr double gravity = 9.81, coarsest_stiffness = 200;  // m/s^2, N/m
constexpr std::size_t coarsest = coarsest_mesh;
/// A sheet is at rest where no particle accelerates more than this part of gravity.
constexpr double at_rest = 1e-5;
constexpr int most_sheet_steps = 400'000, periods = 4;

enum class Hold { upper_edge, two_edges, two_corners };

struct Family {
  const char *springs, *scaling;
  bool shear, bend;
  double power;  ///< the stiffness of a spring goes as the number of springs along an edge to it
};

double stiffness_of(const Family& family, std::size_t n) {
  return coarsest_stiffness *
         std::pow(static_cast<double>(n - 1) / static_cast<double>(coarsest - 1), family.power);
}

bool held(Hold hold, std::size_t i, std::size_t j, std::size_t n) {
  const bool top = j == n - 1, side = i == 0 || i == n - 1;
  return hold == Hold::upper_edge ? top : hold == Hold::two_edges ? side : top && side;
}

/// Particle (i, j) is number i n + j, at (i, j, 0) / (n - 1). The sheet that is held by two edges
/// lies level: gravity is normal to it.
scene::Scene sheet(const Family& family, std::size_t n, Hold hold) {
  scene::Scene scene;
  scene.gravity =
      hold == Hold::two_edges ? scene::Vec3{0, 0, -gravity} : scene::Vec3{0, -gravity, 0};
  const double spacing = sheet_edge / static_cast<double>(n - 1);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      scene.particles.push_back(
          {.position = {static_cast<double>(i) * spacing, static_cast<double>(j) * spacing, 0},
           .mass = sheet_mass / static_cast<double>(n * n),
           .fixed = held(hold, i, j, n)});
  const auto join = [&](std::size_t a, std::size_t i, std::size_t j, double length) {
    if (i < n && j < n)  // one below zero wraps round to beyond n
      scene.springs.push_back({.a = a,
                               .b = i * n + j,
                               .stiffness = stiffness_of(family, n),
                               .rest_length = length * spacing});
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * n + j;
      join(a, i + 1, j, 1), join(a, i, j + 1, 1);
      if (family.shear) join(a, i + 1, j + 1, std::sqrt(2)), join(a, i + 1, j - 1, std::sqrt(2));
      if (family.bend) join(a, i + 2, j, 2), join(a, i, j + 2, 2);
    }
  return scene;
}

/// A sheet with its state.
class Sheet {
 public:
  Sheet(const Family& family, std::size_t n, Hold hold)
      : n_(n), scene_(sheet(family, n, hold)), problem_(scene_), v_(3 * n * n), a_(3 * n * n) {
    for (const scene::Particle& particle : scene_.particles)
      q_.insert(q_.end(), particle.position.begin(), particle.position.end());
    // No frequency is above sqrt(2 sum k / m), over the springs of a particle (Gershgorin).
    std::vector<double> sums(n * n);
    for (const scene::Spring& spring : scene_.springs)
      sums[spring.a] += spring.stiffness, sums[spring.b] += spring.stiffness;
    highest_frequency_ =
        std::sqrt(2 * *std::ranges::max_element(sums) * static_cast<double>(n * n) / sheet_mass);
  }

  const std::vector<double>& positions() const { return q_; }
  double& at(std::size_t i, std::size_t j, std::size_t axis) { return q_[3 * (i * n_ + j) + axis]; }

  /// Takes the positions of a coarser sheet at rest, interpolated.
  void start_from(Sheet& coarse) {
    const double ratio = static_cast<double>(coarse.n_ - 1) / static_cast<double>(n_ - 1);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) {
        const double x = static_cast<double>(i) * ratio, y = static_cast<double>(j) * ratio;
        const auto k = std::min(static_cast<std::size_t>(x), coarse.n_ - 2),
                   l = std::min(static_cast<std::size_t>(y), coarse.n_ - 2);
        const double s = x - static_cast<double>(k), t = y - static_cast<double>(l);
        for (std::size_t d = 0; d < 3; ++d)
          at(i, j, d) = (1 - s) * (1 - t) * coarse.at(k, l, d) +
                        s * (1 - t) * coarse.at(k + 1, l, d) +
                        (1 - s) * t * coarse.at(k, l + 1, d) + s * t * coarse.at(k + 1, l + 1, d);
      }
  }

  /// Dynamic relaxation: moves, and stops all particles whenever the kinetic energy has passed a
  /// maximum (Cundall 1976). False where the sheet does not come to rest.
  bool relax() {
    double before = 0;
    for (int step = 0; step < most_sheet_steps; ++step) {
      // Half the stable step: a stop near the limit would add to the fastest modes.
      advance(1 / highest_frequency_);
      double kinetic = 0, largest = 0;
      for (const double v : v_) kinetic += v * v;
      for (const double a : a_) largest = std::max(largest, std::abs(a));
      if (largest <= at_rest * gravity) return true;
      if (kinetic < before) std::ranges::fill(v_, 0);
      before = kinetic < before ? 0 : kinetic;
    }
    return false;
  }

  /// Mean height of the lower edge.
  double lower_edge() {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) sum += at(i, 0, 1);
    return sum / static_cast<double>(n_);
  }

  /// The period at which the lower edge passes `middle` upwards, from rest; NaN where it does not.
  double period_about(double middle) {
    const double h = 0.5 / highest_frequency_;
    double first = nan, height = lower_edge();
    for (int step = 0, passed = 0; step < most_sheet_steps; ++step) {
      advance(h);
      const double last = std::exchange(height, lower_edge());
      if (last >= middle || height < middle) continue;
      const double time = h * (step + (middle - last) / (height - last));
      if (passed++ == 0) first = time;
      if (passed > periods) return (time - first) / periods;
    }
    return nan;
  }

 private:
  // Symplectic Euler; fixed particles have no acceleration.
  void advance(double h) {
    if (interrupted) throw Interrupted();
    problem_.acceleration(0, q_.data(), v_.data(), a_.data());
    for (std::size_t i = 0; i < q_.size(); ++i) v_[i] += h * a_[i], q_[i] += h * v_[i];
  }

  std::size_t n_;
  scene::Scene scene_;
  scene::SceneProblem problem_;
  std::vector<double> q_, v_, a_;
  double highest_frequency_ = 0;  ///< radians per s, not below any
};

/// The sheets of one family, each relaxed from the shape of the coarser one.
MeshResult measure(const Family& family, std::size_t most) {
  MeshResult result;
  std::vector<Sheet> coarser;
  for (std::size_t n = coarsest; n <= most; n *= 2) {
    MeshRow& row = result.rows.emplace_back();
    row.springs = family.springs, row.scaling = family.scaling;
    row.particles = n, row.stiffness = stiffness_of(family, n);
    std::vector<Sheet> sheets;
    bool settled = true;
    for (const Hold hold : {Hold::upper_edge, Hold::two_edges, Hold::two_corners}) {
      if (hold == Hold::two_corners && !family.shear) continue;
      Sheet& now = sheets.emplace_back(family, n, hold);
      if (!coarser.empty()) now.start_from(coarser[sheets.size() - 1]);
      settled = now.relax() && settled;
    }
    row.status = settled ? "ok" : "unsettled";
    if (!settled) remark(row, "not at rest after 400,000 steps of relaxation");
    const double hanging = sheets[0].lower_edge();
    row.extension = -hanging;
    row.period = Sheet(family, n, Hold::upper_edge).period_about(hanging);
    row.sag = -(sheets[1].at((n - 1) / 2, n / 2, 2) + sheets[1].at(n / 2, n / 2, 2)) / 2;
    if (family.shear) {
      double lowest = 0;
      for (std::size_t i = 1; i < sheets[2].positions().size(); i += 3)
        lowest = std::min(lowest, sheets[2].positions()[i]);
      row.drape = 1 - lowest;
    } else {
      remark(row, "no drape: without shear springs the sheet held by two corners is a mechanism");
    }
    row.factor = row.extension / result.rows.front().extension;
    coarser = std::move(sheets);
  }
  return result;
}

}  // namespace

MeshResult measure_mesh(const Options& options, const Runner& runner) {
  std::vector<Family> families;
  for (const auto& [scaling, power] :
       {std::pair{"constant", 0.0}, {"per_length", 1.0}, {"per_count", -1.0}})
    for (const char* springs : {"structural", "shear", "bend"})
      families.push_back({springs, scaling, springs != std::string("structural"),
                          springs == std::string("bend"), power});
  const auto most = static_cast<std::size_t>(options.number(finest_mesh));
  return runner.run(
      "mesh", families,
      [](const Family& family) { return std::string(family.springs) + ' ' + family.scaling; },
      [&](const Family& family) { return measure(family, most); });
}

}  // namespace odeum::study
