// SPDX-License-Identifier: BSD-3-Clause
// Mutants written by hand: typical mistakes in Verlet, leapfrog and Euler updates.
#include "odeum/proof/code_checks.hpp"
#include "odeum/proof/mutant.hpp"

namespace odeum::proof {
namespace {

using Vector = std::vector<double>;

/// The members of every update.
template <bool V>
class Update : public AnyStepper {
 public:
  explicit Update(const FunctionMechanics<V>& problem)
      : problem_(problem), n_(problem.size() / 2), a_(n_), next_(n_), half_(n_) {}

 protected:
  void accelerate(double t, const Vector& y, Vector& a) const {
    problem_.acceleration(t, y.data(), y.data() + n_, a.data());
  }
  void drift(double h, Vector& y) const {
    for (std::size_t i = 0; i < n_; ++i) y[i] += h * y[n_ + i];
  }
  void kick(double h, const Vector& a, Vector& y) const {
    for (std::size_t i = 0; i < n_; ++i) y[n_ + i] += h * a[i];
  }
  const FunctionMechanics<V>& problem_;
  std::size_t n_;
  Vector a_, next_, half_;
};

/// Verlet with the whole velocity updated before the position.
template <bool V>
struct VerletVelocityFirst : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->accelerate(t, y, this->a_);
    this->kick(h, this->a_, y);
    for (std::size_t i = 0; i < this->n_; ++i)
      y[i] += h * y[this->n_ + i] + h * h / 2 * this->a_[i];
    return Status::ok;
  }
};

/// Verlet whose second half kick takes the old acceleration again.
template <bool V>
struct VerletOldAcceleration : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->accelerate(t, y, this->a_);
    this->kick(h / 2, this->a_, y);
    this->drift(h, y);
    this->kick(h / 2, this->a_, y);
    return Status::ok;
  }
};

/// Verlet without its second half kick.
template <bool V>
struct VerletOneKick : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->accelerate(t, y, this->a_);
    this->kick(h / 2, this->a_, y);
    this->drift(h, y);
    return Status::ok;
  }
};

/// Verlet whose position forgets h^2/2 a.
template <bool V>
struct VerletNoAcceleration : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->accelerate(t, y, this->a_);
    this->drift(h, y);
    this->accelerate(t + h, y, this->next_);
    for (std::size_t i = 0; i < this->n_; ++i)
      y[this->n_ + i] += h / 2 * (this->a_[i] + this->next_[i]);
    return Status::ok;
  }
};

/// Leapfrog; its velocity starts with a kick of `half` h, and the velocity reported is `shown` h
/// behind. Correct: 1/2 and 1/2.
template <bool V>
class LeapfrogStarted : public Update<V> {
 public:
  LeapfrogStarted(const FunctionMechanics<V>& problem, double half, double shown)
      : Update<V>(problem), start_(half), shown_(shown) {}
  void start(double t, double h, const Vector& y) override {
    this->accelerate(t, y, this->a_);
    for (std::size_t i = 0; i < this->n_; ++i)
      this->half_[i] = y[this->n_ + i] + start_ * h * this->a_[i];
  }
  Status step(double t, double h, Vector& y) override {
    for (std::size_t i = 0; i < this->n_; ++i) y[i] += h * this->half_[i];
    this->accelerate(t + h, y, this->a_);
    for (std::size_t i = 0; i < this->n_; ++i) {
      this->half_[i] += h * this->a_[i];
      y[this->n_ + i] = this->half_[i] - shown_ * h * this->a_[i];
    }
    return Status::ok;
  }

 private:
  double start_, shown_;
};

