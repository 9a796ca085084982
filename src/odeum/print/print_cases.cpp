// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/print/print_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "odeum/formula/printer.hpp"
#include "odeum/print/case_keys.hpp"
#include "odeum/print/print_problem.hpp"

namespace odeum::print {
namespace {

using namespace formula;
using Kind = Member::Kind;

constexpr std::size_t most_printed_states = 40;  // their Jacobian is dense

std::string raw_text(const std::string& text) { return "R\"odeum(" + text + ")odeum\""; }

class CasesPrinter : CaseKeys {
 public:
  CasesPrinter(const std::string& file, const std::string& text)
      : CaseKeys(file, text),
        stem_(std::filesystem::path(file).stem().string()),
        problem_(read_problem(file, text, {}, Parameters::names)),
        analysis_(analyse(problem_)) {
    names_.owner = "problem.";
    for (const Definition& each : problem_.graph.definitions())
      if (each.op == Op::constant) {
        scope_.names[each.name] = each.id;
        parameters_.push_back(each);
      }
    if (problem_.kinetic_energy != no_node || problem_.states.size() > most_printed_states)
      fail({}, "cases: got {} states{}, expected at most {} and no mass matrix: such cases are C++",
           problem_.states.size(), problem_.kinetic_energy != no_node ? ", mass" : "",
           most_printed_states);
    read_offers();
  }

  Printed print() {
    std::string calls;
    for (const Item& item : cases_) {
      enter(item);
      print_case(item);
      calls += fmt::format("{}{}", calls.empty() ? "" : ",\n          ", call_);
    }
    return {
        print_problem(stem_, problem_, analysis_, offers_),
        fmt::format("// Printed from cases/{0}.yaml.\n#include \"problems/{0}.hpp\"\n\n"
                    "#include <fmt/format.h>\n\n"
                    "#include \"odeum/cases/parameters.hpp\"\n"
                    "#include \"odeum/cases/reference.hpp\"\n"
                    "#include \"odeum/cases/stage.hpp\"\n\nnamespace odeum::cases {{\n"
                    "namespace {{\n{1}}}\nstd::vector<Case> {0}() {{\n  return {{{2}}};\n}}\n}}\n",
                    stem_, text_, calls)};
  }

 private:
  template <class... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    text_ += "  " + fmt::format(format, std::forward<Values>(values)...) + "\n";
  }

  /// An expression of the parameters, as a node.
  Id constant(const YamlNode& value, const std::string& key) {
    try {
      return parse_expression(scalar(value, key), scope_, problem_.graph);
    } catch (const ExpressionError& error) {
      fail(value.place, "{}: {}", key, error.what());
    }
  }
  double number(const YamlNode& value, const std::string& key) {
    const Id id = constant(value, key);
    if (!problem_.graph.is_constant(id))
      fail(value.place, "{}: not a constant; got t in it, expected a number", key);
    return static_cast<double>(problem_.graph[id].value);
  }

  void read_offers() {
    const YamlNode* const value = find("offers");
    if (!value) return;
    offers_.jacobian = offers_.second_order = offers_.series = false;
    const std::pair<const char*, bool*> known[] = {{"jacobian", &offers_.jacobian},
                                                   {"second_order", &offers_.second_order},
                                                   {"series", &offers_.series}};
    for (const std::string& name : texts(value, "offers")) {
      const auto* const at = std::find_if(std::begin(known), std::end(known),
                                          [&](const auto& each) { return each.first == name; });
      if (at == std::end(known))
        fail(value->place, "offers: got {}, expected jacobian, second_order or series", name);
      *at->second = true;
    }
  }

  void print_case(const Item& item) {
    const std::string& id = item.key;
    text_ += fmt::format("Case make_{}([[maybe_unused]] const Values& values) {{\n", id);
    print_values(id);
    line("Case c;\n  c.id = \"{}\";\n  c.t0 = {};", id, static_cast<double>(problem_.t0));
    print_tolerance();
    for (const Member& each : members)
      if (const YamlNode* const value = find(each.key)) print_member(each, *value);
    if (!find("title")) line("c.title = {};", raw_text(problem_.name.empty() ? id : problem_.name));
    if (!find("equation")) line("c.equation = {};", raw_text(problem_.equations_text));
    text_ += suffix_;
    if (!find("stops")) line("c.stops = {{{}}};", fmt::join(problem_.stops, ", "));
    print_tags();
    line("c.components = {{\"{}\"}};", fmt::join(problem_.states, "\", \""));
    std::vector<std::string> start;
    for (const Id y : problem_.start) start.push_back(names_.name(y, in_double));
    line("c.y0 = {{{}}};", fmt::join(start, ", "));
    if (!problem_.scale.empty()) line("c.scale = {{{}}};", fmt::join(problem_.scale, ", "));
    print_truth(id, item.key_place);
    print_invariants();
    line("set_stage(c, problem);\n  return c;\n}}");
  }

