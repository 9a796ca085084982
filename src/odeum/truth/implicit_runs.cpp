// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "odeum/kernel/stage_transform.hpp"
#include "odeum/tableau/collocation.hpp"
#include "odeum/truth/march.hpp"
#include "odeum/truth/shifted.hpp"

namespace odeum::truth {
namespace {

/// Radau IIA: its nodes, and A by rows, with a_ij the integral of Lagrange's polynomial j to c_i.
struct Radau {
  State c, a;

  template <std::size_t S>
  explicit Radau(const Nodes<S>& nodes) : c(nodes.begin(), nodes.end()) {
    // sum_j a_ij c_j^(q-1) = c_i^q / q for q = 1..S
    linear::Lu<Real> powers(S);
    for (std::size_t q = 0; q < S; ++q)
      for (std::size_t j = 0; j < S; ++j)
        powers.data()[q * S + j] = std::pow(c[j], static_cast<Real>(q));
    powers.factorise();
    for (const Real node : c) {
      State row;
      for (std::size_t q = 1; q <= S; ++q)
        row.push_back(std::pow(node, static_cast<Real>(q)) / static_cast<Real>(q));
      powers.solve(row.data());
      a.insert(a.end(), row.begin(), row.end());
    }
  }
  std::size_t stages() const { return c.size(); }
};

/// The stages z_i = Y_i - y of one step, by Newton's method with the Jacobian at the start, in the
/// eigenvectors of A, where it is I - h lambda J for each eigenvalue (Bickart 1977; Butcher 1976).
/// One eigenvalue stands for its conjugate. They are known in double, which is enough for
/// corrections: residuals are in extended precision.
class RadauStage {
  struct Mode {
    Complex value;
    std::vector<Complex> to_stages, from_stages;
    Shifted<Complex> factors;
  };

 public:
  RadauStage(Radau radau, const System& system, const Jacobian& jacobian, Real tolerance)
      : radau_(std::move(radau)), system_(system), tolerance_(tolerance) {
    const std::vector<double> a(radau_.a.begin(), radau_.a.end());
    const std::size_t s = radau_.stages();
    const StageTransform of_a =
        make_stage_transform(a, {a.end() - static_cast<std::ptrdiff_t>(s), a.end()});
    const auto extended = [](const std::vector<std::complex<double>>& vector) {
      return std::vector<Complex>(vector.begin(), vector.end());
    };
    for (std::size_t k = 0; k < of_a.inverse_mu.size(); ++k)
      modes_.push_back({Complex(of_a.inverse_mu[k]), extended(of_a.t[k]), extended(of_a.ti[k]),
                        Shifted<Complex>(jacobian)});
  }

  /// False where it does not converge.
  bool solve(Real t, Real h, const State& y, const State& sizes) {
    const std::size_t n = system_.states, stages = radau_.stages();
    work_ = 0;
    for (Mode& mode : modes_) {
      work_ += mode.factors.factor_work();
      if (!mode.factors.factorise(h * mode.value)) return false;
    }
    z_.assign(stages * n, 0);
    State stage(n), f(z_.size()), residual(z_.size());
    Real before = 0;
    for (int iteration = 0; iteration < 30; ++iteration) {
      for (std::size_t s = 0; s < stages; ++s) {
        for (std::size_t i = 0; i < n; ++i) stage[i] = y[i] + z_[s * n + i];
        system_.rhs(t + radau_.c[s] * h, stage.data(), f.data() + s * n);
      }
      work_ +=
          static_cast<double>(stages) * (system_.work + 200 + 4 * static_cast<double>(stages * n));
      for (std::size_t s = 0; s < stages; ++s)
        for (std::size_t i = 0; i < n; ++i) {
          Real sum = -z_[s * n + i];
          for (std::size_t c = 0; c < stages; ++c)
            sum += h * radau_.a[s * stages + c] * f[c * n + i];
          residual[s * n + i] = sum;
        }
      const State correction = correction_for(residual);
      Real size = 0;
      for (std::size_t s = 0; s < stages; ++s)
        for (std::size_t i = 0; i < n; ++i) {
          const Real change = correction[s * n + i];
          z_[s * n + i] += change;
          const Real ratio = std::abs(change) / (sizes[i] > 0 ? sizes[i] : 1);
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
    return y[i] + z_[(radau_.stages() - 1) * system_.states + i];
  }
  double work() const { return work_; }

 private:
  State correction_for(const State& residual) {
    const std::size_t n = system_.states, stages = radau_.stages();
    State correction(residual.size());
    for (Mode& mode : modes_) {
      std::vector<Complex> part(n);
      for (std::size_t s = 0; s < stages; ++s)
        for (std::size_t i = 0; i < n; ++i) part[i] += mode.from_stages[s] * residual[s * n + i];
      mode.factors.solve(part);
      for (std::size_t s = 0; s < stages; ++s)
        for (std::size_t i = 0; i < n; ++i)
          correction[s * n + i] += (mode.to_stages[s] * part[i]).real();
      work_ += mode.factors.solve_work();
    }
    return correction;
  }

  Radau radau_;
  const System& system_;
  Real tolerance_;
  std::vector<Mode> modes_;
  State z_;
  double work_ = 0;
};

}  // namespace

Run radau_run(const System& system, const std::vector<Real>& times, const Effort& effort) {
  // The method of fewer stages estimates the error; of its order, but damped like the solution
  // where components are stiff.
  const Real newton = std::max(effort.tolerance / 10, 2 * system.rounding);
  Jacobian jacobian(system);
  RadauStage method(Radau(radau_right_nodes<7>()), system, jacobian, newton);
  RadauStage estimate(Radau(radau_right_nodes<5>()), system, jacobian, newton);
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
  std::array<State, lines> table;
  State line(system.states), difference(system.states), at(system.states), d(system.states);
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
            system.rhs(t + k * part, at.data(), d.data());
            for (Real& x : d) x *= part;
            factors.solve(d);
            for (std::size_t i = 0; i < line.size(); ++i) line[i] += d[i];
          }
          trial.work += factors.factor_work() + parts * (system.work + 60 + factors.solve_work());
          extrapolate(table, row, line, difference, [&](int k) {
            return 1 / (static_cast<Real>(parts) / (row - k - 1 + 2) - 1);
          });
        }
        for (std::size_t i = 0; i < line.size(); ++i) trial.y[i] += line[i];
        trial.error = largest_ratio(difference, sizes) / tolerance;
        return trial;
      });
}

}  // namespace odeum::truth
