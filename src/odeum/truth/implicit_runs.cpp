// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>
#include <array>
#include <vector>

#include "odeum/tableau/collocation.hpp"
#include "odeum/truth/march.hpp"
#include "odeum/truth/shifted.hpp"

namespace odeum::truth {
namespace {

/// Radau IIA of S stages: nodes, and A with a_ij the integral of Lagrange's polynomial j to c_i.
template <std::size_t S>
struct Radau {
  Nodes<S> c = radau_right_nodes<S>();
  Matrix a{static_cast<Index>(S), static_cast<Index>(S)};
  Radau() {
    // sum_j a_ij c_j^(q-1) = c_i^q / q for q = 1..S
    const auto s = static_cast<Index>(S);
    Matrix powers(s, s), integrals(s, s);
    for (Index q = 0; q < s; ++q)
      for (Index j = 0; j < s; ++j) {
        const Real node = c[static_cast<std::size_t>(j)];
        powers(q, j) = std::pow(node, static_cast<Real>(q));
        integrals(q, j) = std::pow(node, static_cast<Real>(q + 1)) / static_cast<Real>(q + 1);
      }
    a = Eigen::FullPivLU<Matrix>(powers).solve(integrals).transpose().eval();
  }
};

/// The stages z_i = Y_i - y of one step, by Newton's method with the Jacobian at the start, in the
/// eigenvectors of A, where it is I - h lambda J for each eigenvalue (Bickart 1977; Butcher 1976).
/// Of two that are conjugate, one stands for both.
template <std::size_t S>
class RadauStage {
  struct Mode {
    Complex value;
    VectorOf<Complex> to_stages, from_stages;
    Shifted<Complex> factors;
  };

 public:
  RadauStage(const System& system, const Jacobian& jacobian, Real tolerance)
      : system_(system), tolerance_(tolerance) {
    const Eigen::EigenSolver<Matrix> of_a(radau_.a);
    const MatrixOf<Complex> vectors = of_a.eigenvectors(), inverse = vectors.inverse();
    for (Index k = 0; k < static_cast<Index>(S); ++k) {
      const Complex value = of_a.eigenvalues()(k);
      if (value.imag() < 0) continue;
      const Real stands_for = value.imag() > 0 ? 2 : 1;
      modes_.push_back({value, stands_for * vectors.col(k), inverse.row(k).transpose(),
                        Shifted<Complex>(jacobian)});
    }
  }

  /// False where it does not converge.
  bool solve(Real t, Real h, const State& y, const State& sizes) {
    const auto n = static_cast<Index>(system_.states), all = n * static_cast<Index>(S);
    work_ = 0;
    for (Mode& mode : modes_) {
      work_ += mode.factors.factor_work();
      if (!mode.factors.factorise(h * mode.value)) return false;
    }
    z_ = VectorOf<Real>::Zero(all);
    State stage(system_.states);
    VectorOf<Real> f(all), residual(all);
    Real before = 0;
    for (int iteration = 0; iteration < 30; ++iteration) {
      for (Index s = 0; s < static_cast<Index>(S); ++s) {
        for (Index i = 0; i < n; ++i)
          stage[static_cast<std::size_t>(i)] = y[static_cast<std::size_t>(i)] + z_(s * n + i);
        system_.rhs(t + radau_.c[static_cast<std::size_t>(s)] * h, stage.data(), f.data() + s * n);
      }
      work_ += static_cast<double>(S) * system_.work;
      residual = -z_;
      for (Index r = 0; r < static_cast<Index>(S); ++r)
        for (Index c = 0; c < static_cast<Index>(S); ++c)
          residual.segment(r * n, n) += h * radau_.a(r, c) * f.segment(c * n, n);
      const VectorOf<Real> correction = correction_for(residual);
      z_ += correction;
      Real size = 0;
      for (Index k = 0; k < all; ++k) {
        const Real unit = sizes[static_cast<std::size_t>(k % n)];
        const Real ratio = std::abs(correction(k)) / (unit > 0 ? unit : 1);
        if (!std::isfinite(ratio)) return false;
        size = std::max(size, ratio);
      }
      if (size <= tolerance_) return true;
      // At the rounding of the residual the corrections no longer fall.
      if (iteration > 3 && size > before / 2) return size <= 1e3L * tolerance_;
      before = size;
    }
    return false;
  }
  /// The state at the end of the step.
  Real end(const State& y, std::size_t i) const {
    return y[i] + z_(static_cast<Index>((S - 1) * system_.states + i));
  }
  double work() const { return work_; }

