// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/lane_code.hpp"

#include <algorithm>

#include "odeum/formula/printer.hpp"

namespace odeum::formula {
namespace {

/// What operators of C do not do with vectors is done by the vector functions of core/lanes.hpp, or
/// else lane by lane. That is not inlined, since its loop would stand between the products and sums
/// that the compiler joins elsewhere: within a block of code without branches alone.
constexpr const char* prelude = R"(
#define t (*time)
static inline V all(double x) { return x - (V){0}; }
#define EACH(name, arguments, value) static __attribute__((noinline)) V lanes_##name arguments { \
  V r; for (int i = 0; i < N; ++i) r[i] = value; return r; }
#define FUNCTION(name) EACH(name, (V a), __builtin_##name(a[i]))
#define OF_TWO(name) EACH(name, (V a, V b), __builtin_##name(a[i], b[i]))
FUNCTION(sqrt) FUNCTION(fabs) FUNCTION(floor)
EACH(side, (V a), __builtin_copysign(1.0, a[i]))
EACH(sign, (V a), (a[i] > 0) - (a[i] < 0) + 0 * a[i])
)";

#define ODEUM_TEXT(word) #word
#define ODEUM_TEXT_OF(word) ODEUM_TEXT(word)
#ifdef ODEUM_VECTOR_FUNCTIONS
#define ODEUM_DECLARED(letters, arguments, name)                 \
  "V " ODEUM_TEXT_OF(ODEUM_VECTOR_NAME(letters, name)) arguments \
      ";\n#define lanes_" #name " " ODEUM_TEXT_OF(ODEUM_VECTOR_NAME(letters, name)) "\n"
#define ODEUM_ONE(name) ODEUM_DECLARED(v, "(V)", name)
#define ODEUM_TWO(name) ODEUM_DECLARED(vv, "(V, V)", name)
#else
#define ODEUM_ONE(name) "FUNCTION(" #name ")\n"
#define ODEUM_TWO(name) "OF_TWO(" #name ")\n"
#endif
constexpr const char* vector_functions = ODEUM_EACH_FUNCTION(ODEUM_ONE, ODEUM_TWO);

/// A choice is a branch where a member is alone, and none in lanes.
bool has_choices(const Problem& problem, const Analysis& analysis) {
  std::vector<Id> roots = problem.equations;
  const std::vector<Id> entries = jacobian_roots(analysis);
  roots.insert(roots.end(), entries.begin(), entries.end());
  roots.insert(roots.end(), analysis.time_derivative.begin(), analysis.time_derivative.end());
  const std::vector<Id> needed = problem.graph.needed(roots);
  return std::ranges::any_of(needed, [&](Id id) {
    const Op op = problem.graph[id].op;
    return op == Op::choose || op == Op::min || op == Op::max;
  });
}

Function function(const std::string& name) {
  return {.name = name,
          .arguments = "const void* problem, const V* time, const V* y, V* __restrict f",
          .passed = "problem, time, y, f",
          .target = "f"};
}

}  // namespace

std::string print_lanes(const Problem& problem, const Analysis& analysis) {
  Printer out(problem.graph);
  out.owner = "(*(const V* const*)problem)";
  out.numbered = true;
  out.line("typedef double V __attribute__((vector_size({})));\nenum {{ N = {} }};{}{}",
           vector_bytes, Lanes::count, prelude, vector_functions);
  const std::size_t n = analysis.structure.states;
  print_values(out, function("rhs"), problem.equations, in_order(n), in_lanes);
  print_jacobian(out, function("jacobian"), analysis.jacobian, in_lanes);
  if (!analysis.time_derivative.empty())
    print_values(out, function("time_derivative"), analysis.time_derivative, in_order(n), in_lanes);
  return std::move(out.text);
}

LaneView compile_lanes(const TextOde& ode) {
  LaneView view;
  view.dimension = ode.size();
  view.constants = ode.problem().graph.definitions().size();
  if (has_choices(ode.problem(), ode.analysis())) return view;
  const Compiled compiled = compile_c(print_lanes(ode.problem(), ode.analysis()));
  if (!compiled.library) return view;
  view.code = compiled.library;
  view.rhs = compiled.library->function<LaneView::Function>("rhs");
  view.jacobian = compiled.library->function<LaneView::Function>("jacobian");
  view.time_derivative = compiled.library->function<LaneView::Function>("time_derivative");
  return view;
}

}  // namespace odeum::formula
