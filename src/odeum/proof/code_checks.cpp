// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/code_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "odeum/proof/stability_check.hpp"
#include "odeum/proof/structure_check.hpp"

namespace odeum::proof {
namespace {

/// Calls visit(make stepper, test problem) for every test problem that the code fits.
template <class Visit>
void for_each_test(const Code& code, Visit&& visit) {
  const auto on = [&](const auto& make, const auto& tests) {
    if (!make) return;
    for (const auto& test : tests) visit(make, test);
  };
  on(code.on_problem, test_problems());
  on(code.on_separable, separable_test_problems());
  on(code.on_second_order, second_order_test_problems());
}

template <class P>
double difference_on(const MakeStepper<P>& one, const MakeStepper<P>& other,
                     const TestProblem<P>& test) {
  if (!one || !other) return 0;
  const auto a = one(test.problem), b = other(test.problem);
  std::vector<double> y = test.y0, z = test.y0, error_y, error_z;
  const double h = 0.15;
  a->start(test.t0, h, y);
  b->start(test.t0, h, z);
  double difference = 0;
  for (int i = 0; i < 8; ++i) {
    const double t = test.t0 + i * h;
    const Status first = a->step(t, h, y), second = b->step(t, h, z);
    if (first != second) return std::numeric_limits<double>::infinity();
    if (first != Status::ok) return difference;
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double apart = std::abs(y[k] - z[k]);
      if (!(apart <= difference)) difference = apart;
    }
  }
  // The error estimate is compared too.
  if (a->step(test.t0, h, y, &error_y) == Status::ok &&
      b->step(test.t0, h, z, &error_z) == Status::ok)
    for (std::size_t k = 0; k < y.size(); ++k)
      difference = std::max(difference, std::abs(error_y[k] - error_z[k]));
  return difference;
}

std::vector<EstimateQuality> estimates_of(const Code& code, const MethodInfo& info) {
  if (info.order_embedded == 0) return {};
  return code.on_problem ? estimate_quality(code.on_problem, info.order, info.order_embedded)
                         : estimate_quality(code.on_separable, info.order, info.order_embedded);
}

}  // namespace

bool same_order(const judge::OrderFit& fit, const judge::OrderFit& sound) {
  if (fit.verdict != sound.verdict) return false;
  return fit.verdict == judge::Verdict::confirmed || !(std::abs(fit.order - sound.order) > 0.15);
}

double stability_tolerance(const MethodFacts& method) {
  return method.info.family == "functional_iteration" ? 1e-10 : 1e-12;
}

double moving_frame_defect(const Code& code) {
  constexpr double t = 0.7, h = 0.3, slow = -0.8, fast = -2, w2 = 2;
  double worst = 0;
  const auto stray = [&](AnyStepper& stepper, std::vector<double> y,
                         const std::vector<double>& to) {
    stepper.start(t, h, y);
    const bool solved = stepper.step(t, h, y) == Status::ok;
    for (std::size_t i = 0; i < to.size(); ++i) {
      const double apart =
          solved ? std::abs(y[i] - to[i]) : std::numeric_limits<double>::infinity();
      if (!(apart <= worst)) worst = apart;  // NaN too
    }
  };
  if (code.on_problem) {
    FunctionProblem p;
    p.unknowns = 2;
    p.f = [](double s, const double* y, double* f) {
      f[0] = slow * (y[0] - s) + 1;
      f[1] = fast * (y[1] - s) + 1;
    };
    p.f_y = [](double, const double*, double* j) {
      j[0] = slow;
      j[1] = j[2] = 0;
      j[3] = fast;
    };
    p.f_t = [](double, const double*, double* d) {
      d[0] = -slow;
      d[1] = -fast;
    };
    stray(*code.on_problem(p), {t, t}, {t + h, t + h});
  }
  if (code.on_separable) {
    const auto p = mechanics<false>(
        1,
        {.a = [](double s, const double* q, const double*, double* a) { a[0] = -w2 * (q[0] - s); },
         .a_q = [](double, const double*, const double*, double* a) { a[0] = -w2; },
         .a_t = [](double, const double*, const double*, double* a) { a[0] = w2; }});
    stray(*code.on_separable(p), {t, 1}, {t + h, 1});
  }
  return worst;
}

CodeChecks::CodeChecks(const MethodFacts& sound) : sound_(sound) {
  for_each_test(sound, [&](const auto& make, const auto& test) {
    orders_.push_back(measure_order(make, sound.info.order, test, sound.rounding));
  });
  estimates_ = estimates_of(sound, sound.info);
  const double tolerance = stability_tolerance(sound);
  const auto add = [&](const char* name, bool applies, std::function<bool(const Code&)> passes) {
    if (applies && passes(sound)) checks_.push_back({name, std::move(passes)});
  };
  const bool any_problem{sound.on_problem}, mechanics{sound.on_mechanics()};
  add("stability function", any_problem && (sound.info.one_step || sound.recurrence),
      [&sound, tolerance](const Code& code) {
        const auto compare = sound.recurrence ? compare_recurrence : compare_stability;
        return compare(code.on_problem, sound).difference <= tolerance;
      });
  add("map of the oscillator", bool(sound.on_separable), [&sound, tolerance](const Code& code) {
    return compare_oscillator_map(code.on_separable, sound).difference <= tolerance;
  });
  add("interpreted tableau", any_problem && sound.tableau, [&sound](const Code& code) {
    const bool with_estimate = sound.tableau->order_hat == sound.info.order_embedded;
    return compare_with_tableau(code.on_problem, *sound.tableau, with_estimate) <= tableau_rounding;
  });
  add("moving frame", true,
      [tolerance](const Code& code) { return moving_frame_defect(code) <= tolerance; });
  add("symplectic form", mechanics, [](const Code& code) {
    return symplectic_defect(code.on_mechanics(), structure_step) <= symplectic_rounding;
  });
  add("return", mechanics, [](const Code& code) {
    return return_defect(code.on_mechanics(), structure_step) <= return_rounding;
  });
}

std::string CodeChecks::first_failure(const Code& code) const {
  std::string failure;
  auto expected = orders_.begin();
  for_each_test(code, [&](const auto& make, const auto& test) {
    if (!failure.empty()) return;
    const judge::OrderFit fit = measure_order(make, sound_.info.order, test, sound_.rounding);
    if (!same_order(fit, *expected++))
      failure = fmt::format("order on {}: {}", test.id, to_string(fit.verdict));
  });
  if (!failure.empty()) return failure;
  for (const Check& check : checks_)
    if (!check.passes(code)) return check.name;
  const std::vector<EstimateQuality> found = estimates_of(code, sound_.info);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (estimates_[i].right_exponent() && !found[i].right_exponent())
      return "order of the error estimate";
  return {};
}

double difference_between(const Code& one, const Code& other) {
  return std::max(
      {difference_on(one.on_problem, other.on_problem, test_problems().back()),
       difference_on(one.on_separable, other.on_separable, separable_test_problems().back()),
       difference_on(one.on_second_order, other.on_second_order,
                     second_order_test_problems().back())});
}

}  // namespace odeum::proof
