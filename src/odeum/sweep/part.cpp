// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace odeum::sweep {
namespace {

[[noreturn]] void lose(const std::string& of, const std::string& what) {
  throw study::ResultLost(
      fmt::format("the result of {} in the shards is damaged: {} is not theirs", of, what));
}

template <class Number>
Number number_of(std::string_view text, const std::string& of) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) lose(of, "a number");
  return number;
}

/// Takes the text after the last separator off.
std::string_view take_last(std::string_view& text, char separator) {
  const std::size_t at = std::min(text.rfind(separator), text.size());
  const std::string_view last = text.substr(std::min(at + 1, text.size()));
  text = text.substr(0, at);
  return last;
}

/// The fields of a row, of which those in quotes may have commas.
std::size_t fields_in(std::string_view line) {
  std::size_t count = 1;
  bool quoted = false;
  for (const char c : line) {
    quoted = quoted != (c == '"');
    count += !quoted && c == ',';
  }
  return count;
}

/// Whether a row is that of the member: its number, its parameters behind the solver, and as many
/// fields as it has.
bool is_of(std::string_view line, const Plan& plan, std::uint64_t member) {
  const std::size_t names = plan.members.names().size(), others = 6;  // schema to rhs_evaluations
  if (fields_in(line) != names + plan.quantities.size() + others) return false;
  const std::string number = fmt::format("{},{},", record::csv_schema, member);
  if (!line.starts_with(number)) return false;
  line.remove_prefix(std::min(line.find(',', number.size()), line.size()));
  std::string values;
  for (const double value : plan.members.values(member))
    values += ',' + record::format_number(value);
  return line.starts_with(values + ',');
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

Part part_of(const std::string& text, const Plan& plan, std::uint64_t first, std::uint64_t last,
             double* results) {
  const std::string of = fmt::format("members {} to {}", first, last);
  Part part;
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  std::string_view counts = line;
  part.evaluations = number_of<std::uint64_t>(take_last(counts, ','), of);
  part.solved = number_of<std::uint64_t>(counts, of);
  std::uint64_t told = plan.study ? last - first : part.solved;
  while (std::getline(in, line) && !line.empty()) {
    const std::size_t comma = line.find(','), second = line.find(',', comma + 1),
                      third = line.find(',', second + 1);
    if (third == std::string::npos) lose(of, "an ending");
    const std::string_view all = line;
    const Ending ending{number_of<std::uint64_t>(all.substr(comma + 1, second - comma - 1), of),
                        number_of<std::uint64_t>(all.substr(second + 1, third - second - 1), of),
                        record::text_of_field(line.substr(third + 1))};
    if (ending.first < first || ending.first >= last) lose(of, "the members that ended");
    if (!plan.study) told += ending.count;
    add_ending(part.endings, line.substr(0, comma), ending);
  }
  if (told != last - first || part.solved > last - first) lose(of, "the number of members");
  const std::size_t quantities = plan.quantities.size();
  std::uint64_t member = first;
  for (; member < last && std::getline(in, line); ++member) {
    if (!is_of(line, plan, member)) lose(of, fmt::format("the row of member {}", member));
    part.lines += line + '\n';
    std::string_view rest = line;
    take_last(rest, ',');  // evaluations
    double* const own = results + (member - first) * quantities;
    for (std::size_t q = quantities; q-- > 0;) own[q] = number_of<double>(take_last(rest, ','), of);
  }
  if (member != last || std::getline(in, line)) lose(of, "the number of rows");
  return part;
}

}  // namespace odeum::sweep
