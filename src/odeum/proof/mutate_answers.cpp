// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "odeum/proof/code_checks.hpp"
#include "odeum/proof/mutant.hpp"

namespace odeum::proof {
namespace {

/// An alteration of a problem's answers.
struct Fault {
  enum class Time { right, frozen, late } time = Time::right;
  int evaluation = -1;  ///< which one of a step; -1: none
  enum class Value { scaled, negated, stale } value = Value::scaled;
  double jacobian = 1, time_derivative = 1;  ///< factors
  bool euler_start = false;
};

/// The stepper's present step, known to its problem.
struct Moment {
  double t = 0, h = 0;
  bool jacobian_asked = false;
  int evaluations = 0;
  std::vector<double> last;  ///< the value of the last evaluation
};

double time_given(const Fault& fault, const Moment& now, double t) {
  switch (fault.time) {
    case Fault::Time::frozen:
      return now.t;
    case Fault::Time::late:
      return t + now.h / 100;
    default:
      return t;
  }
}

void alter(const Fault& fault, Moment& now, double* value, std::size_t n) {
  if (now.evaluations++ == fault.evaluation) {
    if (fault.value == Fault::Value::stale && now.last.size() == n)
      std::ranges::copy(now.last, value);
    else
      for (std::size_t i = 0; i < n; ++i)
        value[i] *= fault.value == Fault::Value::negated ? -1 : 1.001;
  }
  now.last.assign(value, value + n);
}

template <class P>
P altered(const P& problem, const Fault& fault, const std::shared_ptr<Moment>& now) {
  P p = problem;
  const std::size_t n = problem.size();
  p.f = [=, f = problem.f](double t, const double* y, double* out) {
    f(time_given(fault, *now, t), y, out);
    alter(fault, *now, out, n);
  };
  p.f_y = [=, f_y = problem.f_y](double t, const double* y, double* j) {
    now->jacobian_asked = true;
    f_y(time_given(fault, *now, t), y, j);
    for (std::size_t i = 0; i < n * n; ++i) j[i] *= fault.jacobian;
  };
  p.f_t = [=, f_t = problem.f_t](double t, const double* y, double* d) {
    f_t(time_given(fault, *now, t), y, d);
    for (std::size_t i = 0; i < n; ++i) d[i] *= fault.time_derivative;
  };
  if constexpr (requires { p.a; })
    p.a = [=, a = problem.a](double t, const double* q, const double* v, double* out) {
      a(time_given(fault, *now, t), q, v, out);
      alter(fault, *now, out, n / 2);
    };
  return p;
}

/// The unaltered stepper on a problem with altered answers.
template <class P>
class OnAlteredProblem : public AnyStepper {
 public:
  OnAlteredProblem(const MakeStepper<P>& make, const P& problem, const Fault& fault)
      : fault_(fault),
        now_(std::make_shared<Moment>()),
        unaltered_(problem),
        altered_(altered(problem, fault, now_)),
        stepper_(make(altered_)) {}

  void start(double t, double h, const std::vector<double>& y) override {
    *now_ = {t, h, false, -1'000'000, {}};  // evaluations of a start are not part of a step
    stepper_->start(t, h, y);
    first_ = true;
  }
  Status step(double t, double h, std::vector<double>& y, std::vector<double>* error) override {
    now_->t = t;
    now_->h = h;
    now_->evaluations = 0;
    if (error || !fault_.euler_start || !std::exchange(first_, false))
      return stepper_->step(t, h, y, error);
    std::vector<double> f(y.size()), euler = y;
    unaltered_.rhs(t, y.data(), f.data());
    for (std::size_t i = 0; i < y.size(); ++i) euler[i] += h * f[i];
    const Status status = stepper_->step(t, h, y);
    y = euler;
    return status;
  }
  int evaluations() const { return now_->evaluations; }
  bool asked_for_jacobian() const { return now_->jacobian_asked; }

