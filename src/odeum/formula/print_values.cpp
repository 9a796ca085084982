// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "odeum/formula/printer.hpp"
#include "odeum/formula/repeated.hpp"

namespace odeum::formula {
namespace {

constexpr std::size_t most_in_part = 256;
constexpr std::size_t fewest_in_loop = 16;     // fewer are as fast one by one
constexpr std::size_t most_shared = 1U << 16;  // they stand on the stack
constexpr std::size_t most_straight = 5'000;   // nodes; more take a compiler tens of seconds

/// Roots as sums of terms, each times a number: rates of many species are sums of few kinds of
/// terms, each of which several species have.
struct Sums {
  std::vector<Id> terms;
  std::vector<std::uint32_t> start{0}, term;  ///< those of each root, by their number
  std::vector<long double> weight;            ///< likewise

  /// Nothing where the sums share parts, so that they have far more terms than nodes.
  static std::optional<Sums> of(const Graph& graph, const std::vector<Id>& roots) {
    Sums sums;
    std::unordered_map<Id, std::uint32_t> number;
    const std::size_t most = 8 * graph.size();
    std::vector<std::pair<Id, long double>> open;
    for (const Id root : roots) {
      open.assign(1, {root, 1});
      while (!open.empty()) {
        const auto [id, weight] = open.back();
        open.pop_back();
        const Node& node = graph[id];
        if (node.op == Op::add || node.op == Op::subtract) {
          open.emplace_back(node.of[1], node.op == Op::add ? weight : -weight);
          open.emplace_back(node.of[0], weight);
        } else if (node.op == Op::negate) {
          open.emplace_back(node.of[0], -weight);
        } else if (node.op == Op::multiply && graph.is_number(node.of[0])) {
          open.emplace_back(node.of[1], weight * graph[node.of[0]].value);
        } else {
          const auto [at, is_new] =
              number.try_emplace(id, static_cast<std::uint32_t>(sums.terms.size()));
          if (is_new) sums.terms.push_back(id);
          sums.term.push_back(at->second);
          sums.weight.push_back(weight);
        }
        if (sums.term.size() + open.size() > most) return std::nullopt;
      }
      sums.start.push_back(static_cast<std::uint32_t>(sums.term.size()));
    }
    if (sums.terms.size() > most_shared) return std::nullopt;
    return sums;
  }
};

class ValuesPrinter {
 public:
  ValuesPrinter(Printer& out, const Function& function, const Type& type)
      : out_(out), function_(function), graph_(out.graph()), type_(type) {}

  void print(const std::vector<Id>& roots, const std::vector<std::uint32_t>& places) {
    std::vector<Id> shared;
    RepeatedRoots found, of_shared;
    if (roots.size() >= 2 * fewest_in_loop) {
      shared = shared_functions(graph_, roots);
      if (shared.size() < fewest_in_loop || shared.size() > most_shared) shared.clear();
      found = find_repeated(graph_, roots, fewest_in_loop, function_.split, shared);
      of_shared = find_repeated(graph_, shared, 1, function_.split);
      // If one shared function is outside of all loops, nothing is shared between loops.
      if (!of_shared.others.empty()) {
        shared.clear();
        of_shared = {};
        found = find_repeated(graph_, roots, fewest_in_loop, function_.split);
      }
    } else {
      found.others = in_order(roots.size());
    }
    print_all(roots, places, shared, found, of_shared);
  }

