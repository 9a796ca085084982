// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/print/print_problem.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include "odeum/formula/printer.hpp"

namespace odeum::print {
namespace {

using namespace formula;

class ProblemPrinter {
 public:
  ProblemPrinter(const Problem& problem, const Analysis& analysis)
      : problem_(problem), analysis_(analysis), out_(problem.graph) {
    out_.owner = "this->";
  }

  std::string print(const std::string& name, const Offers& offers) {
    const Structure& s = analysis_.structure;
    out_.names = member_names(name, problem_.graph);
    out_.line("struct {} {{", name);
    out_.line("  static constexpr std::size_t dimension = {};", s.states);
    print_members(offers);
    if (offers.second_order && s.second_order)
      print_second_order();
    else
      print_function("template <class R>\n  void rhs(R t, const R* y, R* f)", problem_.equations,
                     "f", in_real);
    if (offers.jacobian) print_jacobian();
    if (!problem_.implicit_part.empty()) print_parts();
    if (!s.autonomous)
      print_function("void time_derivative(double t, const double* y, double* f)",
                     analysis_.time_derivative, "f", in_double);
    if (offers.series && analysis_.series)
      print_series(out_, "void taylor(double t, const double* y, int order, double* c) const {",
                   problem_, *analysis_.series);
    for (const Invariant& invariant : problem_.invariants) print_invariant(invariant);
    if (!problem_.events.empty()) print_events();
    out_.line("}};");
    return std::move(out_.text);
  }

 private:
  /// Parameters, and the constants that follow from them where a function needs them.
  void print_members(const Offers& offers) {
    const auto& definitions = problem_.graph.definitions();
    std::set<Id> needed;
    const auto need = [&](const std::vector<Id>& roots) {
      for (const Id id : problem_.graph.needed(roots)) needed.insert(id);
    };
    need(problem_.equations);
    if (offers.jacobian) need(jacobian_roots(analysis_));
    need(analysis_.time_derivative);
    need(problem_.explicit_part);
    need(problem_.implicit_part);
    need(jacobian_roots(analysis_.implicit_jacobian));
    if (offers.series && analysis_.series)
      for (const SeriesPlan::Step& step : analysis_.series->steps) needed.insert(step.id);
    for (const Invariant& invariant : problem_.invariants) need({invariant.value});
    for (const Event& event : problem_.events) {
      if (event.when != no_node) need({event.when});
      need(values_of(event));
    }
    for (std::size_t k = definitions.size(); k-- > 0;)
      if (needed.contains(definitions[k].id))
        needed.insert(definitions[k].of.begin(), definitions[k].of.end());
    for (std::size_t k = 0; k < definitions.size(); ++k) {
      const Definition& each = definitions[k];
      const std::string& name = out_.names[k];
      if (each.op == Op::constant)
        out_.line("  double {} = {};{}", name,
                  constant_text(problem_.graph[each.id].value, in_double),
                  name == each.name ? "" : "  // " + each.name);
      else if (needed.contains(each.id))
        out_.line("  double {} = {};", name, out_.operation(each.op, each.of, in_double));
    }
  }

  /// `head` and a body that sets the elements of an array; no_node stands for 0.
  void print_function(const std::string& head, const std::vector<Id>& roots,
                      const std::string& target, const Type& type, Function function = {}) {
    out_.line("  {} const {{", head);
    for (const char* unused : {"t", "y", "q", "v"})
      if (head.find(fmt::format(" {},", unused)) != std::string::npos)
        out_.line("  (void){};", unused);
    std::vector<Id> values;
    std::ranges::copy_if(roots, std::back_inserter(values), [](Id id) { return id != no_node; });
    print_nodes(out_, function, values, type);
    for (std::size_t k = 0; k < roots.size(); ++k)
      out_.line("  {}[{}] = {};", target, k, roots[k] == no_node ? "0" : out_.name(roots[k], type));
    out_.line("  }}");
  }

  void print_second_order() {
    const std::size_t half = analysis_.structure.states / 2;
    out_.line("  static constexpr bool velocity_dependent = {};",
              analysis_.structure.velocity_dependent);
    Function function;
    function.first = "q";
    function.second = "v";
    function.split = static_cast<std::uint32_t>(half);
    print_function(
        "template <class R>\n  void acceleration(R t, const R* q, const R* v, R* a)",
        {problem_.equations.begin() + static_cast<std::ptrdiff_t>(half), problem_.equations.end()},
        "a", in_real, function);
    out_.line("  void rhs(double t, const double* y, double* f) const {{");
    out_.line("  for (int i = 0; i < {0}; ++i) f[i] = y[{0} + i];", half);
    out_.line("  acceleration(t, y, y + {0}, f + {0});\n  }}", half);
  }

  void print_dense(const char* name, const std::vector<std::vector<Entry>>& rows) {
    const std::size_t n = rows.size();
    std::vector<Id> all(n * n, no_node);
    for (std::size_t row = 0; row < n; ++row)
      for (const Entry& entry : rows[row]) all[row * n + entry.by] = entry.value;
    print_function(fmt::format("void {}(double t, const double* y, double* j)", name), all, "j",
                   in_double);
  }
  void print_parts() {
    for (const auto& [name, roots] : {std::pair{"explicit_part", &problem_.explicit_part},
                                      {"implicit_part", &problem_.implicit_part}})
      print_function(fmt::format("void {}(double t, const double* y, double* f)", name), *roots,
                     "f", in_double);
    print_dense("implicit_jacobian", analysis_.implicit_jacobian);
  }
  void print_jacobian() {
    print_dense("jacobian", analysis_.jacobian);
    if (analysis_.structure.linear && analysis_.structure.autonomous)
      out_.line("  void linear_matrix(double* a) const {{ jacobian(0, nullptr, a); }}");
  }

