// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "odeum/brought/candidate.hpp"
#include "odeum/proof/facts.hpp"

namespace odeum::brought {
namespace {

using Tableau = DynamicTableau<double>;

std::string number(double value) { return fmt::format("{:.4g}", value); }

/// The mistakes of one explicit tableau.
class TableauMistakes {
 public:
  TableauMistakes(std::string method, Tableau sound, std::vector<Candidate>& candidates)
      : method_(std::move(method)), sound_(std::move(sound)), candidates_(candidates) {
    sound_.b_hat.clear();
  }

  void add_all() {
    add_times();
    for (std::size_t i = 1; i < sound_.stages; ++i) add_of_stage(i);
    add_in_place();
    add_weights();
    add_by_component();
  }

 private:
  void add(Tableau wrong, std::string mistake) {
    candidates_.push_back(of_tableau(method_, std::move(mistake), std::move(wrong)));
  }

  void add_times() {
    if (std::ranges::all_of(sound_.c, [](double c) { return c == 0; })) return;
    Tableau wrong = sound_;
    std::ranges::fill(wrong.c, 0.0);
    add(wrong, "all slopes are taken at the time at which the step begins");
    wrong = sound_;
    std::ranges::fill(wrong.c, 1.0);
    add(wrong, "all slopes are taken at the time at which the step ends");
  }

  void add_of_stage(std::size_t i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double a = sound_.at(i, j);
      if (a == 0) continue;
      for (std::size_t other = 0; other < i; ++other) {
        if (other == j) continue;
        Tableau wrong = sound_;
        wrong.at(i, j) = 0;
        wrong.at(i, other) += a;
        add(wrong,
            fmt::format("k{} is computed from k{} in place of k{}", i + 1, other + 1, j + 1));
      }
      for (const double factor : {0.5, 2.0, -1.0, 0.0}) {
        Tableau wrong = sound_;
        wrong.at(i, j) = factor * a;
        const std::string text =
            factor == 0 ? fmt::format("k{} is computed without k{}", i + 1, j + 1)
                        : fmt::format("k{} is computed with {} h k{} in place of {} h k{}", i + 1,
                                      number(factor * a), j + 1, number(a), j + 1);
        add(wrong, text);
        wrong.c[i] = wrong.row_sum(i);
        if (wrong.c[i] != sound_.c[i])
          add(wrong, text + fmt::format(", and at {} h", number(wrong.c[i])));
      }
    }
    for (const double c : {0.0, 0.5, 1.0}) {
      if (c == sound_.c[i]) continue;
      Tableau wrong = sound_;
      wrong.c[i] = c;
      add(wrong, fmt::format("k{} is taken at the time t + {} h in place of t + {} h", i + 1,
                             number(c), number(sound_.c[i])));
    }
  }

  // An array that is changed where a copy was meant: each stage adds to the stage before it.
  void add_in_place() {
    if (sound_.stages < 2) return;
    const std::size_t s = sound_.stages;
    Tableau wrong = sound_;
    for (std::size_t i = 2; i < s; ++i)
      for (std::size_t j = 0; j < s; ++j) wrong.at(i, j) += wrong.at(i - 1, j);
    add(wrong, "each stage adds to the stage before it, not to the state at the step's begin");
    for (std::size_t j = 0; j < s; ++j) wrong.b[j] += wrong.at(s - 1, j);
    add(wrong, "each stage changes the state that the step begins with");
  }

