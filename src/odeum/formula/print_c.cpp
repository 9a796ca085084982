// SPDX-License-Identifier: BSD-3-Clause
// long: one printer of all functions of a problem
#include "odeum/formula/print_c.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace odeum::formula {
namespace {

/// A number type of C, the suffix of its functions and of its constants.
struct Type {
  const char* name;
  const char* function;
  const char* constant;
};
constexpr Type in_double{"double", "", ""}, in_long_double{"long double", "l", "L"};

std::string constant_text(long double value, const Type& type) {
  const std::string text = *type.constant ? fmt::format("{:a}L", value)
                                          : fmt::format("{:a}", static_cast<double>(value));
  return std::signbit(value) ? "(" + text + ")" : text;
}

class Printer {
 public:
  explicit Printer(const Graph& graph) : graph_(graph) {}
  std::string text;

  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    text += '\n';
  }

  /// What stands for a node in an expression.
  std::string name(Id id, const Type& type) const {
    const Node& node = graph_[id];
    return node.op == Op::constant ? constant_text(node.value, type) : fmt::format("v{}", id);
  }
  std::string operation(Op op, const std::string& a, const std::string& b, const std::string& c,
                        const Type& type) const {
    const char* const l = type.function;
    switch (op) {
      case Op::add:
        return fmt::format("{} + {}", a, b);
      case Op::subtract:
        return fmt::format("{} - {}", a, b);
      case Op::multiply:
        return fmt::format("{} * {}", a, b);
      case Op::divide:
        return fmt::format("{} / {}", a, b);
      case Op::negate:
        return fmt::format("-{}", a);
      case Op::less:
        return fmt::format("{} < {}", a, b);
      case Op::less_equal:
        return fmt::format("{} <= {}", a, b);
      case Op::equal:
        return fmt::format("{} == {}", a, b);
      case Op::choose:
        return fmt::format("{} != 0 ? {} : {}", a, b, c);
      case Op::min:
        return fmt::format("{1} < {0} ? {1} : {0}", a, b);
      case Op::max:
        return fmt::format("{0} < {1} ? {1} : {0}", a, b);
      case Op::sign:
        return fmt::format("({0} > 0) - ({0} < 0) + 0 * {0}", a);
      case Op::power:
        return fmt::format("__builtin_pow{}({}, {})", l, a, b);
      case Op::atan2:
        return fmt::format("__builtin_atan2{}({}, {})", l, a, b);
      default:
        return fmt::format("__builtin_{}{}({})", function_name(op), l, a);
    }
  }
  std::string operation(const Node& node, const Type& type) const {
    const auto argument = [&](std::size_t k) {
      return node.of[k] == no_node ? std::string() : name(node.of[k], type);
    };
    return operation(node.op, argument(0), argument(1), argument(2), type);
  }

  /// Computes the nodes on which roots depend; `state` prints state number k.
  template <class StateText>
  void nodes(const std::vector<Id>& roots, const Type& type, StateText&& state) {
    for (const Id id : graph_.needed(roots)) {
      const Node& node = graph_[id];
      if (node.op == Op::constant) continue;
      const std::string value = node.op == Op::state  ? state(node.index)
                                : node.op == Op::time ? "t"
                                                      : operation(node, type);
      line("  const {} v{} = {};", type.name, id, value);
    }
  }
  void nodes(const std::vector<Id>& roots, const Type& type) {
    nodes(roots, type, [](std::uint32_t k) { return fmt::format("y[{}]", k); });
  }

 private:
  static const char* function_name(Op op) {
    switch (op) {
      case Op::sin:
        return "sin";
      case Op::cos:
        return "cos";
      case Op::tan:
        return "tan";
      case Op::asin:
        return "asin";
      case Op::acos:
        return "acos";
      case Op::atan:
        return "atan";
      case Op::sinh:
        return "sinh";
      case Op::cosh:
        return "cosh";
      case Op::tanh:
        return "tanh";
      case Op::exp:
        return "exp";
      case Op::log:
        return "log";
      case Op::log10:
        return "log10";
      case Op::sqrt:
        return "sqrt";
      default:
        return "fabs";
    }
  }

  const Graph& graph_;
};

constexpr const char* unused = "  (void)problem; (void)t; (void)y;";

/// `name` fills f with the roots; in parts, since the compiler's time grows faster than the length
/// of a function. What two parts need is computed in both.
void print_values(Printer& out, const char* name, const std::vector<Id>& roots, const Type& type) {
  constexpr std::size_t most_in_part = 256;
  const auto head = [&](const std::string& kind, const std::string& of) {
    out.line("{}void {}(const void* problem, {} t, const {}* y, {}* f) {{", kind, of, type.name,
             type.name, type.name);
    out.line("{}", unused);
  };
  const std::size_t parts =
      std::max<std::size_t>((roots.size() + most_in_part - 1) / most_in_part, 1);
  for (std::size_t part = 0; part < parts; ++part) {
    if (parts > 1)
      head("static __attribute__((noinline)) ", fmt::format("{}_{}", name, part));
    else
      head("", name);
    const std::size_t first = part * most_in_part,
                      last = std::min(first + most_in_part, roots.size());
    out.nodes({roots.begin() + static_cast<std::ptrdiff_t>(first),
               roots.begin() + static_cast<std::ptrdiff_t>(last)},
              type);
    for (std::size_t k = first; k < last; ++k)
      out.line("  f[{}] = {};", k, out.name(roots[k], type));
    out.line("}}");
  }
  if (parts == 1) return;
  head("", name);
  for (std::size_t part = 0; part < parts; ++part)
    out.line("  {}_{}(problem, t, y, f);", name, part);
  out.line("}}");
}

