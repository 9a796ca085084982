// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/network_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "odeum/formula/names.hpp"
#include "odeum/formula/statement_text.hpp"

namespace odeum::cases {
namespace {

using formula::begins_name;
using formula::continues_name;

/// A line of a block without its number and its remark, as words.
struct Line {
  std::size_t number;
  std::vector<std::string> words;
};

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

class Network {
 public:
  Network(const std::string& file, const std::string& text)
      : file_(file), text_(std::filesystem::path(file).stem().string()) {
    read_blocks(text);
  }

  std::string text(double end) {
    for (const char* const block : {"parameters", "functions"})
      for (const Line& line : blocks_[block]) give_name(line);
    for (const Line& line :
         blocks_["groups"]) {  // a parameter of that name is meant in expressions
      groups_.push_back(text_.new_name(line.words[0]));
      names_.try_emplace(line.words[0], groups_.back());
    }
    for (const Line& line : blocks_["parameters"])
      text_.parameter(names_.at(line.words[0]), expression(line, 1));
    read_species();
    read_groups();
    for (const Line& line : blocks_["functions"]) {
      const std::string name = bare(line.words[0]);
      text_.definition(names_.at(name), expression(line, 1));
      text_.output(name, names_.at(name));
    }
    for (const Line& line : blocks_["reactions"]) read_reaction(line);
    for (const std::string& name : idle_) text_.equation(name, "0");
    try {
      return text_.text(end);
    } catch (const std::invalid_argument& cycle) {
      throw InputError(file_, {}, cycle.what());
    }
  }

 private:
  template <class... Values>
  [[noreturn]] void fail(const Line& line, fmt::format_string<Values...> what,
                         Values&&... values) const {
    throw InputError(file_, {line.number, 1}, fmt::format(what, std::forward<Values>(values)...));
  }

  void read_blocks(const std::string& text) {
    std::istringstream in(text);
    std::string block, line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      Line each{number, words_of(line)};
      if (each.words.empty()) continue;
      const bool begins = each.words[0] == "begin";
      if (begins || each.words[0] == "end") {
        block.clear();
        for (std::size_t k = 1; begins && k < each.words.size(); ++k)
          block += (k > 1 ? " " : "") + each.words[k];
        if (begins) blocks_[block];
        continue;
      }
      // Others, as molecule types, are what the network was generated from.
      static const std::set<std::string> read{"parameters", "functions", "species", "reactions",
                                              "groups"};
      if (!read.contains(block)) continue;
      each.words.erase(each.words.begin());  // its number in the block
      if (each.words.size() < 2) fail(each, "{}: got {}, expected more", block, shown(line));
      blocks_[block].push_back(std::move(each));
    }
    for (const char* const needed : {"species", "reactions"})
      if (!blocks_.contains(needed))
        throw InputError(
            file_, {},
            fmt::format("no block of {}; got none, expected `begin {}`", needed, needed));
  }

  /// A function's name without its parentheses.
  static std::string bare(const std::string& name) { return name.substr(0, name.find('(')); }

  void give_name(const Line& line) {
    const std::string name = bare(line.words[0]);
    if (!names_.try_emplace(name, "").second) fail(line, "a name twice; got {}", shown(name));
    names_[name] = text_.new_name(name);
  }

  /// The words from `first` on, with names as the text has them.
  std::string expression(const Line& line, std::size_t first) const {
    std::string all;
    for (std::size_t k = first; k < line.words.size(); ++k) all += line.words[k];
    return expression_of(line, all);
  }

  std::string expression_of(const Line& line, const std::string& all) const {
    static const std::map<std::string, std::string> others{
        {"_pi", "pi"}, {"_e", "e"}, {"ln", "log"}, {"time", "t"},  {"rint", ""},
        {"sum", ""},   {"avg", ""}, {"log2", ""},  {"mratio", ""}, {"TFUN", ""}};
    std::string result;
    for (std::size_t k = 0; k < all.size();) {
      const std::size_t begin = k;
      // Numbers have letters of their own, 1e-3.
      if (formula::is_digit(all[k]) || all[k] == '.') {
        double ignored = 0;
        k = static_cast<std::size_t>(
            std::from_chars(all.data() + k, all.data() + all.size(), ignored).ptr - all.data());
        if (k == begin) fail(line, "not a number; got {}", shown(all.substr(begin, 12)));
        result += all.substr(begin, k - begin);
        continue;
      }
      while (k < all.size() && continues_name(all[k])) ++k;
      if (k == begin) {
        result += all[k++];
        continue;
      }
      const std::string name = all.substr(begin, k - begin);
      if (const auto known = names_.find(name); known != names_.end()) {
        result += known->second;
        if (all.compare(k, 2, "()") == 0) k += 2;
      } else if (const auto other = others.find(name); other != others.end()) {
        if (other->second.empty()) fail(line, "the function {} is not supported", name);
        result += other->second;
        if (all.compare(k, 2, "()") == 0) k += 2;
      } else {
        result += name;
      }
    }
    return result;
  }