  void add_weights() {
    const std::size_t s = sound_.stages;
    for (std::size_t i = 0; i < s; ++i) {
      for (const double factor : {0.5, 2.0, -1.0, 0.0}) {
        Tableau wrong = sound_;
        wrong.b[i] *= factor;
        if (sound_.b[i] != 0)
          add(wrong, fmt::format("the weight of k{} is {} in place of {}", i + 1,
                                 number(wrong.b[i]), number(sound_.b[i])));
      }
      for (std::size_t j = i + 1; j < s; ++j) {
        Tableau wrong = sound_;
        std::swap(wrong.b[i], wrong.b[j]);
        if (wrong.b != sound_.b)
          add(wrong, fmt::format("the weights of k{} and k{} are exchanged", i + 1, j + 1));
      }
      Tableau alone = sound_;
      std::ranges::fill(alone.b, 0.0);
      alone.b[i] = 1;
      if (alone.b != sound_.b) add(alone, fmt::format("the step takes k{} alone", i + 1));
      add_all_weights(sound_.b[i]);
    }
    add_all_weights(1.0 / static_cast<double>(s));
    if (s == 4) {
      Tableau wrong = sound_;
      wrong.b = {1. / 8, 3. / 8, 3. / 8, 1. / 8};
      if (wrong.b != sound_.b) add(wrong, "the weights are those of the 3/8 rule");
    }
    for (const double sum : {0.5, 2.0, 0.75, 1.2, 1.5, 6.0, 3.0, 0.6}) {
      Tableau wrong = sound_;
      for (double& b : wrong.b) b *= sum;
      add(wrong, fmt::format("the weights add up to {} in place of 1", number(sum)));
    }
  }
  void add_all_weights(double weight) {
    Tableau wrong = sound_;
    std::ranges::fill(wrong.b, weight);
    if (weight != 0 && wrong.b != sound_.b)
      add(wrong, fmt::format("every slope has the weight {}", number(weight)));
  }

  /// Steps of one component after the other, in the order of the state or against it; the others
  /// are held, or go through the stages with it, as they are by then.
  void add_by_component() {
    struct Way {
      bool forward, held, in_place;
      const char* text;
    };
    static constexpr Way ways[] = {
        {true, false, true,
         "each component in turn, from the first, with the new values of those before it"},
        {false, false, true,
         "each component in turn, from the last, with the new values of those before it"},
        {true, true, false,
         "each component on its own, while the others keep their values of the step's begin"},
        {true, true, true,
         "each component in turn, from the first, while the others keep their present values"},
        {false, true, true,
         "each component in turn, from the last, while the others keep their present values"}};
    for (const Way& way : ways) {
      if (sound_.stages == 1 && way.held) continue;  // the same as above, or the method itself
      candidates_.push_back(
          one_step(method_, way.text, sound_.order,
                   [sound = sound_, way](const Problem& problem, double t, double h,
                                         std::vector<double>& y) {
                     const std::size_t n = problem.size();
                     const std::vector<double> old = y;
                     for (std::size_t k = 0; k < n; ++k) {
                       const std::size_t i = way.forward ? k : n - 1 - k;
                       FunctionProblem alone = problem.first_order();
                       if (way.held)
                         alone.f = [&problem, i](double time, const double* state, double* f) {
                           problem.first_order().rhs(time, state, f);
                           for (std::size_t j = 0; j < problem.size(); ++j)
                             if (j != i) f[j] = 0;
                         };
                       std::vector<double> next = way.in_place ? y : old;
                       if (TableauInterpreter(sound, alone).step(t, h, next) != Status::ok)
                         return false;
                       y[i] = next[i];
                     }
                     return true;
                   }));
    }
  }

  std::string method_;
  Tableau sound_;
  std::vector<Candidate>& candidates_;
};

/// q and v of a problem of second order, and the acceleration there.
struct Motion {
  const FunctionMechanics<true>& mechanics;
  std::vector<double>& y;
  std::size_t n = y.size() / 2;
  double* q = y.data();
  double* v = y.data() + n;

