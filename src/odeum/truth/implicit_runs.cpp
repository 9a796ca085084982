// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>
#include <array>
#include <optional>

#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/tableau/collocation.hpp"
#include "odeum/truth/march.hpp"

namespace odeum::truth {
namespace {

using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Factors = Eigen::PartialPivLU<Matrix>;
using Index = Eigen::Index;

/// The Jacobian of a system, dense or in a band, and the factors of I - h A x J for the S x S
/// matrix A of a method; vectors hold the stages one after the other.
class StageFactors {
 public:
  explicit StageFactors(const System& system) : system_(system), n_(system.states) {
    if (!system_.entries) return;
    narrow_ = linear::band_of(*system_.sparsity, linear::reverse_cuthill_mckee(*system_.sparsity));
    values_.resize(system_.sparsity->entries());
  }
  void linearise(Real t, const State& y) {
    if (system_.entries) return system_.entries(t, y.data(), values_.data());
    dense_.resize(static_cast<Index>(n_), static_cast<Index>(n_));
    system_.jacobian(t, y.data(), dense_.data());
  }
  /// False where a band is singular or not finite.
  bool factorise(Real h, const Matrix& a) {
    stages_ = static_cast<std::size_t>(a.rows());
    return system_.entries ? factorise_band(h, a) : factorise_dense(h, a);
  }
  Vector solve(const Vector& right) {
    if (!system_.entries) return factors_.solve(right);
    Vector x(right.size());
    for (std::size_t s = 0; s < stages_; ++s)
      for (std::size_t i = 0; i < n_; ++i)
        x(static_cast<Index>(place(s, i))) = right(static_cast<Index>(s * n_ + i));
    band_->solve(x.data(), nullptr);
    Vector result(right.size());
    for (std::size_t s = 0; s < stages_; ++s)
      for (std::size_t i = 0; i < n_; ++i)
        result(static_cast<Index>(s * n_ + i)) = x(static_cast<Index>(place(s, i)));
    return result;
  }
  /// Operations of the last factorisation, and of a solution with it.
  double factor_work() const {
    const auto all = static_cast<double>(n_ * stages_);
    if (!system_.entries) return all * all * all * 2 / 3;
    return 2 * all * static_cast<double>(stages_ * (narrow_.lower + 1)) * width();
  }
  double solve_work() const {
    const auto all = static_cast<double>(n_ * stages_);
    return 2 * all *
           (system_.entries ? width() + static_cast<double>(stages_ * narrow_.lower) : all);
  }

 private:
  double width() const {
    return static_cast<double>(stages_ * (narrow_.lower + narrow_.upper + 1));
  }
  std::size_t place(std::size_t stage, std::size_t i) const {
    return static_cast<std::size_t>(narrow_.number[i]) * stages_ + stage;
  }
  bool factorise_dense(Real h, const Matrix& a) {
    const auto n = static_cast<Index>(n_), all = n * a.rows();
    Matrix newton = Matrix::Identity(all, all);
    for (Index r = 0; r < a.rows(); ++r)
      for (Index c = 0; c < a.rows(); ++c) newton.block(r * n, c * n, n, n) -= h * a(r, c) * dense_;
    factors_.compute(newton);
    return true;
  }
  bool factorise_band(Real h, const Matrix& a) {
    const std::size_t lower = stages_ * narrow_.lower + stages_ - 1,
                      upper = stages_ * narrow_.upper + stages_ - 1;
    band_.emplace(n_ * stages_, lower, upper);
    const Sparsity& pattern = *system_.sparsity;
    for (std::size_t i = 0; i < n_; ++i)
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        for (std::size_t r = 0; r < stages_; ++r)
          for (std::size_t c = 0; c < stages_; ++c)
            band_->re()[band_->place(place(r, i),
                                     place(c, static_cast<std::size_t>(pattern.column[k])))] -=
                h * a(static_cast<Index>(r), static_cast<Index>(c)) * values_[k];
    for (std::size_t k = 0; k < n_ * stages_; ++k) band_->re()[band_->place(k, k)] += 1;
    return band_->factorise();
  }

  const System& system_;
  std::size_t n_, stages_ = 1;
  Matrix dense_;
  Factors factors_;
  linear::Band narrow_;
  State values_;
  std::optional<linear::BandedLu<false, Real>> band_;
};

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

/// The stages z_i = Y_i - y of one step, by Newton's method with the Jacobian at the start; false
/// where it does not converge.
template <std::size_t S>
class RadauStage {
 public:
  RadauStage(const System& system, Real tolerance) : system_(system), tolerance_(tolerance) {}

  bool solve(Real t, Real h, const State& y, const State& sizes, StageFactors& factors) {
    const auto n = static_cast<Index>(system_.states), all = n * static_cast<Index>(S);
    const bool regular = factors.factorise(h, radau_.a);
    work_ = factors.factor_work();
    if (!regular) return false;
    z_ = Vector::Zero(all);
    State stage(system_.states);
    Vector f(all), residual(all);
    Real before = 0;
    for (int iteration = 0; iteration < 30; ++iteration) {
      for (Index s = 0; s < static_cast<Index>(S); ++s) {
        for (Index i = 0; i < n; ++i)
          stage[static_cast<std::size_t>(i)] = y[static_cast<std::size_t>(i)] + z_(s * n + i);
        system_.rhs(t + radau_.c[static_cast<std::size_t>(s)] * h, stage.data(), f.data() + s * n);
      }
      work_ += static_cast<double>(S) * system_.work + factors.solve_work();
      residual = -z_;
      for (Index r = 0; r < static_cast<Index>(S); ++r)
        for (Index c = 0; c < static_cast<Index>(S); ++c)
          residual.segment(r * n, n) += h * radau_.a(r, c) * f.segment(c * n, n);
      const Vector correction = factors.solve(residual);
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
  const System& system_;
  Real tolerance_;
  Radau<S> radau_;
  Vector z_;
  double work_ = 0;
};

}  // namespace

Run radau_run(const System& system, const std::vector<Real>& times, const Effort& effort) {
  // The method of fewer stages estimates the error; of its order, but damped like the solution
  // where components are stiff.
  const Real newton = std::max(effort.tolerance / 10, 2 * system.rounding);
  RadauStage<7> method(system, newton);
  RadauStage<5> estimate(system, newton);
  StageFactors factors(system);
  return march(system, times, effort, 9, [&](Real t, Real h, const State& y, const State& sizes) {
    Trial trial{.y = y, .work = 0};
    factors.linearise(t, y);
    const bool solved =
        method.solve(t, h, y, sizes, factors) && estimate.solve(t, h, y, sizes, factors);
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
  Vector f(n);
  const Matrix one = Matrix::Identity(1, 1);
  StageFactors factors(system);
  return march(
      system, times, effort, lines, [&](Real t, Real h, const State& y, const State& sizes) {
        Trial trial{.y = y, .work = 0};
        factors.linearise(t, y);
        for (int row = 0; row < lines; ++row) {
          // Deuflhard, Nowak: the harmonic sequence from 2, (I - h J) d = h f(t + h, y).
          const int parts = row + 2;
          const Real part = h / parts;
          if (!factors.factorise(part, one)) {
            trial.error = std::numeric_limits<Real>::infinity();
            return trial;
          }
          std::fill(line.begin(), line.end(), 0);
          for (int k = 1; k <= parts; ++k) {
            for (std::size_t i = 0; i < line.size(); ++i) at[i] = y[i] + line[i];
            system.rhs(t + k * part, at.data(), f.data());
            const Vector d = factors.solve(part * f);
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