  /// s1, s2, ..., or the pattern where that is a name alone, A().
  void read_species() {
    for (const Line& line : blocks_["species"]) {
      // @C::A() is in a compartment, $A() has a fixed value.
      std::string pattern = line.words[0];
      if (pattern.starts_with('@')) pattern.erase(0, pattern.find("::") + 2);
      const bool is_fixed = pattern.starts_with('$');
      const std::string plain = bare(pattern.substr(is_fixed));
      const bool is_name = pattern.ends_with("()") && pattern.find('.') == std::string::npos &&
                           formula::fault_of_name(plain).empty() && !names_.contains(plain);
      species_.push_back(text_.new_name(is_name ? plain : fmt::format("s{}", species_.size() + 1)));
      if (is_fixed)
        text_.parameter(species_.back(), expression(line, 1));
      else
        text_.state(species_.back(), expression(line, 1)), idle_.insert(species_.back());
    }
  }

  const std::string& species_at(const Line& line, std::string_view number) const {
    std::size_t k = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), k);
    if (error != std::errc() || end != number.data() + number.size() || k < 1 ||
        k > species_.size())
      fail(line, "not a species; got {}, expected a number from 1 to {}", shown(number),
           species_.size());
    return species_[k - 1];
  }

  static void each_of(const std::string& list, const std::function<void(std::string_view)>& use) {
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t comma = std::min(list.find(',', at), list.size());
      use(std::string_view(list).substr(at, comma - at));
      at = comma + 1;
    }
  }

  void read_groups() {
    for (std::size_t k = 0; k < groups_.size(); ++k) {
      const Line& line = blocks_["groups"][k];
      std::string sum;
      each_of(line.words[1], [&](std::string_view term) {
        const std::size_t star = term.find('*');
        if (!sum.empty()) sum += " + ";
        if (star != std::string_view::npos) sum += std::string(term.substr(0, star)) + '*';
        sum += species_at(line, star == std::string_view::npos ? term : term.substr(star + 1));
      });
      text_.definition(groups_[k], sum);
      text_.output(line.words[0], groups_[k]);
    }
  }

  void read_reaction(const Line& line) {
    if (line.words.size() < 3)
      fail(line, "reactions: got {} words, expected reactants, products and a rate",
           line.words.size());
    std::vector<std::string> reactants;
    const auto side = [&](const std::string& list, bool left) {
      std::string all;
      if (list == "0") return all;
      each_of(list, [&](std::string_view number) {
        const std::string& name = species_at(line, number);
        all += (all.empty() ? "" : " + ") + name;
        idle_.erase(name);
        if (left) reactants.push_back(name);
      });
      return all;
    };
    const std::string left = side(line.words[0], true), right = side(line.words[1], false),
                      arrow = left + " -> " + right;
    if (line.words.size() == 3)
      text_.reaction(arrow, expression(line, 2));
    else
      text_.reaction(arrow, saturated(line, reactants));
  }

  /// The factor of the reactants' product.
  std::string saturated(const Line& line, const std::vector<std::string>& reactants) const {
    const std::string& kind = line.words[2];
    if ((kind != "Sat" && kind != "MM") || line.words.size() != 5 || reactants.empty() ||
        (kind == "MM" && reactants.size() != 2))
      fail(line, "reactions: the rate {} is not supported; expected mass action, Sat or MM",
           shown(kind));
    const std::string k = expression_of(line, line.words[3]),
                      km = expression_of(line, line.words[4]), &s = reactants[0];
    if (kind == "Sat") return fmt::format("({})/(({}) + {})", k, km, s);
    // The substrate that is free, as Tzafriri has it (2003), in place of all of it.
    const std::string excess = fmt::format("({} - ({}) - {})", s, km, reactants[1]),
                      free = fmt::format("(0.5*({0} + sqrt({0}^2 + 4*({1})*{2})))", excess, km, s);
    return fmt::format("if({3} > 0, ({0})*{1}/(({2}) + {1})/{3}, 0)", k, free, km, s);
  }

  std::string file_;
  formula::StatementText text_;
  std::map<std::string, std::vector<Line>> blocks_;
  std::map<std::string, std::string> names_;  ///< of the text, by those of the network
  std::vector<std::string> species_, groups_;
  std::set<std::string> idle_;  ///< species that are in no reaction
};

}  // namespace

std::string text_of_network(const std::string& file, const std::string& text, double end) {
  return Network(file, text).text(end);
}

}  // namespace odeum::cases