  std::vector<double> acceleration(double t) const {
    std::vector<double> a(n);
    mechanics.acceleration(t, q, v, a.data());
    return a;
  }
  void move(double h) const {
    for (std::size_t i = 0; i < n; ++i) q[i] += h * v[i];
  }
  static void add(double h, const std::vector<double>& a, double* to) {
    for (std::size_t i = 0; i < a.size(); ++i) to[i] += h * a[i];
  }
};

void add_of_verlet(const std::string& method, std::vector<Candidate>& candidates) {
  const auto add_step = [&](const char* mistake, auto step) {
    candidates.push_back(
        one_step(method, mistake, 2,
                 [step](const Problem& problem, double t, double h, std::vector<double>& y) {
                   if (!problem.second_order()) return false;
                   Motion motion{*problem.second_order(), y};
                   step(motion, t, h);
                   return true;
                 }));
  };
  // The factors of h^2 a in the positions, and of the old and the new acceleration in the
  // velocities.
  struct Terms {
    double square, before, after;
    const char* mistake;
  };
  static constexpr Terms terms[] = {
      {0.5, 1, 0, "velocities use the old acceleration alone"},
      {0.5, 0, 1, "velocities use the new acceleration alone"},
      {0, 0.5, 0.5, "positions leave out h^2 a / 2"},
      {1, 0.5, 0.5, "positions add h^2 a in place of h^2 a / 2"},
      {0.5, 1, 1, "velocities add both accelerations in place of their mean"},
      {0.5, 0.5, 0, "velocities add half of the old acceleration alone"},
      {0, 0, 0.5, "velocities add half of the new acceleration alone"},
      {0.5, 0, 0.5, "velocities add half of the new acceleration, and nothing of the old one"}};
  for (const Terms& each : terms)
    add_step(each.mistake, [each](Motion& motion, double t, double h) {
      const std::vector<double> a = motion.acceleration(t);
      motion.move(h);
      Motion::add(each.square * h * h, a, motion.q);
      const std::vector<double> next = motion.acceleration(t + h);
      Motion::add(h * each.before, a, motion.v);
      Motion::add(h * each.after, next, motion.v);
    });
  add_step(
      "positions use the mean of the old and the new velocity, and velocities the old acceleration "
      "after that",
      [](Motion& motion, double t, double h) {
        const std::vector<double> a = motion.acceleration(t);
        Motion::add(h, a, motion.v);
        motion.move(h);
        Motion::add(-h * h / 2, a, motion.q);
      });
  add_step("the velocity is kicked by whole steps before and after the positions move",
           [](Motion& motion, double t, double h) {
             Motion::add(h, motion.acceleration(t), motion.v);
             motion.move(h);
             Motion::add(h, motion.acceleration(t + h), motion.v);
           });
}

bool is_taught(const proof::MethodFacts& facts) {
  const std::string id = facts.id();
  return id == "explicit_euler" || id == "heun" || id == "midpoint" || id == "rk4";
}

}  // namespace

std::vector<Candidate> known_mistakes(const std::string& method) {
  constexpr std::size_t most_stages = 7;
  std::vector<Candidate> candidates;
  for (const proof::MethodFacts& facts : proof::all_method_facts())
    if (facts.tableau && facts.tableau->is_explicit() && facts.tableau->stages <= most_stages &&
        (method.empty() ? is_taught(facts) : facts.id() == method))
      TableauMistakes(facts.id(), *facts.tableau, candidates).add_all();
  for (const char* verlet : {"velocity_verlet", "leapfrog", "stormer_verlet"})
    if (method == verlet || (method.empty() && std::string(verlet) == "velocity_verlet"))
      add_of_verlet(verlet, candidates);
  if (method.empty() || method == "adams_bashforth2") {
    const auto add = [&](const char* mistake, std::vector<double> beta) {
      candidates.push_back(multistep("adams_bashforth2", mistake, 2, {0, -1, 1}, std::move(beta)));
    };
    add("the weights 3/2 and -1/2 of the slopes are exchanged", {1.5, -0.5, 0});
    add("the older slope is added, where half of it is subtracted", {0.5, 1.5, 0});
    add("both slopes have the weight 1/2", {0.5, 0.5, 0});
  }
  return candidates;
}

}  // namespace odeum::brought
