// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/switch_times.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/interval.hpp"

namespace odeum::formula {
namespace {

using Real = long double;

/// The zeros of an expression of the time alone, by interval arithmetic: a part of the time over
/// whose enclosure the expression is not zero has none, and one over which it is monotone has at
/// most one, which its signs at both ends tell.
class Zeros {
 public:
  /// `known`: zeros of expressions inside of this one, at which it may have a kink.
  Zeros(Graph& graph, Id value, const std::vector<Real>& known)
      : known_(known), value_(graph, {value}), range_(graph, {value}) {
    const std::vector<Id> inside = graph.needed({value});
    if (std::ranges::any_of(inside, [&](Id id) { return has_kinks(graph[id].op); })) return;
    try {
      const auto rows = gradients(graph, {value}, 0);
      if (!rows.front().empty()) slope_.emplace(graph, std::vector{rows.front().front().value});
    } catch (const std::length_error&) {  // they are found without it, in more parts
    }
  }

  /// False where they are too many, or too close to each other, to be separated.
  bool find(Real from, Real to, std::vector<Real>& zeros) {
    constexpr std::size_t most_parts = 40'000;
    const Real least = 0x1p-51L * std::max(std::abs(from), std::abs(to));
    std::vector<Part> open{{from, to}};
    while (!open.empty() && open.front().to - open.front().from > least) {
      std::vector<Part> next;
      for (const Part& part : open)
        if (!split(part, next, zeros) || (parts_ += lanes) > most_parts) return false;
      open = std::move(next);
    }
    for (std::size_t k = 0; k < open.size();) {
      Part cluster = open[k];
      for (++k; k < open.size() && open[k].from <= cluster.to; ++k) cluster.to = open[k].to;
      search(cluster, zeros);
    }
    return true;
  }

 private:
  struct Part {
    Real from, to;
  };

  int sign(Real t) const {
    Real v = 0;
    value_(t, nullptr, &v);
    return (v > 0) - (v < 0);
  }

  /// Adds to `open` those of the parts of one that may have more than one zero, and to `zeros` the
  /// single ones. False where no value is known.
  bool split(const Part& part, std::vector<Part>& open, std::vector<Real>& zeros) {
    const Real width = (part.to - part.from) / lanes;
    const auto left = [&](std::size_t s) { return part.from + width * static_cast<Real>(s); };
    Intervals times;
    for (std::size_t s = 0; s < lanes; ++s)
      times[s] = {static_cast<double>(left(s)) - 1e-300, static_cast<double>(left(s + 1)) + 1e-300};
    for (Interval& time : times)  // the rounding of the ends to double
      time = {time.low - 0x1p-52 * std::abs(time.low), time.high + 0x1p-52 * std::abs(time.high)};
    const Intervals values = range_(times, {})[range_.place(0)];
    const bool has_slope = slope_.has_value();
    const Intervals slopes = has_slope ? (*slope_)(times, {})[slope_->place(0)] : Intervals{};
    for (std::size_t s = 0; s < lanes; ++s) {
      if (std::isnan(values[s].low) || std::isnan(values[s].high)) return false;
      if (values[s].low > 0 || values[s].high < 0) continue;
      const Part each{left(s), s + 1 == lanes ? part.to : left(s + 1)};
      if (has_slope && (slopes[s].low > 0 || slopes[s].high < 0))
        search(each, zeros);
      else
        open.push_back(each);
    }
    return true;
  }

  /// Adds the zeros where the sign changes between the ends of a part and the known times in it.
  void search(const Part& part, std::vector<Real>& zeros) const {
    std::vector<Real> points{part.from};
    for (const Real t : known_)
      if (t > part.from && t < part.to) points.push_back(t);
    points.push_back(part.to);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const int at = sign(points[k]);
      if (at == 0) zeros.push_back(points[k]);
      if (k > 0 && at * sign(points[k - 1]) < 0) zeros.push_back(bisect(points[k - 1], points[k]));
    }
  }
  /// The change of sign to the last bit.
  Real bisect(Real low, Real high) const {
    const int begin = sign(low);
    for (;;) {
      const Real middle = low + (high - low) / 2;
      if (!(middle > low && middle < high)) return high;
      const int at = sign(middle);
      if (at == 0) return middle;
      (at == begin ? low : high) = middle;
    }
  }

  const std::vector<Real>& known_;
  Evaluator<Real> value_;
  Enclosure range_;
  std::optional<Enclosure> slope_;
  std::size_t parts_ = 0;
};

/// The switches that depend on no state, inner ones before outer ones.
std::vector<Id> timed_switches(const Problem& problem) {
  const Graph& graph = problem.graph;
  std::vector<Id> found;
  std::vector<bool> of_state(graph.size(), false);
  for (const Id id : graph.needed(problem.equations)) {
    const Node& node = graph[id];
    of_state[id] = node.op == Op::state;
    for (std::size_t k = 0; k < arity(node.op); ++k)
      of_state[id] = of_state[id] || of_state[node.of[k]];
    if (!of_state[id] && is_switch(node.op)) found.push_back(id);
  }
  return found;
}

}  // namespace

bool is_switch(Op op) {
  return op == Op::less || op == Op::less_equal ||
         (has_kinks(op) && op != Op::choose && op != Op::side);
}

Id zero_at_switch(Graph& graph, Node node) {
  if (node.op == Op::abs || node.op == Op::sign) return node.of[0];
  if (node.op == Op::floor)  // whole numbers
    return graph.make(
        Op::sin, graph.make(Op::multiply, graph.constant(std::numbers::pi_v<Real>), node.of[0]));
  return graph.make(Op::subtract, node.of[1], node.of[0]);
}

std::optional<std::vector<Real>> zeros_in_time(Graph& graph, Id value, Real from, Real to) {
  std::vector<Real> zeros;
  const std::vector<Real> none;
  if (!Zeros(graph, value, none).find(from, to, zeros)) return std::nullopt;
  std::ranges::sort(zeros);
  zeros.erase(std::unique(zeros.begin(), zeros.end()), zeros.end());
  return zeros;
}

bool has_timed_switches(const Problem& problem) { return !timed_switches(problem).empty(); }

SwitchTimes switch_times(const Problem& problem, long double end) {
  constexpr std::size_t most_times = 10'000;
  SwitchTimes result;
  const std::vector<Id> nodes = timed_switches(problem);
  if (nodes.empty()) return result;
  Graph graph = problem.graph;
  std::vector<Real> all;  // with those at the start and at the end
  for (const Id id : nodes) {
    const Node node = graph[id];
    const Id value = zero_at_switch(graph, node);
    std::vector<Real> zeros;
    const bool constant = graph.is_constant(value);
    if (!constant && !Zeros(graph, value, all).find(problem.t0, end, zeros)) continue;
    if (all.size() + zeros.size() > most_times) continue;
    all.insert(all.end(), zeros.begin(), zeros.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    result.nodes.insert(id);
  }
  std::ranges::copy_if(all, std::back_inserter(result.times),
                       [&](Real t) { return t > problem.t0 && t < end; });
  return result;
}

}  // namespace odeum::formula