  void print_invariant(const Invariant& invariant) {
    out_.line("  double {}(const double* y) const {{",
              invariant.is_energy() ? "energy" : "kept_" + invariant.name);
    print_nodes(out_, {}, {invariant.value}, in_double);
    out_.line("  return {};\n  }}", out_.name(invariant.value, in_double));
  }

  static std::vector<Id> values_of(const Event& event) {
    std::vector<Id> values;
    for (const auto& [state, value] : event.set) values.push_back(value);
    return values;
  }
  /// The functions of which a zero is an event, 0 for one at times, and what an event sets.
  void print_events() {
    std::vector<Id> functions;
    for (const Event& event : problem_.events) functions.push_back(event.when);
    out_.line("  static constexpr std::size_t events = {};", functions.size());
    print_function("void event_functions(double t, const double* y, double* g)", functions, "g",
                   in_double);
    out_.line(
        "  void happen(std::size_t event, double t, const double* y, double* after) const {{");
    out_.line("    (void)t, (void)y, (void)after;");
    for (std::size_t k = 0; k < problem_.events.size(); ++k) {
      const Event& event = problem_.events[k];
      out_.line("    if (event == {}) {{  // {}", k, event.name);
      print_nodes(out_, {}, values_of(event), in_double);
      for (const auto& [state, value] : event.set)
        out_.line("      after[{}] = {};", state, out_.name(value, in_double));
      out_.line("    }}");
    }
    out_.line("  }}");
  }

  const Problem& problem_;
  const Analysis& analysis_;
  Printer out_;
};

// clang-format off
constexpr std::string_view taken[] = {
    // keywords
    "alignas", "alignof", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case",
    "catch", "char", "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return",
    "co_yield", "compl", "concept", "const", "const_cast", "consteval", "constexpr", "constinit",
    "continue", "decltype", "default", "delete", "do", "double", "dynamic_cast", "else", "enum",
    "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "inline", "int",
    "long", "mutable", "namespace", "new", "noexcept", "not_eq", "nullptr", "operator", "or_eq",
    "private", "protected", "public", "register", "reinterpret_cast", "requires", "return",
    "short", "signed", "sizeof", "static", "static_assert", "static_cast", "struct", "switch",
    "template", "this", "thread_local", "throw", "true", "try", "typedef", "typeid", "typename",
    "typeof", "union", "unsigned", "using", "virtual", "void", "volatile", "wchar_t", "while",
    "xor", "xor_eq",
    // macros of headers and of compilers
    "assert", "BUFSIZ", "CHAR_BIT", "DOMAIN", "EDOM", "EOF", "ERANGE", "errno", "EXIT_FAILURE",
    "EXIT_SUCCESS", "HUGE", "HUGE_VAL", "HUGE_VALF", "HUGE_VALL", "i386", "INFINITY", "INT_MAX",
    "INT_MIN", "linux", "LONG_MAX", "LONG_MIN", "major", "minor", "NAN", "NULL", "offsetof",
    "OVERFLOW", "PLOSS", "RAND_MAX", "SING", "stderr", "stdin", "stdout", "TLOSS", "UNDERFLOW",
    "unix",
    // the struct's own
    "acceleration", "after", "dimension", "energy", "event", "event_functions", "events",
    "explicit_part", "happen", "implicit_jacobian", "implicit_part", "jacobian", "linear_matrix",
    "power", "rhs", "root", "slopes", "square", "std", "sum", "taylor", "time_derivative",
    "velocity_dependent"};
// clang-format on
constexpr std::string_view taken_beginnings[] = {"FP_", "kept_", "M_", "MATH_", "SEEK_"};

bool is_taken(const std::string& name, const std::string& of) {
  return name == of || std::ranges::find(taken, name) != std::end(taken) ||
         std::ranges::any_of(taken_beginnings,
                             [&](std::string_view each) { return name.starts_with(each); });
}

}  // namespace

std::vector<std::string> member_names(const std::string& of, const Graph& graph) {
  std::set<std::string> used, printed;
  for (const Definition& each : graph.definitions()) used.insert(each.name);
  std::vector<std::string> names;
  for (const Definition& each : graph.definitions()) {
    std::string name = each.name;
    // Names that begin with _ or have __ are the compiler's.
    if (name.starts_with('_') || name.find("__") != std::string::npos || is_taken(name, of) ||
        !printed.insert(name).second)
      for (name.insert(0, "p_"); used.contains(name);) name += '_';
    used.insert(name);
    names.push_back(std::move(name));
  }
  return names;
}

std::string print_struct(const std::string& name, const Problem& problem, const Analysis& analysis,
                         const Offers& offers) {
  return ProblemPrinter(problem, analysis).print(name, offers);
}

}  // namespace odeum::print
