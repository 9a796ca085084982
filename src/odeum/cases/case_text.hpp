// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "odeum/cases/span.hpp"
#include "odeum/formula/case_section.hpp"
#include "odeum/formula/problem.hpp"
#include "odeum/problem/ode_view.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The case `id` of a problem file. `set` replaces parameters that the case offers.
struct TextSource {
  std::string file, text, id;
  formula::Overrides set;
  Span span = {};
};

/// One case of a problem file while it is read: its keys, the problem with the case's parameters,
/// and numbers that are given as expressions of these.
class CaseText : protected formula::CaseSection {
 public:
  /// Throws InputError, and std::invalid_argument for a parameter that is not offered.
  explicit CaseText(const TextSource& source);

  /// The start and the end, for which no truth is computed.
  std::pair<double, double> span() { return {static_cast<double>(problem_.t0), stops().back()}; }
  /// The equations as a struct `Problem` of plain C++17, see print/print_problem.hpp, with these
  /// values of the parameters. Throws InputError for what is not printed: a mass matrix, and more
  /// than 200 states.
  std::string as_struct(bool series) const;
  formula::Problem& problem() { return problem_; }

 protected:
  /// The number, or the entries of the list, of a key; none where it is not given.
  std::vector<double> numbers(const std::string& key);
  /// Numbers that ascend from the case's start; none without the key.
  std::vector<double> times(const std::string& key);
  template <class Number>
  void take_number(const std::string& key, Number& value) {
    const std::vector<double> given = numbers(key);
    if (given.size() > 1) fail(find(key)->place, "{}: got a list, expected a number", key);
    if (given.empty()) return;
    constexpr bool whole = std::is_integral_v<Number>;
    const double number = given.front();
    if (!(number >= (whole ? 1 : 0) && number <= 1e15) || (whole && number != std::floor(number)))
      fail(find(key)->place, "{}: got {}, expected a{} number from {} to 1e15", key, number,
           whole ? " whole" : "", whole ? 1 : 0);
    value = static_cast<Number>(number);
  }
  /// The stops of the case, else of the problem; they ascend from its start.
  std::vector<double> stops();
  /// One positive number for each state.
  std::vector<double> thresholds();
  /// What the case says of itself, see `nature`.
  Nature nature() const;
  /// Throws std::invalid_argument where an expression that has to be positive is not.
  void require_signs();
  /// Whether the parameters are those of the file.
  bool is_usual() const;
  /// Gives the parameters offered these values; one that stays `as_read` keeps all digits.
  void place(const std::vector<double>& values, const std::map<std::string, long double>& as_read);

  /// The problem with parameters that keep their names.
  formula::Problem with_names() const;

  TextSource source_;
  formula::Problem problem_;
  formula::Overrides values_;         ///< with which it was read
  std::vector<std::string> offered_;  ///< parameters that a user may change

 private:
  double number(const YamlNode& value, const std::string& key);
  /// The values of `set` below the case.
  formula::Overrides own_values();
  void read_offered();
  void take_values();

  std::map<std::string, long double> usual_;
};

/// A view without what the file does not offer.
OdeView offered(OdeView view, const formula::Offers& offers);

}  // namespace odeum::cases
