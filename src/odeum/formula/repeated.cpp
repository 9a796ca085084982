// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/repeated.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>

namespace odeum::formula {
namespace {

constexpr std::uint32_t most_uses = 8;   // of what is computed in a loop
constexpr std::size_t most_lines = 256;  // longer roots are not worth a search

bool is_costly(Op op) {
  return (op >= Op::sin && op <= Op::sign) || (op >= Op::power && op <= Op::max);
}

/// For each node, the number of roots that depend on it, up to one more than most_uses. A node of
/// more uses does not count as a use of its arguments.
std::vector<std::uint32_t> uses_of(const Graph& graph, const std::vector<Id>& roots) {
  std::vector<std::uint32_t> uses(graph.size(), 0), seen_by(graph.size(), 0), open;
  for (std::uint32_t r = 0; r < roots.size(); ++r) {
    std::size_t visited = 0;
    open.assign(1, roots[r]);
    while (!open.empty() && visited < most_lines) {
      const Id id = open.back();
      open.pop_back();
      if (is_leaf(graph[id].op) || seen_by[id] == r + 1) continue;
      seen_by[id] = r + 1;
      if (uses[id] > most_uses || ++uses[id] > most_uses) continue;
      ++visited;
      for (const Id argument : graph[id].of)
        if (argument != no_node) open.push_back(argument);
    }
  }
  return uses;
}

/// One root: its lines, and the states and constants at its leaves. `key` is equal for equal forms.
struct Form {
  std::vector<Repeated::Line> lines;
  std::vector<std::uint32_t> states;
  std::vector<long double> constants;
  std::string key;
};

class FormReader {
 public:
  FormReader(const Graph& graph, const std::vector<std::uint32_t>& uses, std::uint32_t split)
      : graph_(graph), uses_(uses), split_(split) {}
  std::unordered_map<Id, std::uint32_t> shared;  ///< as which state a node counts

  /// Nothing where the root is too long.
  std::optional<Form> read(Id root) {
    form_ = {};
    place_.clear();
    visited_ = 0;
    if (visit(root, true) == no_node) return std::nullopt;
    return std::move(form_);
  }

 private:
  /// The number of its line; no_node where there are too many.
  std::uint32_t visit(Id id, bool is_root) {
    if (const auto known = place_.find(id); known != place_.end()) return known->second;
    if (++visited_ > most_lines) return no_node;
    const Node& node = graph_[id];
    Repeated::Line line{.op = node.op};
    const auto as_state = shared.find(id);
    if (as_state != shared.end() && !is_root) {
      line.op = Op::state;
      line.of[0] = add_state(as_state->second);
    } else if (node.op == Op::constant && node.index != 0) {
      line.id = id;  // its name says its value
    } else if (node.op == Op::constant) {
      line.of[0] = static_cast<std::uint32_t>(form_.constants.size());
      form_.constants.push_back(node.value);
    } else if (node.op == Op::state) {
      line.of[0] = add_state(node.index);
    } else if (!is_leaf(node.op) && uses_[id] > most_uses) {
      line.id = id;
    } else {
      for (std::size_t k = 0; k < node.of.size() && node.of[k] != no_node; ++k)
        if (line.of[k] = visit(node.of[k], false); line.of[k] == no_node) return no_node;
    }
    write_key(line);
    form_.lines.push_back(line);
    return place_[id] = static_cast<std::uint32_t>(form_.lines.size() - 1);
  }
  std::uint32_t add_state(std::uint32_t index) {
    // The names of arrays are part of the form, the places in them are not.
    form_.key += index >= first_shared ? 'c' : index >= split_ ? 'b' : 'a';
    form_.states.push_back(index);
    return static_cast<std::uint32_t>(form_.states.size() - 1);
  }
  void write_key(const Repeated::Line& line) {
    form_.key += static_cast<char>(line.op);
    for (const std::uint32_t word : {line.id, line.of[0], line.of[1], line.of[2]})
      for (unsigned shift = 0; shift < 32; shift += 8)
        form_.key += static_cast<char>(word >> shift & 0xffU);
  }

  const Graph& graph_;
  const std::vector<std::uint32_t>& uses_;
  std::uint32_t split_;
  Form form_;
  std::unordered_map<Id, std::uint32_t> place_;
  std::size_t visited_ = 0;
};

void add_member(Repeated& group, std::uint32_t root, Form form) {
  if (group.members.empty()) {
    group.lines = std::move(form.lines);
    group.states.resize(form.states.size());
    group.constants.resize(form.constants.size());
  }
  group.members.push_back(root);
  for (std::size_t k = 0; k < form.states.size(); ++k) group.states[k].push_back(form.states[k]);
  for (std::size_t k = 0; k < form.constants.size(); ++k)
    group.constants[k].push_back(form.constants[k]);
}

}  // namespace

std::vector<Id> shared_functions(const Graph& graph, const std::vector<Id>& roots) {
  const std::vector<std::uint32_t> uses = uses_of(graph, roots);
  std::vector<Id> shared;
  for (Id id = 0; id < graph.size(); ++id)
    if (is_costly(graph[id].op) && uses[id] > 1 && uses[id] <= most_uses) shared.push_back(id);
  return shared;
}

RepeatedRoots find_repeated(const Graph& graph, const std::vector<Id>& roots, std::size_t least,
                            std::uint32_t split, const std::vector<Id>& shared) {
  const std::vector<std::uint32_t> uses = uses_of(graph, roots);
  FormReader reader(graph, uses, split);
  for (std::uint32_t k = 0; k < shared.size(); ++k) reader.shared[shared[k]] = first_shared + k;
  std::unordered_map<std::string, std::size_t> number;
  std::vector<Repeated> groups;
  RepeatedRoots found;
  for (std::uint32_t r = 0; r < roots.size(); ++r) {
    std::optional<Form> form = reader.read(roots[r]);
    if (!form) {
      found.others.push_back(r);
      continue;
    }
    const auto [at, is_new] = number.try_emplace(form->key, groups.size());
    if (is_new) groups.emplace_back();
    add_member(groups[at->second], r, std::move(*form));
  }
  for (Repeated& group : groups) {
    if (group.members.size() < least) {
      found.others.insert(found.others.end(), group.members.begin(), group.members.end());
      continue;
    }
    for (const Repeated::Line& line : group.lines)
      if (line.id != no_node) found.before.push_back(line.id);
    found.groups.push_back(std::move(group));
  }
  std::ranges::sort(found.others);
  return found;
}

}  // namespace odeum::formula
