// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/event.hpp"

#include <algorithm>
#include <optional>

#include "odeum/formula/problem.hpp"
#include "odeum/formula/switch_times.hpp"

namespace odeum::formula {
namespace {

bool is_comparison(Op op) { return op == Op::less || op == Op::less_equal || op == Op::equal; }

class Watching {
 public:
  explicit Watching(Problem& problem) : problem_(problem), graph_(problem.graph) {}

  void operator()() {
    for (std::size_t k = 0; k < problem_.events.size(); ++k)
      if (const Event& event = problem_.events[k]; event.when != no_node)
        watch({.function = event.when, .sense = event.sense, .event = k, .zeros = {}, .sides = {}});
    std::map<Id, Id> functions;  // by comparison
    for (const Event& event : problem_.events)
      if (event.condition != no_node) find_comparisons(event.condition, functions);
    std::map<Id, std::pair<bool, std::size_t>> known;  // by function
    for (const auto& [comparison, function] : functions)
      if (!known.contains(function))
        known[function] =
            watch({.function = function, .sense = 0, .event = no_event, .zeros = {}, .sides = {}});
    for (const auto& [comparison, function] : functions) {
      const auto& [is_clocked, number] = known.at(function);
      problem_.comparisons[comparison] = number + (is_clocked ? problem_.watched.size() : 0);
    }
  }

 private:
  /// Whether a node has whole numbers of values: nothing but comparisons makes it change.
  bool is_discrete(Id id) {
    const auto [at, is_new] = discrete_.try_emplace(id, true);
    if (!is_new) return at->second;
    const Node node = graph_[id];
    bool is = node.op != Op::time && node.op != Op::state;
    if (!is_comparison(node.op))
      for (std::size_t k = 0; k < arity(node.op); ++k) is = is && is_discrete(node.of[k]);
    return discrete_[id] = is;
  }
  void find_comparisons(Id id, std::map<Id, Id>& functions) {
    const Node node = graph_[id];
    if (functions.contains(id)) return;
    if (is_comparison(node.op) && !(is_discrete(node.of[0]) && is_discrete(node.of[1]))) {
      functions[id] = graph_.make(Op::subtract, node.of[1], node.of[0]);
      return;
    }
    for (std::size_t k = 0; k < arity(node.op); ++k) find_comparisons(node.of[k], functions);
  }

  /// Whether its zeros are known, and its number among those of its kind.
  std::pair<bool, std::size_t> watch(Watched watched) {
    const bool is_clocked = set_clock(watched);
    std::vector<Watched>& all = is_clocked ? problem_.clocked : problem_.watched;
    all.push_back(std::move(watched));
    return {is_clocked, all.size() - 1};
  }
  bool set_clock(Watched& watched) {
    constexpr std::size_t most = 10'000;
    const std::vector<Id> needed = graph_.needed({watched.function});
    if (std::ranges::any_of(needed, [&](Id id) { return graph_[id].op == Op::state; }))
      return false;
    const long double start = problem_.t0, end = problem_.events_until;
    auto zeros = zeros_in_time(graph_, watched.function, start, end);
    if (!zeros || zeros->size() > most) return false;
    std::erase_if(*zeros, [&](long double t) { return t <= start; });
    const Evaluator<long double> function(graph_, {watched.function});
    const auto side = [&](long double t) {
      long double value = 0;
      function(t, nullptr, &value);
      return static_cast<int>(value > 0) - static_cast<int>(value < 0);
    };
    long double before = start;
    for (std::size_t k = 0; k <= zeros->size(); ++k) {
      long double after = k < zeros->size() ? (*zeros)[k] : end;
      if (!(after > before)) after = before + (end - start) / 100;  // it is zero at the end
      watched.sides.push_back(side(before + (after - before) / 2));
      before = after;
    }
    watched.zeros = *std::move(zeros);
    return true;
  }

  Problem& problem_;
  Graph& graph_;
  std::map<Id, bool> discrete_;
};

}  // namespace

void watch_events(Problem& problem) { Watching{problem}(); }

}  // namespace odeum::formula