 private:
  void head(const std::string& kind, const std::string& name) {
    out_.line("{}void {}({}) {{", kind, name, function_.arguments);
    for (const char* unused : {"problem", "t", "y", "q", "v"})
      if (function_.passed.find(unused) != std::string::npos) out_.line("  (void){};", unused);
  }
  void main_head() {
    head("", function_.name);
    if (function_.cleared > 0)
      out_.line("  for (int k = 0; k < {}; ++k) {}[k] = {};", function_.cleared, function_.target,
                type_.lanes ? "all(0)" : "0");
  }
  void print_all(const std::vector<Id>& roots, const std::vector<std::uint32_t>& places,
                 const std::vector<Id>& shared, const RepeatedRoots& found,
                 const RepeatedRoots& of_shared) {
    const std::optional<Sums> sums = sums_of(roots, found.others);
    const std::vector<std::uint32_t> others = sums ? std::vector<std::uint32_t>() : found.others;
    const std::size_t parts = (others.size() + most_in_part - 1) / most_in_part;
    const bool is_plain = parts <= 1 && found.groups.empty();
    for (std::size_t part = 0; part < parts; ++part) {
      if (is_plain)
        main_head();
      else
        head("static __attribute__((noinline)) ", fmt::format("{}_{}", function_.name, part));
      std::vector<Id> in_part;
      const std::size_t first = part * most_in_part,
                        last = std::min(first + most_in_part, others.size());
      for (std::size_t k = first; k < last; ++k) in_part.push_back(roots[others[k]]);
      print_nodes(out_, function_, in_part, type_);
      for (std::size_t k = first; k < last; ++k)
        out_.line("  {}[{}] = {};", function_.target, places[others[k]],
                  out_.name(roots[others[k]], type_));
      out_.line("}}");
    }
    if (is_plain && parts == 1) return;
    main_head();
    std::vector<Id> before = found.before;
    before.insert(before.end(), of_shared.before.begin(), of_shared.before.end());
    print_nodes(out_, function_, before, type_);
    if (!shared.empty()) out_.line("  {} shared[{}];", type_.name, shared.size());
    for (const Repeated& group : of_shared.groups)
      print_loop(group, "shared", in_order(shared.size()));
    for (const Repeated& group : found.groups) print_loop(group, function_.target, places);
    for (std::size_t part = 0; part < parts; ++part)
      out_.line("  {}_{}({});", function_.name, part, function_.passed);
    if (sums) print_sums(*sums, found.others, places);
    out_.line("}}");
  }

  /// The sums that the roots outside of loops are, where a compiler takes long for as many nodes;
  /// prints the function that fills their terms.
  std::optional<Sums> sums_of(const std::vector<Id>& roots,
                              const std::vector<std::uint32_t>& others) {
    std::vector<Id> some;
    for (const std::uint32_t k : others) some.push_back(roots[k]);
    if (graph_.needed(some).size() < most_straight) return std::nullopt;
    std::optional<Sums> sums = Sums::of(graph_, some);
    if (!sums || sums->terms.size() == some.size()) return std::nullopt;
    Function terms = function_;
    terms.name += "_terms";
    terms.cleared = 0;
    ValuesPrinter(out_, terms, type_).print(sums->terms, in_order(sums->terms.size()));
    return sums;
  }
  void print_sums(const Sums& sums, const std::vector<std::uint32_t>& roots,
                  const std::vector<std::uint32_t>& places) {
    std::vector<std::uint32_t> at;
    for (const std::uint32_t root : roots) at.push_back(places[root]);
    const char* const number = type_.lanes ? in_double.name : type_.name;
    out_.line("  {{");
    out_.line("    static const unsigned start[] = {{{}}};", fmt::join(sums.start, ","));
    out_.line("    static const unsigned term[] = {{{}}};", fmt::join(sums.term, ","));
    std::string weights;
    for (const long double weight : sums.weight)
      weights += std::abs(weight) < 1e6L && weight == std::floor(weight)
                     ? fmt::format("{},", static_cast<int>(weight))
                     : constant_text(weight, type_.lanes ? in_double : type_) + ",";
    out_.line("    static const {} weight[] = {{{}}};", number, weights);
    out_.line("    static const unsigned to[] = {{{}}};", fmt::join(at, ","));
    out_.line("    {} terms[{}];", type_.name, sums.terms.size());
    out_.line("    {}_terms({}terms);", function_.name,
              function_.passed.substr(0, function_.passed.rfind(function_.target)));
    out_.line("    for (unsigned i = 0; i < {}; ++i) {{", roots.size());
    out_.line("      {} s = {};", type_.name, type_.lanes ? "all(0)" : "0");
    out_.line("      for (unsigned k = start[i]; k < start[i + 1]; ++k) s += {} * terms[term[k]];",
              type_.lanes ? "all(weight[k])" : "weight[k]");
    out_.line("      {}[to[i]] = s;\n    }}\n  }}", function_.target);
  }

