// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/printer.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::formula {
namespace {

/// `name` fills f with the roots.
void print_all(Printer& out, const char* name, const std::vector<Id>& roots, const Type& type) {
  print_values(out, values_function(name, type), roots, in_order(roots.size()), type);
}

void print_acceleration(Printer& out, const Problem& problem) {
  const std::size_t half = problem.states.size() / 2;
  const std::vector<Id> roots(problem.equations.begin() + static_cast<std::ptrdiff_t>(half),
                              problem.equations.end());
  const Function function{.name = "acceleration",
                          .arguments =
                              "const void* problem, double t, const double* q, const double* v, "
                              "double* __restrict a",
                          .passed = "problem, t, q, v, a",
                          .target = "a",
                          .first = "q",
                          .second = "v",
                          .split = static_cast<std::uint32_t>(half)};
  print_values(out, function, roots, in_order(half), in_double);
}

/// One coefficient, number k >= 1, of a step of the plan; see Series::advance.
void print_coefficient(Printer& out, const SeriesPlan& plan, const SeriesPlan::Step& step) {
  const Id id = step.id;
  const auto array = [&](std::uint32_t at) { return fmt::format("s{}", plan.steps[at].id); };
  const auto constant = [&](std::uint32_t at) { return out.name(plan.steps[at].id, in_double); };
  const auto is_constant = [&](std::uint32_t at) { return plan.steps[at].op == Op::constant; };
  switch (step.op) {
    case Op::constant:
    case Op::state:
      return;
    case Op::time:
      return out.line("    s{}[k] = k == 1;", id);
    case Op::add:
    case Op::subtract: {
      // A constant has no coefficients beyond the first.
      const std::string a = is_constant(step.a) ? "0" : array(step.a) + "[k]";
      const std::string b = is_constant(step.b) ? "0" : array(step.b) + "[k]";
      return out.line("    s{}[k] = {} {} {};", id, a, step.op == Op::add ? '+' : '-', b);
    }
    case Op::negate:
      return out.line("    s{}[k] = -{}[k];", id, array(step.a));
    case Op::multiply:
      if (is_constant(step.a))
        return out.line("    s{}[k] = {} * {}[k];", id, constant(step.a), array(step.b));
      if (is_constant(step.b))
        return out.line("    s{}[k] = {}[k] * {};", id, array(step.a), constant(step.b));
      if (step.a == step.b)
        return out.line("    s{0}[k] = 2 * {1}[0] * {1}[k] + square({1}, k);", id, array(step.a));
      return out.line("    s{}[k] = sum({}, {}, 0, k);", id, array(step.a), array(step.b));
    case Op::sqrt:
      return out.line("    s{0}[k] = root({1}, s{0}, k);", id, array(step.a));
    case Op::divide:
      if (is_constant(step.b))
        return out.line("    s{}[k] = {}[k] / {};", id, array(step.a), constant(step.b));
      return out.line("    s{0}[k] = ({1} - sum({2}, s{0}, 1, k)) / {2}[0];", id,
                      is_constant(step.a) ? "0" : array(step.a) + "[k]", array(step.b));
    default: {
      if (SeriesPlan::has_power_rule(step))
        return out.line("    s{0}[k] = power({1}, s{0}, {2}, k);", id, array(step.a),
                        constant(step.b));
      std::string sums;
      for (const SeriesPlan::Part& part : step.parts)
        sums += fmt::format(
            "{}{}", sums.empty() ? "" : " + ",
            is_constant(part.partial)
                ? fmt::format("k * {}[k] * {}", array(part.argument), constant(part.partial))
                : fmt::format("slopes({}, {}, k)", array(part.argument), array(part.partial)));
      return out.line("    s{}[k] = ({}) / k;", id, sums.empty() ? "0" : sums);
    }
  }
}

}  // namespace

void print_jacobian(Printer& out, Function function, const std::vector<std::vector<Entry>>& rows,
                    const Type& type) {
  const std::size_t n = rows.size();
  std::vector<std::uint32_t> places;
  for (std::size_t row = 0; row < n; ++row)
    for (const Entry& entry : rows[row])
      places.push_back(static_cast<std::uint32_t>(row * n + entry.by));
  function.cleared = places.size() < n * n ? n * n : 0;
  print_values(out, function, jacobian_roots(rows), places, type);
}