/// Dense.
void print_jacobian(Printer& out, const Analysis& analysis) {
  const std::size_t n = analysis.structure.states;
  out.line("void jacobian(const void* problem, double t, const double* y, double* j) {{");
  out.line("{}", unused);
  const std::vector<Id> roots = jacobian_roots(analysis);
  out.nodes(roots, in_double);
  if (roots.size() < n * n) out.line("  for (int k = 0; k < {}; ++k) j[k] = 0;", n * n);
  for (std::size_t row = 0; row < n; ++row)
    for (const Entry& entry : analysis.jacobian[row])
      out.line("  j[{}] = {};", row * n + entry.by, out.name(entry.value, in_double));
  out.line("}}");
}

void print_acceleration(Printer& out, const Problem& problem) {
  const std::size_t half = problem.states.size() / 2;
  out.line(
      "void acceleration(const void* problem, double t, const double* q, const double* v, "
      "double* a) {{");
  out.line("  (void)problem; (void)t; (void)q; (void)v;");
  const std::vector<Id> roots(problem.equations.begin() + static_cast<std::ptrdiff_t>(half),
                              problem.equations.end());
  out.nodes(roots, in_double, [&](std::uint32_t k) {
    return k < half ? fmt::format("q[{}]", k) : fmt::format("v[{}]", k - half);
  });
  for (std::size_t k = 0; k < half; ++k)
    out.line("  a[{}] = {};", k, out.name(roots[k], in_double));
  out.line("}}");
}

/// One coefficient, number k >= 1, of a step of the plan; see Series::advance.
void print_coefficient(Printer& out, const SeriesPlan& plan, const SeriesPlan::Step& step,
                       const Graph& graph) {
  const Id id = step.id;
  const auto array = [&](std::uint32_t at) { return fmt::format("s{}", plan.steps[at].id); };
  const auto constant = [&](std::uint32_t at) {
    return constant_text(graph[plan.steps[at].id].value, in_double);
  };
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
      return out.line("    s{0}[k] = ({1}[k] - square(s{0}, k)) / (2 * s{0}[0]);", id,
                      array(step.a));
    case Op::divide:
      if (is_constant(step.b))
        return out.line("    s{}[k] = {}[k] / {};", id, array(step.a), constant(step.b));
      return out.line("    s{0}[k] = ({1} - sum({2}, s{0}, 1, k)) / {2}[0];", id,
                      is_constant(step.a) ? "0" : array(step.a) + "[k]", array(step.b));
    default: {
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

void print_series(Printer& out, const Problem& problem, const SeriesPlan& plan) {
  const std::size_t n = problem.states.size();
  out.text +=
      "static inline double sum(const double* a, const double* b, int from, int k) {\n"
      "  double s = 0;\n  for (int j = from; j <= k; ++j) s += a[j] * b[k - j];\n  return s;\n}\n"
      "static inline double square(const double* a, int k) {\n"
      "  double s = 0;\n  for (int j = 1; 2 * j < k; ++j) s += a[j] * a[k - j];\n"
      "  return 2 * s + (k % 2 == 0 ? a[k / 2] * a[k / 2] : 0);\n}\n"
      "static inline double slopes(const double* a, const double* b, int k) {\n"
      "  double s = 0;\n  for (int j = 1; j <= k; ++j) s += j * a[j] * b[k - j];\n  return s;\n}\n";
  out.line("void taylor(const void* problem, double t, const double* y, int order, double* c) {{");
  out.line("{}", unused);
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
  for (const auto& step : plan.steps) print_coefficient(out, plan, step, problem.graph);
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

}  // namespace

std::string print_c(const Problem& problem, const Analysis& analysis) {
  Printer out(problem.graph);
  out.line("/* y' = f(t, y) with {} states, printed from a graph of operations */",
           problem.states.size());
  print_values(out, "rhs", problem.equations, in_double);
  constexpr std::size_t few_states = 64;
  if (problem.states.size() <= few_states) print_jacobian(out, analysis);
  const std::vector<Id> entries = jacobian_roots(analysis);
  print_values(out, "jacobian_entries", entries, in_double);
  if (!analysis.time_derivative.empty())
    print_values(out, "time_derivative", analysis.time_derivative, in_double);
  if (analysis.structure.second_order) print_acceleration(out, problem);
  // One function of all steps: the compiler takes minutes for more.
  constexpr std::size_t most_compiled = 600;
  if (analysis.series && analysis.series->steps.size() <= most_compiled)
    print_series(out, problem, *analysis.series);
  print_values(out, "rhs_extended", problem.equations, in_long_double);
  print_values(out, "entries_extended", entries, in_long_double);
  return std::move(out.text);
}

}  // namespace odeum::formula
