// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/part.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>
#include <stdexcept>

namespace odeum::sweep {
namespace {

template <class Number>
Number number_of(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::runtime_error(fmt::format("a kept part of a sweep has no number in {}", text));
  return number;
}

/// Takes the text after the last separator off.
std::string_view take_last(std::string_view& text, char separator) {
  const std::size_t at = text.rfind(separator);
  const std::string_view last = text.substr(at + 1);
  text = text.substr(0, at);
  return last;
}

}  // namespace

void add_ending(std::map<std::string, Ending>& endings, const std::string& status,
                const Ending& more) {
  Ending& ending = endings[status];
  if (ending.count == 0 || more.first < ending.first)
    ending = {ending.count, more.first, more.detail};
  ending.count += more.count;
}

std::string text_of(const Part& part) {
  std::string text = fmt::format("{},{}\n", part.solved, part.evaluations);
  for (const auto& [status, ending] : part.endings)
    text += fmt::format("{},{},{},{}\n", status, ending.count, ending.first,
                        record::format_text(ending.detail));
  return text + '\n' + part.lines;
}

Part part_of(const std::string& text, std::size_t quantities, double* results) {
  Part part;
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  const std::size_t comma = line.find(',');
  part.solved = number_of<std::uint64_t>(std::string_view(line).substr(0, comma));
  part.evaluations = number_of<std::uint64_t>(std::string_view(line).substr(comma + 1));
  while (std::getline(in, line) && !line.empty()) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1),
                      third = line.find(',', second + 1);
    const std::string_view all = line;
    add_ending(part.endings, line.substr(0, first),
               {number_of<std::uint64_t>(all.substr(first + 1, second - first - 1)),
                number_of<std::uint64_t>(all.substr(second + 1, third - second - 1)),
                record::text_of_field(line.substr(third + 1))});
  }
  while (std::getline(in, line)) {
    part.lines += line + '\n';
    std::string_view rest = line;
    take_last(rest, ',');  // evaluations
    for (std::size_t q = quantities; q-- > 0;) results[q] = number_of<double>(take_last(rest, ','));
    results += quantities;
  }
  return part;
}

}  // namespace odeum::sweep