  /// The elements of an array that a loop over i takes: by a formula where they are equally far
  /// apart, else by a table.
  std::string index(const std::vector<std::uint32_t>& of) {
    const auto distance = [&](std::size_t k) {
      return static_cast<std::int64_t>(of[k]) - static_cast<std::int64_t>(of[k - 1]);
    };
    bool even = true;
    for (std::size_t k = 2; k < of.size() && even; ++k) even = distance(k) == distance(1);
    if (of.size() == 1 || (even && distance(1) == 0)) return fmt::format("{}", of[0]);
    if (even && distance(1) == 1) return fmt::format("i + {}", of[0]);
    if (even) return fmt::format("{} * i + {}", distance(1), of[0]);
    const std::string name = fmt::format("at{}", tables_++);
    out_.line("    static const unsigned {}[] = {{{}}};", name, fmt::join(of, ", "));
    return name + "[i]";
  }
  std::string element(const std::vector<std::uint32_t>& states) {
    if (states[0] >= first_shared) return "shared[" + index(less(states, first_shared)) + "]";
    if (states[0] >= function_.split)
      return function_.second + "[" + index(less(states, function_.split)) + "]";
    return function_.first + "[" + index(states) + "]";
  }
  static std::vector<std::uint32_t> less(std::vector<std::uint32_t> numbers, std::uint32_t by) {
    for (std::uint32_t& number : numbers) number -= by;
    return numbers;
  }
  std::string constant(const std::vector<long double>& values) {
    const auto same = [&](long double value) {
      return value == values[0] && std::signbit(value) == std::signbit(values[0]);
    };
    if (std::ranges::all_of(values, same)) return constant_text(values[0], type_);
    const Type& type = type_.lanes ? in_double : type_;
    std::string all;
    for (const long double value : values) all += constant_text(value, type) + ", ";
    const std::string name = fmt::format("c{}", tables_++);
    out_.line("    static const {} {}[] = {{{}}};", type.name, name, all);
    return type_.lanes ? "all(" + name + "[i])" : name + "[i]";
  }

  void print_loop(const Repeated& group, const std::string& target,
                  const std::vector<std::uint32_t>& places) {
    out_.line("  {{");
    std::vector<std::string> states, constants;
    for (const auto& of : group.states) states.push_back(element(of));
    for (const auto& of : group.constants) constants.push_back(constant(of));
    std::vector<std::uint32_t> at;
    for (const std::uint32_t member : group.members) at.push_back(places[member]);
    const std::string to = index(at);
    out_.line("    for (unsigned i = 0; i < {}; ++i) {{", group.members.size());
    std::vector<std::string> names;
    for (const Repeated::Line& line : group.lines) {
      if (line.id != no_node)
        names.push_back(out_.name(line.id, type_));
      else if (line.op == Op::constant)
        names.push_back(constants[line.of[0]]);
      else if (line.op == Op::time)
        names.emplace_back("t");
      else {
        const auto argument = [&](std::size_t k) {
          return line.of[k] == no_node ? std::string() : names[line.of[k]];
        };
        const std::string value =
            line.op == Op::state
                ? states[line.of[0]]
                : out_.operation(line.op, argument(0), argument(1), argument(2), type_);
        names.push_back(fmt::format("w{}", names.size()));
        out_.line("      const {} {} = {};", type_.name, names.back(), value);
      }
    }
    out_.line("      {}[{}] = {};", target, to, names.back());
    out_.line("    }}\n  }}");
  }

  Printer& out_;
  const Function& function_;
  const Graph& graph_;
  const Type& type_;
  std::size_t tables_ = 0;
};

}  // namespace

Function values_function(const std::string& name, const Type& type) {
  return {.name = name,
          .arguments =
              fmt::format("const void* problem, {0} t, const {0}* y, {0}* __restrict f", type.name),
          .passed = "problem, t, y, f",
          .target = "f"};
}

void print_nodes(Printer& out, const Function& function, const std::vector<Id>& roots,
                 const Type& type) {
  for (const Id id : out.graph().needed(roots)) {
    const Node& node = out.graph()[id];
    if (node.op == Op::constant) continue;
    std::string value = "t";
    if (node.op == Op::state)
      value = node.index >= function.split
                  ? fmt::format("{}[{}]", function.second, node.index - function.split)
                  : fmt::format("{}[{}]", function.first, node.index);
    else if (node.op != Op::time)
      value = out.operation(node.op, node.of, type);
    out.line("  const {} v{} = {};", type.name, id, value);
  }
}

void print_values(Printer& out, const Function& function, const std::vector<Id>& roots,
                  const std::vector<std::uint32_t>& places, const Type& type) {
  ValuesPrinter(out, function, type).print(roots, places);
}

}  // namespace odeum::formula