  /// The problem with the values of the parameters that a user may change, and the call that makes
  /// the case of them.
  void print_values(const std::string& id) {
    const std::vector<Item> meanings = mapping("meanings"), set = mapping("set");
    std::vector<std::string> offered = texts(find("parameters"), "parameters");
    if (!find("parameters"))
      for (const Item& each : meanings) offered.push_back(each.key);
    std::vector<std::string> fields, rows(offered.size());
    std::vector<double> usual(offered.size());
    for (const Definition& each : parameters_) {
      const auto given = of_name(set, each.name), meaning = of_name(meanings, each.name);
      const double value = given ? number(*given->value, "set: " + each.name)
                                 : static_cast<double>(problem_.graph[each.id].value);
      const auto at = std::find(offered.begin(), offered.end(), each.name) - offered.begin();
      if (static_cast<std::size_t>(at) < offered.size()) {
        fields.push_back(fmt::format(".{} = values[{}]", each.name, at));
        usual[static_cast<std::size_t>(at)] = value;
        rows[static_cast<std::size_t>(at)] =
            fmt::format("{{\"{}\", {}, {}}}", each.name, value,
                        raw_text(meaning ? scalar(*meaning->value, each.name) : ""));
      } else if (given) {
        fields.push_back(fmt::format(".{} = {}", each.name, value));
      }
    }
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (rows[k].empty()) fail({}, "{}: no parameter; got {}, expected one", id, offered[k]);
    line("const {} problem{{{}}};", type_name(stem_), fmt::join(fields, ", "));
    for (const char* const sign : {"positive", "not_negative"})
      for (const YamlNode* each : entries(find(sign))) {
        offers_.members.push_back(constant(*each, sign));
        line("require_{}({}, {});", sign, raw_text(scalar(*each, sign)),
             names_.name(offers_.members.back(), in_double));
      }
    usual_ = fmt::format("{}", fmt::join(usual, ", "));
    const bool tabled = find("reference") && problem_.exact.empty();
    suffix_.clear();
    for (std::size_t k = 0; !tabled && k < offered.size(); ++k)
      suffix_ += fmt::format("  c.equation += fmt::format(\"{} {} = {{}}\", values[{}]);\n",
                             k ? "," : ";", offered[k], k);
    call_ = offered.empty() ? fmt::format("make_{}({{}})", id)
                            : fmt::format("with_{}parameters({{{}}}, make_{})",
                                          tabled ? "tabled_" : "", fmt::join(rows, ", "), id);
  }

  void print_member(const Member& each, const YamlNode& value) {
    if (each.kind == Kind::text)
      return line("c.{} = {};", each.member, raw_text(scalar(value, each.key)));
    std::vector<double> all;
    for (const YamlNode* entry : entries(&value)) all.push_back(number(*entry, each.key));
    if (each.kind == Kind::thresholds)
      return line("c.tolerance = Tolerance::of_thresholds(c.tolerance.relative, {{{}}});",
                  fmt::join(all, ", "));
    if (each.kind == Kind::numbers)
      return line("c.{} = {{{}}};", each.member, fmt::join(all, ", "));
    if (all.size() != 1) fail(value.place, "{}: got a list, expected a number", each.key);
    line("c.{} = {};", each.member, all.front());
  }

  void print_tags() {
    const Structure& s = analysis_.structure;
    std::vector<std::string> tags{s.linear ? "linear" : "nonlinear",
                                  s.autonomous ? "autonomous" : "non_autonomous"};
    if (offers_.second_order && s.second_order) {
      tags.emplace_back("second_order");
      if (!s.velocity_dependent) tags.emplace_back("separable");
    }
    for (const auto* list : {&common_, &own_})
      if (const Item* const given = of_name(*list, "tags"))
        for (std::string& tag : texts(given->value, "tags")) tags.push_back(std::move(tag));
    line("c.tags = {{\"{}\"}};", fmt::join(tags, "\", \""));
  }

  void print_tolerance() {
    const Tolerance& given = problem_.tolerance;
    if (given.relative > 0)
      line("c.tolerance = Tolerance({}, std::vector<double>{{{}}});", given.relative,
           fmt::join(given.absolutes(), ", "));
  }

  void print_truth(const std::string& id, Place place) {
    const std::vector<std::string> files = texts(find("reference"), "reference");
    const YamlNode* const given = find("floor");
    const double floor = given ? number(*given, "floor") : 0;
    if (files.empty() && problem_.exact.empty())
      fail(place, "{}: no truth; got none, expected `reference` and `floor`, or `exact`", id);
    if (!problem_.exact.empty()) {
      line(
          "c.truth.source = \"closed form\";\n"
          "  c.truth.at = [problem](double t, double* y) {{\n    long double exact[{}];\n"
          "    problem.exact<long double>(t, exact);\n"
          "    for (const long double x : exact) *y++ = static_cast<double>(x);\n"
          "    return true;\n  }};",
          problem_.states.size());
    }
    if (files.empty()) return line("c.truth.floor = {};", floor);
    if (!(floor > 0)) fail(place, "{}: floor: got none, expected the error of the reference", id);
    line("{}c.truth = reference_truth(\"{}\", {});",
         problem_.exact.empty() ? "" : fmt::format("if (values == Values{{{}}}) ", usual_),
         files.front(), floor);
    for (std::size_t k = 1; k < files.size(); ++k)
      line(
          "c.truth.at = [before = c.truth.at, more = reference_truth(\"{}\", {}).at](\n"
          "      double t, double* y) {{ return before(t, y) || more(t, y); }};",
          files[k], floor);
  }

  void print_invariants() {
    const std::vector<std::string> names = texts(find("invariants"), "invariants");
    for (const Kept& kept : problem_.invariants) {
      if (is_energy(kept.name)) continue;
      if (find("invariants") && std::find(names.begin(), names.end(), kept.name) == names.end())
        continue;
      line(
          "c.invariants.push_back({{\"{0}\", [problem](const double* y) {{ return "
          "problem.kept_{0}(y); }}}});",
          kept.name);
    }
  }

  std::string stem_;
  Problem problem_;
  Analysis analysis_;
  Offers offers_;
  Printer names_{problem_.graph};
  Scope scope_;
  std::vector<Definition> parameters_;
  std::string text_, call_;
  std::string usual_,
      suffix_;  ///< values of the parameters, and code that adds them to the equation
};

}  // namespace

Printed print_cases(const std::string& file, const std::string& text) {
  return CasesPrinter(file, text).print();
}

}  // namespace odeum::print
