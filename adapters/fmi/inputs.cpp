// SPDX-License-Identifier: BSD-3-Clause
#include "fmi/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "odeum/core/numbers.hpp"
#include "odeum/input/csv_text.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::adapters::fmi {
namespace {

constexpr std::size_t most_input_bytes = 256'000'000;

}  // namespace

Inputs::Inputs(const std::string& file, const Description& description) : file_(file) {
  const std::string text = read_text_file(file, "inputs", most_input_bytes);
  input::Lines lines(text);
  for (bool header = true; lines.next(); header = false)
    header ? read_header(lines.line(), lines.number(), description)
           : read_row(lines.line(), lines.number());
  if (times_.empty())
    throw InputError(file_, {std::max<std::size_t>(lines.number(), 1), 1},
                     "inputs: got no row, expected one after the names");
  find_changes();
}

void Inputs::read_header(std::string_view line, std::size_t number,
                         const Description& description) {
  separator_ = input::separator_of(line);
  const std::vector<input::Cell> names = input::cells_of(line, separator_);
  if (names.front().text != "time")
    throw InputError(file_, {number, 1},
                     fmt::format("inputs: the first column; got {}, expected time",
                                 shown(std::string(names.front().text))));
  std::vector<std::string> inputs;
  for (const Variable& v : description.variables)
    if (v.is_input && !v.is_array) inputs.push_back(v.name);
  std::set<std::string> before;
  for (std::size_t k = 1; k < names.size(); ++k) {
    const std::string name(names[k].text);
    const std::size_t column = names[k].column;
    const auto variable = std::ranges::find(description.variables, name, &Variable::name);
    if (variable == description.variables.end() || !variable->is_input || variable->is_array)
      throw InputError(
          file_, {number, column},
          fmt::format("inputs: the model has no such input; got {}, expected {}", shown(name),
                      inputs.empty() ? "no column, since it has none" : one_of(inputs, name)));
    if (!before.insert(name).second)
      throw InputError(file_, {number, column},
                       fmt::format("inputs: two columns are {}", shown(name)));
    const bool linear = variable->is_real() && !variable->is_discrete;
    columns_.push_back({*variable, linear, {}, {}});
    if (!with_value({&*variable, linear || variable->is_real() ? "0" : "1"}, description.version,
                    [](auto) {}))
      throw InputError(file_, {number, column},
                       fmt::format("inputs: {}: a {} cannot be set", name, variable->type));
  }
}

void Inputs::read_row(std::string_view line, std::size_t number) {
  const std::vector<input::Cell> row = input::cells_of(line, separator_);
  if (row.size() != columns_.size() + 1)
    throw InputError(file_, {number, 1},
                     fmt::format("inputs: got {} fields, expected {} as in the first line",
                                 row.size(), columns_.size() + 1));
  const auto with_place = [&](std::size_t k, const auto& read) {
    try {
      read();
    } catch (const LoadError& error) {
      throw InputError(file_, {number, row[k].column}, error.what());
    }
  };
  const auto finite = [](const Setting& setting) {
    const double value = setting.real();
    if (!std::isfinite(value)) setting.fail("a finite number");
    return value;
  };
  Variable time;
  time.name = "time";
  with_place(0, [&] {
    const Setting setting{&time, std::string(row[0].text)};
    const double t = finite(setting);
    if (!times_.empty() && t < times_.back())
      setting.fail(fmt::format("a time from {} on, that of the row before", times_.back()));
    if (times_.size() > 1 && t == times_[times_.size() - 2])
      setting.fail("two rows of one time at most, the values before and after a jump");
    times_.push_back(t);
  });
  for (std::size_t k = 0; k < columns_.size(); ++k)
    with_place(k + 1, [&] {
      Column& column = columns_[k];
      const Setting setting{&column.variable, std::string(row[k + 1].text)};
      if (column.variable.is_real()) {
        const double value = finite(setting);
        if (column.linear) column.values.push_back(value);
      } else {
        with_value(setting, column.variable.type == "Integer" ? 2 : 3, [](auto) {});
      }
      column.cells.push_back(setting.text);
    });
}

void Inputs::find_changes() {
  for (std::size_t k = 1; k < times_.size(); ++k) {
    const bool twice = times_[k] == times_[k - 1];
    if (std::ranges::any_of(columns_, [&](const Column& c) {
          return (!c.linear || twice) && c.cells[k] != c.cells[k - 1];
        }))
      jumps_.push_back(times_[k]);
    if (std::ranges::any_of(columns_, &Column::linear)) {
      if (k == 1) kinks_.push_back({times_[0], times_[0], times_[0]});
      if (!twice) kinks_.push_back({times_[k], times_[k], times_[k]});
    }
  }
  jumps_.erase(std::unique(jumps_.begin(), jumps_.end()), jumps_.end());
}

double Inputs::at(const Column& column, double t, double passed) const {
  const auto next =
      t <= passed ? std::ranges::upper_bound(times_, t) : std::ranges::lower_bound(times_, t);
  const auto k = static_cast<std::size_t>(next - times_.begin());
  if (k == 0) return column.values.front();
  if (k == times_.size()) return column.values.back();
  const double share = (t - times_[k - 1]) / (times_[k] - times_[k - 1]);
  return column.values[k - 1] + share * (column.values[k] - column.values[k - 1]);
}

const std::string& Inputs::cell(const Column& column, double t) const {
  const auto next = std::ranges::upper_bound(times_, t);
  return column
      .cells[next == times_.begin() ? 0 : static_cast<std::size_t>(next - times_.begin()) - 1];
}

std::string Inputs::start(const Column& column, double t) const {
  return column.linear ? fmt::format("{}", at(column, t, t)) : cell(column, t);
}

double Inputs::next_jump(double t) const {
  const auto next = std::ranges::upper_bound(jumps_, t);
  return next == jumps_.end() ? std::numeric_limits<double>::infinity() : *next;
}

std::pair<double, double> Inputs::around(double t) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto next = std::ranges::upper_bound(times_, t);
  return {next == times_.begin() ? -infinity : *(next - 1),
          next == times_.end() ? infinity : *next};
}

std::string Inputs::words() const {
  std::string linear, held;
  for (const Column& column : columns_) {
    std::string& names = column.linear ? linear : held;
    names += (names.empty() ? "" : ", ") + column.variable.name;
  }
  return fmt::format(
      "{}{}{}{} from {}, t = {} to {}", linear, linear.empty() ? "" : " piecewise linear",
      linear.empty() || held.empty() ? "" : "; ",
      held + (held.empty() ? "" : " held from row to row"), file_, times_.front(), times_.back());
}

}  // namespace odeum::adapters::fmi