 private:
  VectorOf<Real> correction_for(const VectorOf<Real>& residual) {
    const auto n = static_cast<Index>(system_.states);
    VectorOf<Real> correction = VectorOf<Real>::Zero(residual.size());
    for (Mode& mode : modes_) {
      VectorOf<Complex> part = VectorOf<Complex>::Zero(n);
      for (Index s = 0; s < static_cast<Index>(S); ++s)
        part += mode.from_stages(s) * residual.segment(s * n, n).template cast<Complex>();
      part = mode.factors.solve(part);
      for (Index s = 0; s < static_cast<Index>(S); ++s)
        correction.segment(s * n, n) += (mode.to_stages(s) * part).real();
      work_ += mode.factors.solve_work();
    }
    return correction;
  }

  const System& system_;
  Real tolerance_;
  Radau<S> radau_;
  std::vector<Mode> modes_;
  VectorOf<Real> z_;
  double work_ = 0;
};

}  // namespace

Run radau_run(const System& system, const std::vector<Real>& times, const Effort& effort) {
  // The method of fewer stages estimates the error; of its order, but damped like the solution
  // where components are stiff.
  const Real newton = std::max(effort.tolerance / 10, 2 * system.rounding);
  Jacobian jacobian(system);
  RadauStage<7> method(system, jacobian, newton);
  RadauStage<5> estimate(system, jacobian, newton);
  return march(system, times, effort, 9, [&](Real t, Real h, const State& y, const State& sizes) {
    Trial trial{.y = y, .work = 0};
    jacobian.linearise(t, y);
    const bool solved = method.solve(t, h, y, sizes) && estimate.solve(t, h, y, sizes);
    trial.work = method.work() + estimate.work();
    if (!solved) {
      trial.error = std::numeric_limits<Real>::infinity();
      return trial;
    }
    State difference(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
      trial.y[i] = method.end(y, i);
      difference[i] = trial.y[i] - estimate.end(y, i);
    }
    // The estimate is four orders below the method.
    trial.error = largest_ratio(difference, sizes) / std::pow(effort.tolerance, 0.75L);
    return trial;
  });
}

Run implicit_extrapolation_run(const System& system, const std::vector<Real>& times,
                               const Effort& effort) {
  constexpr int lines = 8;
  const Real tolerance =
      std::max(effort.tolerance, finest_implicit_extrapolation * (system.rounding / 0x1p-63L));
  const auto n = static_cast<Index>(system.states);
  std::array<State, lines> table;
  State line(system.states), difference(system.states), at(system.states);
  VectorOf<Real> f(n);
  Jacobian jacobian(system);
  Shifted<Real> factors(jacobian);
  return march(
      system, times, effort, lines, [&](Real t, Real h, const State& y, const State& sizes) {
        Trial trial{.y = y, .work = 0};
        jacobian.linearise(t, y);
        for (int row = 0; row < lines; ++row) {
          // Deuflhard, Nowak: the harmonic sequence from 2, (I - h J) d = h f(t + h, y).
          const int parts = row + 2;
          const Real part = h / parts;
          if (!factors.factorise(part)) {
            trial.error = std::numeric_limits<Real>::infinity();
            return trial;
          }
          std::ranges::fill(line, 0);
          for (int k = 1; k <= parts; ++k) {
            for (std::size_t i = 0; i < line.size(); ++i) at[i] = y[i] + line[i];
            system.rhs(t + k * part, at.data(), f.data());
            const VectorOf<Real> d = factors.solve(part * f);
            for (Index i = 0; i < n; ++i) line[static_cast<std::size_t>(i)] += d(i);
          }
          trial.work += factors.factor_work() + parts * (system.work + factors.solve_work());
          for (int k = 0; k < row; ++k) {
            const Real weight = 1 / (static_cast<Real>(parts) / (row - k - 1 + 2) - 1);
            State& above = table[static_cast<std::size_t>(k)];
            for (std::size_t i = 0; i < line.size(); ++i) {
              const Real left = line[i], change = weight * (left - above[i]);
              above[i] = left;
              line[i] = left + change;
              difference[i] = change;
            }
          }
          table[static_cast<std::size_t>(row)] = line;
        }
        for (std::size_t i = 0; i < line.size(); ++i) trial.y[i] += line[i];
        trial.error = largest_ratio(difference, sizes) / tolerance;
        return trial;
      });
}

}  // namespace odeum::truth
