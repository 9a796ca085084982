// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/members.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "odeum/core/numbers.hpp"
#include "odeum/input/csv_text.hpp"

namespace odeum::sweep {
namespace {

template <class... Arguments>
[[noreturn]] void fail(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  throw std::invalid_argument(fmt::format(format, std::forward<Arguments>(arguments)...));
}

bool read(std::string_view text, double& number) {
  const std::optional<double> read = input::number_in(input::trimmed(text));
  number = read.value_or(nan);
  return std::isfinite(number);
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(at, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

// Reads A..B:N and A..B:logN; false for any other text.
bool read_range(const std::string& text, Axis& axis) {
  const std::size_t dots = text.find(".."), colon = text.find(':');
  if (dots == std::string::npos || colon == std::string::npos || colon < dots) return false;
  double from = 0, to = 0, count = 0;
  const bool log = text.compare(colon + 1, 3, "log") == 0;
  if (!read(text.substr(0, dots), from) || !read(text.substr(dots + 2, colon - dots - 2), to) ||
      !read(text.substr(colon + (log ? 4 : 1)), count))
    return false;
  if (!(from < to)) fail("the range {} is empty; expected A..B:N with A below B", text);
  if (count != std::floor(count) || count < 2 || count > static_cast<double>(most_members))
    fail("got {} values, expected a whole number from 2 to {}", count, most_members);
  if (log && !(from > 0)) fail("the range {} has no logarithm; expected A above 0", text);
  const auto n = static_cast<std::size_t>(count);
  for (std::size_t k = 0; k < n; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(n - 1);
    axis.values.push_back(k + 1 == n ? to
                          : log      ? from * std::pow(to / from, part)
                                     : from + (to - from) * part);
  }
  return true;
}

// name(A,B)
bool read_distribution(const std::string& text, Axis& axis) {
  const std::size_t open = text.find('(');
  if (open == std::string::npos || !text.ends_with(')')) return false;
  const std::string name = text.substr(0, open);
  const auto numbers = split(text.substr(open + 1, text.size() - open - 2), ',');
  if (numbers.size() != 2 || !read(numbers[0], axis.first) || !read(numbers[1], axis.second))
    return false;
  using Kind = Axis::Kind;
  if (name == "uniform" || name == "loguniform") {
    axis.kind = name == "uniform" ? Kind::uniform : Kind::log_uniform;
    if (!(axis.first < axis.second)) fail("{} is empty; expected A below B", text);
    if (axis.kind == Kind::log_uniform && !(axis.first > 0)) fail("{}: expected A above 0", text);
    return true;
  }
  axis.kind = Kind::normal;
  if (name == "normal" && !(axis.second > 0)) fail("{}: expected a positive deviation", text);
  return name == "normal";
}

// The output of SplitMix64 (Steele, Lea, Flood 2014) for a key.
std::uint64_t mixed(std::uint64_t key) {
  key += 0x9e3779b97f4a7c15U;
  key = (key ^ key >> 30U) * 0xbf58476d1ce4e5b9U;
  key = (key ^ key >> 27U) * 0x94d049bb133111ebU;
  return key ^ key >> 31U;
}

// A number in (0, 1), the same for the same key.
double uniform(std::uint64_t key) {
  return (static_cast<double>(mixed(key) >> 11U) + 0.5) * 0x1p-53;
}

}  // namespace

double Axis::drawn(double u, double v) const {
  switch (kind) {
    case Kind::uniform:
      return first + (second - first) * u;
    case Kind::log_uniform:
      return first * std::pow(second / first, u);
    default:  // Box and Muller
      return first + second * std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }
}

Axis axis_of(const std::string& text) {
  const std::size_t at = text.find_first_of("=~");
  const char* const expected =
      "expected NAME=A..B:N, NAME=A..B:logN, NAME=A,B,..., or NAME~uniform(A,B), loguniform(A,B) "
      "or normal(MEAN,DEVIATION)";
  if (at == std::string::npos || at == 0) fail("got {}, {}", text, expected);
  Axis axis{.name = text.substr(0, at)};
  const std::string values = text.substr(at + 1);
  if (text[at] == '~') {
    if (!read_distribution(values, axis)) fail("got {}, {}", text, expected);
    return axis;
  }
  if (read_range(values, axis)) return axis;
  for (const std::string& part : split(values, ',')) {
    double number = 0;
    if (!read(part, number)) fail("got {}, {}", text, expected);
    axis.values.push_back(number);
  }
  return axis;
}

Members::Members(std::vector<Axis> axes, std::uint64_t sample, std::uint64_t seed)
    : axes_(std::move(axes)), size_(1), seed_(seed) {
  bool draws = false;
  const auto multiply = [&](std::uint64_t by) {
    if (by > most_members / size_)
      fail("the sweep has more than {} members; expected fewer", most_members);
    size_ *= by;
  };
  for (const Axis& axis : axes_) {
    names_.push_back(axis.name);
    draws = draws || axis.kind != Axis::Kind::grid;
    if (axis.kind == Axis::Kind::grid) multiply(axis.values.size());
  }
  require_names();
  if (draws != (sample > 0))
    fail("{}", draws ? "a distribution is drawn from: --sample N is missing"
                     : "--sample: no parameter has a distribution; expected --over NAME~...");
  if (draws) multiply(sample_ = sample);
}

void Members::require_names() const {
  std::set<std::string> seen;
  for (const std::string& name : names_)
    if (!seen.insert(name).second) fail("{} is given twice", name);
}

Members Members::of_csv(const std::string& name, const std::string& text) {
  Members members;
  char separator = ',';
  for (input::Lines lines(text); lines.next();) {
    if (members.names_.empty()) {
      separator = input::separator_of(lines.line());
      for (const input::Cell& cell : input::cells_of(lines.line(), separator))
        members.names_.emplace_back(cell.text);
      members.require_names();
      continue;
    }
    const std::vector<input::Cell> cells = input::cells_of(lines.line(), separator);
    if (cells.size() != members.names_.size())
      fail("{}:{}: got {} cells, expected {}, one for each name of the first line", name,
           lines.number(), cells.size(), members.names_.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double value = input::number_in(cells[k].text).value_or(nan);
      if (!std::isfinite(value))
        fail("{}:{}: {}: got {}, expected a finite number", name, lines.number(), members.names_[k],
             cells[k].text.empty() ? "nothing" : cells[k].text);
      members.table_.push_back(value);
    }
    if (++members.size_ > most_members)
      fail("{}: more than {} members; expected fewer", name, most_members);
  }
  if (members.size_ == 0)
    fail("{}: no members; expected a line of names, and lines of numbers", name);
  return members;
}

std::vector<double> Members::values(std::uint64_t member) const {
  const std::size_t n = names_.size();
  if (!table_.empty()) {
    const double* const row = table_.data() + member * n;
    return {row, row + n};
  }
  std::vector<double> values(n);
  const std::uint64_t draw = member % sample_;
  std::uint64_t rest = member / sample_;
  for (std::size_t k = n; k-- > 0;) {
    const Axis& axis = axes_[k];
    if (axis.kind == Axis::Kind::grid) {
      values[k] = axis.values[rest % axis.values.size()];
      rest /= axis.values.size();
    } else {
      // The draw is mixed before the axis is added: no two of (seed, draw, axis) share a key.
      const std::uint64_t key = mixed(mixed(seed_) + draw) + 2 * k;
      values[k] = axis.drawn(uniform(key), uniform(key + 1));
    }
  }
  return values;
}

}  // namespace odeum::sweep
