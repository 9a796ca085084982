// SPDX-License-Identifier: BSD-3-Clause
#include "support/truth_problems.hpp"

#include <fmt/format.h>

namespace odeum::tests {
namespace {

constexpr double good = 1e-13;   // what smooth problems without chaos are to reach
constexpr double stiff = 1e-12;  // what implicit methods reach where explicit ones take too long

TruthProblem problem(const std::string& reference, std::size_t states, const std::string& body,
                     const std::string& stops, double floor = good) {
  std::string name = reference;
  for (char& c : name)
    if (c == '-') c = '_';
  const std::string end = stops.substr(stops.rfind(' ') + 1);
  return {name, reference, body + "\ntime: {end: " + end + ", stops: [" + stops + "]}\n", states,
          floor};
}

std::string pleiades() {
  const char* const x[] = {"3", "3", "-1", "-3", "2", "-2", "2"};
  const char* const y[] = {"3", "-3", "2", "0", "0", "-4", "4"};
  const char* const vx[] = {"0", "0", "0", "0", "0", "1.75", "-1.5"};
  const char* const vy[] = {"0", "0", "0", "-1.25", "1", "0", "0"};
  std::string definitions = "definitions:\n", states[4], equations[4];
  for (int i = 1; i <= 7; ++i)
    for (int j = i + 1; j <= 7; ++j) {
      definitions += fmt::format("  r{0}{1}: (x{0} - x{1})^2 + (y{0} - y{1})^2\n", i, j);
      definitions += fmt::format("  p{0}{1}: 1/(r{0}{1}*sqrt(r{0}{1}))\n", i, j);
    }
  for (int i = 1; i <= 7; ++i) {
    states[0] += fmt::format("  x{}: {}\n", i, x[i - 1]);
    states[1] += fmt::format("  y{}: {}\n", i, y[i - 1]);
    states[2] += fmt::format("  vx{}: {}\n", i, vx[i - 1]);
    states[3] += fmt::format("  vy{}: {}\n", i, vy[i - 1]);
    equations[0] += fmt::format("  x{0}: vx{0}\n", i);
    equations[1] += fmt::format("  y{0}: vy{0}\n", i);
    std::string ax = "0", ay = "0";
    for (int j = 1; j <= 7; ++j) {
      if (j == i) continue;
      const std::string pull = fmt::format("p{}{}", std::min(i, j), std::max(i, j));
      ax += fmt::format(" + {0}*{1}*(x{0} - x{2})", j, pull, i);
      ay += fmt::format(" + {0}*{1}*(y{0} - y{2})", j, pull, i);
    }
    equations[2] += fmt::format("  vx{}: {}\n", i, ax);
    equations[3] += fmt::format("  vy{}: {}\n", i, ay);
  }
  return definitions + "states:\n" + states[0] + states[1] + states[2] + states[3] +
         "equations:\n" + equations[0] + equations[1] + equations[2] + equations[3];
}

std::string oscillator(const char* c) {
  return fmt::format("states: {{x: 1, v: 0.5}}\nequations: {{x: v, v: -x - {}*v}}", c);
}

std::string chain(const char* alpha, const char* beta) {
  return fmt::format(
      "parameters: {{a: {}, b: {}}}\nstates: {{q[1..32]: sin(pi*i/33), p[1..32]: 0}}\n"
      "boundaries: {{q[0]: 0, q[33]: 0}}\nequations:\n  q[1..32]: p[i]\n"
      "  p[1..32]: (q[i+1] - q[i]) + a*(q[i+1] - q[i])^2 + b*(q[i+1] - q[i])^3"
      " - (q[i] - q[i-1]) - a*(q[i] - q[i-1])^2 - b*(q[i] - q[i-1])^3",
      alpha, beta);
}

std::string elastic_pendulum(const char* stiffness) {
  return fmt::format(
      "parameters: {{k: {}, g: 9.81}}\nstates: {{r: 1, th: 1, vr: 0, w: 0}}\nequations:\n  r: vr\n"
      "  th: w\n  vr: r*w^2 + g*cos(th) - k*(r - 1)\n  w: -(g*sin(th) + 2*vr*w)/r",
      stiffness);
}

std::string prothero_robinson(const char* lambda, int start) {
  return fmt::format("states: {{y: {}}}\nequations: {{y: -{}*(y - cos(t)) - sin(t)}}", start,
                     lambda);
}

void add_mechanics(std::vector<TruthProblem>& all) {
  const std::string kepler =
      "parameters: {{e0: {}}}\ndefinitions: {{r2: x^2 + y^2}}\n"
      "states: {{x: 1 - e0, y: 0, u: 0, v: sqrt((1 + e0)/(1 - e0))}}\n"
      "equations: {{x: u, y: v, u: -x/(r2*sqrt(r2)), v: -y/r2^1.5}}";
  all.push_back(
      problem("kepler_e06", 4, fmt::format(fmt::runtime(kepler), "0.6"), "0.5, 1, 3, 10"));
  all.push_back(
      problem("kepler_e09", 4, fmt::format(fmt::runtime(kepler), "0.9"), "0.5, 1, 3, 10"));
  all.push_back(problem("pleiades", 28, pleiades(), "0.5, 1, 1.5, 2, 2.5, 3"));
  // Close passages of the moon amplify rounding by 1e9.
  all.push_back(problem("arenstorf", 4,
                        "parameters: {m: 0.012277471, n: 1 - m}\ndefinitions:\n"
                        "  d1: ((x + m)^2 + y^2)^1.5\n  d2: ((x - n)^2 + y^2)^1.5\n"
                        "states: {x: 0.994, y: 0, u: 0, v: -2.00158510637908252240537862224}\n"
                        "equations:\n  x: u\n  y: v\n  u: x + 2*v - n*(x + m)/d1 - m*(x - n)/d2\n"
                        "  v: y - 2*u - n*y/d1 - m*y/d2",
                        "1, 5, 10, 15, 17", 1e-9));
  all.push_back(problem("henon_heiles_regular", 4,
                        "states: {x: 0.1, y: 0, u: 0, v: 0.4}\n"
                        "equations: {x: u, y: v, u: -x - 2*x*y, v: -y - x^2 + y^2}",
                        "1, 10, 50, 100"));
  all.push_back(problem("double_pendulum_mild", 4,
                        "parameters: {g: 9.81}\ndefinitions:\n  c: cos(a - b)\n  s: sin(a - b)\n"
                        "  p: -(v^2*s + 2*g*sin(a))\n  q: u^2*s - g*sin(b)\n"
                        "states: {a: 0.5, b: -0.25, u: 0, v: 0}\nequations:\n  a: u\n  b: v\n"
                        "  u: (p - c*q)/(2 - c^2)\n  v: (2*q - c*p)/(2 - c^2)",
                        "1, 2, 5, 10"));
  for (const char* angle : {"1", "3"})
    all.push_back(
        problem(*angle == '1' ? "pendulum_small" : "pendulum_large", 2,
                fmt::format("states: {{th: {}, w: 0}}\nequations: {{th: w, w: -sin(th)}}", angle),
                "1, 5, 10, 50, 100"));
  all.push_back(problem("duffing_free", 2,
                        "states: {x: 1, v: 0}\nequations: {x: v, v: -x - 0.5*x^3}",
                        "1, 5, 10, 50, 100"));
  all.push_back(problem("fput_alpha", 64, chain("0.25", "0"), "1, 10, 50, 100"));
  all.push_back(problem("fput_beta", 64, chain("0", "1"), "1, 10, 50, 100"));
  all.push_back(problem("elastic_pendulum_k1e4", 4, elastic_pendulum("1e4"), "0.1, 1, 2, 5, 10"));
  all.push_back(problem("elastic_pendulum_k1e6", 4, elastic_pendulum("1e6"), "0.1, 1, 2, 5"));
  all.push_back(problem("rigid_body_hlw", 3,
                        "states: {y1: cos(1.1), y2: 0, y3: sin(1.1)}\nequations: {y1: 0.5*y2*y3, "
                        "y2: -y3*y1, y3: 0.5*y1*y2}",
                        "1, 5, 10, 50, 100"));
  all.push_back(problem("rigid_body_detestB5", 3,
                        "states: {y1: 0, y2: 1, y3: 1}\n"
                        "equations: {y1: y2*y3, y2: -y1*y3, y3: -0.51*y1*y2}",
                        "1, 5, 10, 12, 20, 100"));
}

void add_linear(std::vector<TruthProblem>& all) {
  const char* const times = "0.5, 1, 5, 10, 20";
  all.push_back(problem("osc_undamped", 2, oscillator("0"), times));
  all.push_back(problem("osc_under", 2, oscillator("0.2"), times));
  all.push_back(problem("osc_critical", 2, oscillator("2"), times));
  all.push_back(problem("osc_over", 2, oscillator("4"), times));
  all.push_back(problem("osc_nearcrit_above_1e-6", 2, oscillator("2.000002"), times));
  all.push_back(problem("stiff_chain2_k1e4", 4,
                        "states: {x: 1, y: 1.001, u: 0, v: 0}\nequations: {x: u, y: v, "
                        "u: -x + 1e4*(y - x), v: -1e4*(y - x)}",
                        "0.1, 1, 5, 10"));
  all.push_back(problem("freefall_drag", 2,
                        "states: {y: 0, v: 0}\nequations: {y: v, v: 9.81 - 0.01*v^2}",
                        "1, 2, 5, 10, 20"));
  all.push_back(problem("projectile", 4,
                        "states: {x: 0, y: 0, u: 30, v: 40}\n"
                        "equations: {x: u, y: v, u: 0, v: -9.81}",
                        "1, 2, 4, 6, 8"));
  all.push_back(
      problem("charged_particle", 6,
              "states: {x: 0, y: 0, z: 0, u: 1, v: 0.5, w: 0.25}\nequations: {x: u, y: v, "
              "z: w, u: 2*v, v: -2*u, w: 0}",
              "1, 5, 10, 100"));
  all.push_back(problem("rc_sine", 1, "states: {V: 0}\nequations: {V: (5*sin(100*pi*t) - V)/0.001}",
                        "0.001, 0.005, 0.02, 0.1"));
  const char* const layer = "0.001, 0.01, 0.1, 1, 10";
  all.push_back(problem("prothero_robinson_1e3_smooth", 1, prothero_robinson("1e3", 1), layer));
  all.push_back(problem("prothero_robinson_1e3_layer", 1, prothero_robinson("1e3", 2), layer));
  all.push_back(problem("prothero_robinson_1e6_smooth", 1, prothero_robinson("1e6", 1), layer));
}

void add_reactions(std::vector<TruthProblem>& all) {
  all.push_back(
      problem("hires", 8,
              "states: {a: 1, b: 0, c: 0, d: 0, f: 0, g: 0, h: 0, k: 0.0057}\nequations:\n"
              "  a: -1.71*a + 0.43*b + 8.32*c + 0.0007\n  b: 1.71*a - 8.75*b\n"
              "  c: -10.03*c + 0.43*d + 0.035*f\n  d: 8.32*b + 1.71*c - 1.12*d\n"
              "  f: -1.745*f + 0.43*g + 0.43*h\n"
              "  g: -280*g*k + 0.69*d + 1.71*f - 0.43*g + 0.69*h\n"
              "  h: 280*g*k - 1.81*h\n  k: -280*g*k + 1.81*h",
              "1, 5, 10, 50, 100, 200, 300, 321.8122"));
  const std::string robertson =
      "states: {a: 1, b: 0, c: 0}\nequations:\n  a: -0.04*a + 1e4*b*c\n"
      "  b: 0.04*a - 1e4*b*c - 3e7*b^2\n  c: 3e7*b^2";
  all.push_back(problem("robertson", 3, robertson, "0.4, 1, 4, 10, 40"));
  all.push_back(problem("robertson", 3, robertson, "0.4, 40, 4e3, 4e5, 4e7, 4e9, 4e11"));
  all.back().name = "robertson_to_equilibrium";
  all.push_back(problem("oregonator", 3,
                        "parameters: {s: 77.27, q: 8.375e-6, w: 0.161}\n"
                        "states: {a: 1, b: 2, c: 3}\nequations: {a: s*(b + a*(1 - q*a - b)), "
                        "b: (c - (1 + a)*b)/s, c: w*(a - c)}",
                        "30, 60, 180, 300, 330, 360", stiff));
  const std::string oscillator =
      "parameters: {{mu: {}, eps: {}}}\nstates: {{x: 2, v: 0}}\n"
      "equations: {{x: v, v: (mu*(1 - x^2)*v - x)/eps}}";
  all.push_back(
      problem("vdp_mu1", 2, fmt::format(fmt::runtime(oscillator), "1", "1"), "1, 5, 10, 20, 50"));
  all.push_back(problem("vdp_mu1000", 2, fmt::format(fmt::runtime(oscillator), "1000", "1"),
                        "500, 800, 1000, 1500, 2000", stiff));
  // v, of which errors are a part, comes to 1e6 in each jump. A tolerance at which both families
  // agree to 9e-12 takes three times the seconds that a truth may take.
  all.push_back(problem("vdp_eps1e-6", 2, fmt::format(fmt::runtime(oscillator), "1", "1e-6"),
                        "0.5, 1, 2", 1e-8));
  all.push_back(problem("brusselator2", 2,
                        "states: {x: 1.5, y: 3}\nequations: {x: 1 + x^2*y - 4*x, y: 3*x - x^2*y}",
                        "1, 5, 10, 15, 20"));
  all.push_back(problem("lotka_volterra", 2,
                        "states: {x: 1, y: 1}\nequations: {x: (1.5 - y)*x, y: (x - 3)*y}",
                        "1, 2, 5, 10, 100"));
  all.push_back(problem("lorenz_kehlet_logg", 3,
                        "states: {x: 1, y: 0, z: 0}\n"
                        "equations: {x: 10*(y - x), y: x*(28 - z) - y, z: x*y - 8/3*z}",
                        "10, 20", 0));
}

}  // namespace

std::vector<TruthProblem> truth_problems() {
  std::vector<TruthProblem> all;
  add_mechanics(all);
  add_linear(all);
  add_reactions(all);
  return all;
}

}  // namespace odeum::tests