/// Stormer's recurrence started by q_1 = q_0 + h v_0 + `half` h^2 a_0, with the velocity from the
/// last two positions where `one_sided`.
template <bool V>
class StormerStarted : public Update<V> {
 public:
  StormerStarted(const FunctionMechanics<V>& problem, double half, bool one_sided)
      : Update<V>(problem), start_(half), one_sided_(one_sided) {}
  void start(double t, double h, const Vector& y) override {
    this->accelerate(t, y, this->a_);
    for (std::size_t i = 0; i < this->n_; ++i)
      this->next_[i] = y[i] + h * y[this->n_ + i] + start_ * h * h * this->a_[i];
  }
  Status step(double t, double h, Vector& y) override {
    for (std::size_t i = 0; i < this->n_; ++i) {
      this->half_[i] = y[i];
      y[i] = this->next_[i];
    }
    this->accelerate(t + h, y, this->a_);
    for (std::size_t i = 0; i < this->n_; ++i) {
      this->next_[i] = 2 * y[i] - this->half_[i] + h * h * this->a_[i];
      y[this->n_ + i] =
          one_sided_ ? (y[i] - this->half_[i]) / h : (this->next_[i] - this->half_[i]) / (2 * h);
    }
    return Status::ok;
  }

 private:
  double start_;
  bool one_sided_;
};

/// Euler's updates: both from the old state (explicit Euler), or the other one of the symplectic
/// pair.
template <bool V>
struct EulerBothOld : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->accelerate(t, y, this->a_);
    this->drift(h, y);
    this->kick(h, this->a_, y);
    return Status::ok;
  }
};
template <bool V>
struct EulerPositionFirst : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->drift(h, y);
    this->accelerate(t + h, y, this->a_);
    this->kick(h, this->a_, y);
    return Status::ok;
  }
};
template <bool V>
struct EulerVelocityFirst : Update<V> {
  using Update<V>::Update;
  Status step(double t, double h, Vector& y) override {
    this->accelerate(t, y, this->a_);
    this->kick(h, this->a_, y);
    this->drift(h, y);
    return Status::ok;
  }
};

struct Slip {
  const char *method, *kind, *change;
  Code code;
};

template <template <bool> class Stepper, class... Arguments>
Code code_with(Arguments... arguments) {
  Code code;
  code.on_separable = [=](const FunctionMechanics<false>& p) {
    return std::make_unique<Stepper<false>>(p, arguments...);
  };
  code.on_second_order = [=](const FunctionMechanics<true>& p) {
    return std::make_unique<Stepper<true>>(p, arguments...);
  };
  return code;
}

std::vector<Slip> slips() {
  return {
      {"velocity_verlet", "update", "the whole velocity first", code_with<VerletVelocityFirst>()},
      {"velocity_verlet", "update", "the old acceleration twice",
       code_with<VerletOldAcceleration>()},
      {"velocity_verlet", "update", "the second half kick left out", code_with<VerletOneKick>()},
      {"velocity_verlet", "update", "no acceleration in the position",
       code_with<VerletNoAcceleration>()},
      {"leapfrog", "start", "the first half kick left out", code_with<LeapfrogStarted>(0.0, 0.5)},
      {"leapfrog", "start", "a whole kick first", code_with<LeapfrogStarted>(1.0, 0.5)},
      {"leapfrog", "update", "the velocity shown half a step ahead",
       code_with<LeapfrogStarted>(0.5, 0.0)},
      {"stormer_verlet", "start", "started by explicit Euler",
       code_with<StormerStarted>(0.0, false)},
      {"stormer_verlet", "update", "a one-sided velocity", code_with<StormerStarted>(0.5, true)},
      {"symplectic_euler", "update", "both from the old state", code_with<EulerBothOld>()},
      {"symplectic_euler", "update", "the position first", code_with<EulerPositionFirst>()},
      {"symplectic_euler_position_first", "update", "both from the old state",
       code_with<EulerBothOld>()},
      {"symplectic_euler_position_first", "update", "the velocity first",
       code_with<EulerVelocityFirst>()},
  };
}

}  // namespace

std::vector<Mutant> mutate_updates(const std::vector<MethodFacts>& methods) {
  std::vector<Mutant> mutants;
  for (Slip& slip : slips())
    for (const MethodFacts& method : methods) {
      if (method.info.id != slip.method) continue;
      if (!method.on_second_order) slip.code.on_second_order = {};
      mutants.push_back({slip.method,
                         slip.kind,
                         slip.change,
                         0,
                         CodeChecks(method).first_failure(slip.code),
                         {}});
    }
  return mutants;
}

}  // namespace odeum::proof