void print_series(Printer& out, const std::string& head, const Problem& problem,
                  const SeriesPlan& plan) {
  const std::size_t n = problem.states.size();
  out.text +=
      "static inline double sum(const double* a, const double* b, int from, int k) {\n"
      "  double s = 0;\n  for (int j = from; j <= k; ++j) s += a[j] * b[k - j];\n  return s;\n}\n"
      "static inline double square(const double* a, int k) {\n"
      "  double s = 0;\n  for (int j = 1; 2 * j < k; ++j) s += a[j] * a[k - j];\n"
      "  return 2 * s + (k % 2 == 0 ? a[k / 2] * a[k / 2] : 0);\n}\n"
      "static inline double slopes(const double* a, const double* b, int k) {\n"
      "  double s = 0;\n  for (int j = 1; j <= k; ++j) s += j * a[j] * b[k - j];\n  return s;\n}\n"
      "static inline double root(const double* a, const double* w, int k) {\n"
      "  const double rest = a[k] - square(w, k);\n"
      "  return w[0] == 0 && rest == 0 ? 0 : rest / (2 * w[0]);\n}\n"
      "static inline double power(const double* a, const double* w, double b, int k) {\n"
      "  int first = 0;\n  while (first <= k && a[first] == 0) ++first;\n"
      "  if (first > 0 && w[0] == 0 && (first > k || k < b)) return 0;\n  double s = 0;\n"
      "  for (int j = 1; j <= k; ++j) s += (b * j - (k - j)) * a[j] * w[k - j];\n"
      "  return s / (k * a[0]);\n}\n";
  out.line("{}\n  (void)t; (void)y;", head);
  for (const auto& step : plan.steps)
    if (step.op != Op::constant) out.line("  double s{}[64];", step.id);
  out.line("  for (int i = 0; i < {}; ++i) c[i] = y[i];", n);
  for (const auto& step : plan.steps) {
    const Node& node = problem.graph[step.id];
    const auto first = [&](std::size_t k) {
      if (node.of[k] == no_node) return std::string();
      return problem.graph.is_constant(node.of[k]) ? out.name(node.of[k], in_double)
                                                   : fmt::format("s{}[0]", node.of[k]);
    };
    if (step.op == Op::constant) continue;
    out.line("  s{}[0] = {};", step.id,
             step.op == Op::time    ? "t"
             : step.op == Op::state ? fmt::format("y[{}]", step.a)
                                    : out.operation(step.op, first(0), first(1), "", in_double));
  }
  out.line("  for (int k = 0; k < order; ++k) {{");
  out.line("    if (k > 0) {{");
  for (const auto& step : plan.steps)
    if (step.op == Op::state) out.line("    s{}[k] = c[k * {} + {}];", step.id, n, step.a);
  for (const auto& step : plan.steps) print_coefficient(out, plan, step);
  out.line("    }}");
  for (std::size_t i = 0; i < n; ++i) {
    const auto& root = plan.steps[plan.roots[i]];
    if (root.op == Op::constant)
      out.line("    c[(k + 1) * {} + {}] = k == 0 ? {} : 0;", n, i, out.name(root.id, in_double));
    else
      out.line("    c[(k + 1) * {} + {}] = s{}[k] / (k + 1);", n, i, root.id);
  }
  out.line("  }}\n}}");
}

std::string print_c(const Problem& problem, const Analysis& analysis) {
  Printer out(problem.graph);
  out.owner = "(*(const double* const*)problem)";  // see TextOde::Handle
  out.numbered = true;
  out.line("/* y' = f(t, y) with {} states, printed from a graph of operations */",
           problem.states.size());
  print_all(out, "rhs", problem.equations, in_double);
  constexpr std::size_t few_states = 64;
  if (problem.states.size() <= few_states)
    print_jacobian(out, values_function("jacobian", in_double), analysis.jacobian, in_double);
  const std::vector<Id> entries = jacobian_roots(analysis);
  print_all(out, "jacobian_entries", entries, in_double);
  if (!analysis.time_derivative.empty())
    print_all(out, "time_derivative", analysis.time_derivative, in_double);
  if (analysis.structure.second_order) print_acceleration(out, problem);
  if (!problem.implicit_part.empty()) {
    print_all(out, "explicit_part", problem.explicit_part, in_double);
    print_all(out, "implicit_part", problem.implicit_part, in_double);
    if (problem.states.size() <= few_states)
      print_jacobian(out, values_function("implicit_jacobian", in_double),
                     analysis.implicit_jacobian, in_double);
  }
  // One function of all steps: the compiler takes minutes for more.
  constexpr std::size_t most_compiled = 600;
  if (analysis.series && analysis.series->steps.size() <= most_compiled)
    print_series(
        out,
        "void taylor(const void* problem, double t, const double* y, int order, double* c) {\n"
        "  (void)problem;",
        problem, *analysis.series);
  print_all(out, "rhs_extended", problem.equations, in_long_double);
  print_all(out, "entries_extended", entries, in_long_double);
  return std::move(out.text);
}

}  // namespace odeum::formula