 private:
  Fault fault_;
  std::shared_ptr<Moment> now_;
  const P& unaltered_;
  P altered_;
  std::unique_ptr<AnyStepper> stepper_;
  bool first_ = true;
};

template <class P>
MakeStepper<P> with_fault(const MakeStepper<P>& make, const Fault& fault) {
  if (!make) return {};
  return [make, fault](const P& problem) {
    return std::make_unique<OnAlteredProblem<P>>(make, problem, fault);
  };
}

Code with_fault(const MethodFacts& method, const Fault& fault) {
  return {with_fault(method.on_problem, fault), with_fault(method.on_separable, fault),
          with_fault(method.on_second_order, fault)};
}

/// The evaluations of a step after the start.
struct Demand {
  int evaluations = 0;
  bool jacobian = false;
};

template <class P>
Demand demand_of(const MakeStepper<P>& make, const TestProblem<P>& test) {
  OnAlteredProblem<P> stepper(make, test.problem, {});
  std::vector<double> y = test.y0;
  const double h = 0.05;
  stepper.start(test.t0, h, y);
  for (int i = 0; i < 8; ++i) stepper.step(test.t0 + i * h, h, y, nullptr);
  return {stepper.evaluations(), stepper.asked_for_jacobian()};
}

Demand demand_of(const MethodFacts& method) {
  if (method.on_problem) return demand_of(method.on_problem, test_problems().back());
  return demand_of(method.on_separable, separable_test_problems().back());
}

constexpr int most_evaluations = 24;  // of extrapolation methods, the first ones

struct Named {
  const char* kind;
  std::string change;
  Fault fault;
};

std::vector<Named> faults_for(const MethodFacts& method) {
  std::vector<Named> all{
      {"time", "every evaluation at the start of the step", {.time = Fault::Time::frozen}},
      {"time", "every evaluation a hundredth of a step late", {.time = Fault::Time::late}}};
  const std::string_view family = method.info.family;
  if (family == "linearly_implicit") {
    all.push_back({"derivative", "Jacobian larger by 1 %", {.jacobian = 1.01}});
    all.push_back({"derivative", "df/dt left out", {.time_derivative = 0}});
  }
  if (!method.info.one_step && family == "multistep")
    all.push_back({"start", "first step by explicit Euler", {.euler_start = true}});
  // An iteration corrects an error of a single evaluation: no mutants of single ones there. Methods
  // that solve linear systems only have no iteration.
  const Demand demand = demand_of(method);
  const bool linear_systems = family == "linearly_implicit" || family == "extrapolation";
  if (family == "functional_iteration" || (demand.jacobian && !linear_systems)) return all;
  const int evaluations = std::min(demand.evaluations, most_evaluations);
  for (int k = 0; k < evaluations; ++k) {
    const std::string name = fmt::format("evaluation {} ", k + 1);
    all.push_back(
        {"evaluation", name + "larger by 0.1 %", {.evaluation = k, .value = Fault::Value::scaled}});
    all.push_back(
        {"evaluation", name + "negated", {.evaluation = k, .value = Fault::Value::negated}});
    all.push_back({"evaluation",
                   name + "replaced by the one before",
                   {.evaluation = k, .value = Fault::Value::stale}});
  }
  return all;
}

}  // namespace

std::vector<Mutant> mutate_answers(const MethodFacts& method) {
  std::vector<Mutant> mutants;
  if (!method.on_problem && !method.on_separable) return mutants;
  if (method.info.order == 0) return mutants;
  const CodeChecks checks(method);
  for (const Named& named : faults_for(method)) {
    Mutant mutant{method.id(), named.kind, named.change};
    const Code code = with_fault(method, named.fault);
    mutant.caught_by = checks.first_failure(code);
    // No change: the method does not use the altered answer.
    if (!mutant.caught() && difference_between(code, method) <= 1e-15)
      mutant.equivalent = "no result depends on it";
    else if (!mutant.caught() && named.fault.euler_start && method.info.order <= 2)
      mutant.equivalent = "one Euler step leaves an error of order 2, which the method has anyway";
    mutants.push_back(std::move(mutant));
  }
  return mutants;
}

}  // namespace odeum::proof
