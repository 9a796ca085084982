// SPDX-License-Identifier: BSD-3-Clause
// Mutants written by hand: typical mistakes in Verlet, leapfrog and Euler updates.
#include <algorithm>

#include "odeum/proof/code_checks.hpp"
#include "odeum/proof/mutant.hpp"

namespace odeum::proof {
namespace {

using Vector = std::vector<double>;

/// Steps by two functions of (this, t, h): what is done before the first one, and in each.
template <bool V, class Start, class Step>
class Update : public AnyStepper {
 public:
  Update(const FunctionMechanics<V>& problem, const Start& start, const Step& step)
      : n(problem.size() / 2), kept(n), problem_(problem), start_(start), step_(step) {}
  void start(double t, double h, const Vector& from) override {
    y = from;
    start_(*this, t, h);
  }
  Status step(double t, double h, Vector& state, Vector* error) override {
    if (error) return Status::refused;
    y = state;
    step_(*this, t, h);
    state = y;
    return Status::ok;
  }

  Vector acceleration(double t) const {
    Vector a(n);
    problem_.acceleration(t, y.data(), y.data() + n, a.data());
    return a;
  }
  void drift(double h) {
    for (std::size_t i = 0; i < n; ++i) y[i] += h * y[n + i];
  }
  void kick(double h, const Vector& a) {
    for (std::size_t i = 0; i < n; ++i) y[n + i] += h * a[i];
  }

  std::size_t n;
  Vector y, kept;  ///< the state, positions first, and what a method keeps between its steps

 private:
  const FunctionMechanics<V>& problem_;
  Start start_;
  Step step_;
};

template <class Start, class Step>
Code started(Start start, Step step) {
  Code code;
  code.on_separable = [=](const FunctionMechanics<false>& p) {
    return std::make_unique<Update<false, Start, Step>>(p, start, step);
  };
  code.on_second_order = [=](const FunctionMechanics<true>& p) {
    return std::make_unique<Update<true, Start, Step>>(p, start, step);
  };
  return code;
}

/// A method that keeps nothing.
template <class Step>
Code one_step(Step step) {
  return started([](auto&, double, double) {}, step);
}

/// Leapfrog; its velocity starts with a kick of `half` h, and the velocity reported is `shown` h
/// behind. Correct: 1/2 and 1/2.
Code leapfrog(double half, double shown) {
  return started(
      [=](auto& s, double t, double h) {
        const Vector a = s.acceleration(t);
        for (std::size_t i = 0; i < s.n; ++i) s.kept[i] = s.y[s.n + i] + half * h * a[i];
      },
      [=](auto& s, double t, double h) {
        for (std::size_t i = 0; i < s.n; ++i) s.y[i] += h * s.kept[i];
        const Vector a = s.acceleration(t + h);
        for (std::size_t i = 0; i < s.n; ++i) {
          s.kept[i] += h * a[i];
          s.y[s.n + i] = s.kept[i] - shown * h * a[i];
        }
      });
}

/// Stormer's recurrence started by q_1 = q_0 + h v_0 + `half` h^2 a_0, with the velocity from the
/// last two positions where `one_sided`.
Code stormer(double half, bool one_sided) {
  return started(
      [=](auto& s, double t, double h) {
        const Vector a = s.acceleration(t);
        for (std::size_t i = 0; i < s.n; ++i)
          s.kept[i] = s.y[i] + h * s.y[s.n + i] + half * h * h * a[i];
      },
      [=](auto& s, double t, double h) {
        const Vector before = s.y;
        std::ranges::copy(s.kept, s.y.begin());
        const Vector a = s.acceleration(t + h);
        for (std::size_t i = 0; i < s.n; ++i) {
          s.kept[i] = 2 * s.y[i] - before[i] + h * h * a[i];
          s.y[s.n + i] = one_sided ? (s.y[i] - before[i]) / h : (s.kept[i] - before[i]) / (2 * h);
        }
      });
}

/// Explicit Euler: both updates from the old state.
Code both_old() {
  return one_step([](auto& s, double t, double h) {
    const Vector a = s.acceleration(t);
    s.drift(h);
    s.kick(h, a);
  });
}

struct Slip {
  const char *method, *kind, *change;
  Code code;
};

std::vector<Slip> slips() {
  return {
      {"velocity_verlet", "update", "the whole velocity first",
       one_step([](auto& s, double t, double h) {
         const Vector a = s.acceleration(t);
         s.kick(h, a);
         for (std::size_t i = 0; i < s.n; ++i) s.y[i] += h * s.y[s.n + i] + h * h / 2 * a[i];
       })},
      {"velocity_verlet", "update", "the old acceleration twice",
       one_step([](auto& s, double t, double h) {
         const Vector a = s.acceleration(t);
         s.kick(h / 2, a);
         s.drift(h);
         s.kick(h / 2, a);
       })},
      {"velocity_verlet", "update", "the second half kick left out",
       one_step([](auto& s, double t, double h) {
         s.kick(h / 2, s.acceleration(t));
         s.drift(h);
       })},
      {"velocity_verlet", "update", "no acceleration in the position",
       one_step([](auto& s, double t, double h) {
         const Vector a = s.acceleration(t);
         s.drift(h);
         const Vector next = s.acceleration(t + h);
         s.kick(h / 2, a);
         s.kick(h / 2, next);
       })},
      {"leapfrog", "start", "the first half kick left out", leapfrog(0.0, 0.5)},
      {"leapfrog", "start", "a whole kick first", leapfrog(1.0, 0.5)},
      {"leapfrog", "update", "the velocity shown half a step ahead", leapfrog(0.5, 0.0)},
      {"stormer_verlet", "start", "started by explicit Euler", stormer(0.0, false)},
      {"stormer_verlet", "update", "a one-sided velocity", stormer(0.5, true)},
      {"symplectic_euler", "update", "both from the old state", both_old()},
      {"symplectic_euler", "update", "the position first",
       one_step([](auto& s, double t, double h) {
         s.drift(h);
         s.kick(h, s.acceleration(t + h));
       })},
      {"symplectic_euler_position_first", "update", "both from the old state", both_old()},
      {"symplectic_euler_position_first", "update", "the velocity first",
       one_step([](auto& s, double t, double h) {
         s.kick(h, s.acceleration(t));
         s.drift(h);
       })},
  };
}

}  // namespace

std::vector<Mutant> mutate_updates(const std::vector<MethodFacts>& methods) {
  std::vector<Mutant> mutants;
  for (Slip& slip : slips())
    for (const MethodFacts& method : methods) {
      if (method.info.id != slip.method) continue;
      if (!method.on_second_order) slip.code.on_second_order = {};
      mutants.push_back({.method = slip.method,
                         .kind = slip.kind,
                         .change = slip.change,
                         .caught_by = CodeChecks(method).first_failure(slip.code)});
    }
  return mutants;
}

}  // namespace odeum::proof
