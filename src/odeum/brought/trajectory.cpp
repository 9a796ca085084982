// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/trajectory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <regex>

#include "odeum/core/numbers.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::brought {
namespace {

/// A name of a column without a unit or an argument behind it: x [m], x(t), y[0], Time.
std::string plain_name(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  static const std::regex index(R"(\[(\d+)\]|_(\d+)$|\((\d+)\))"), behind(R"(\s*[\[(/].*$)");
  name = std::regex_replace(name, index, "$1$2$3");
  name = std::regex_replace(name, behind, "");
  std::erase_if(name, [](char c) { return c == ' ' || c == '_'; });
  return name;
}

std::optional<std::size_t> column_named(const TableFile& file, const std::string& name) {
  for (std::size_t k = 0; k < file.columns.size(); ++k)
    if (file.columns[k].name == name) return k;
  for (std::size_t k = 0; k < file.columns.size(); ++k)
    if (!file.columns[k].name.empty() && plain_name(file.columns[k].name) == plain_name(name))
      return k;
  return {};
}

std::string text_of_columns(const TableFile& file) {
  if (file.columns.front().name.empty())
    return fmt::format("1 to {}, without names", file.columns.size());
  std::vector<std::string> names;
  for (std::size_t k = 0; k < file.columns.size(); ++k)
    names.push_back(file.columns[k].name.empty() ? std::to_string(k + 1)
                                                 : shown(file.columns[k].name));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Where the times and the components stand in a file.
struct Places {
  std::size_t time = 0;
  double time_factor = 1;
  struct Of {
    std::size_t component, column;
    double factor = 1;
  };
  std::vector<Of> components;
};

std::size_t column_said(const TableFile& file, const ColumnOf& said) {
  if (const auto found = column_named(file, said.column)) return *found;
  std::size_t number = 0;
  const char* const end = said.column.data() + said.column.size();
  if (std::from_chars(said.column.data(), end, number).ptr == end && number >= 1 &&
      number <= file.columns.size())
    return number - 1;
  throw InputError(fmt::format("--map: {} has no column {}; expected {}", file.path,
                               shown(said.column), text_of_columns(file)));
}

void place_said(const Case& c, const TableFile& file, const std::vector<ColumnOf>& said,
                Places& places) {
  const std::vector<std::string> names = component_names(c);
  for (const ColumnOf& each : said) {
    const std::size_t column = column_said(file, each);
    if (each.component == "t") {
      places.time = column;
      places.time_factor = each.factor;
      continue;
    }
    const auto at = std::ranges::find(names, each.component);
    if (at == names.end())
      throw InputError(fmt::format("--map: {} has no component {}, expected t or {}", c.id,
                                   shown(each.component), one_of(names, each.component)));
    places.components.push_back(
        {static_cast<std::size_t>(at - names.begin()), column, each.factor});
  }
}

Places places_of(const Case& c, const TableFile& file, const Reading& reading) {
  Places places;
  for (const char* name : {"t", "time", "times"})
    if (const auto found = column_named(file, name)) {
      places.time = *found;
      break;
    }
  place_said(c, file, reading.columns, places);
  if (!places.components.empty()) return places;
  const std::vector<std::string> names = component_names(c);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto found = column_named(file, names[i]); found && *found != places.time)
      places.components.push_back({i, *found});
  if (!places.components.empty()) return places;
  if (file.columns.size() != names.size() + 1)
    throw InputError(fmt::format(
        "{}: its columns are {}, and the components of {} are {}; expected their names, --map "
        "{}=COLUMN, or {} columns, the time first",
        file.path, text_of_columns(file), c.id, fmt::join(names, ", "), names.front(),
        names.size() + 1));
  for (std::size_t i = 0, k = 0; k < file.columns.size(); ++k)
    if (k != places.time) places.components.push_back({i++, k});
  return places;
}

/// The step that a file's name says, with where it stands there.
struct NamedStep {
  double step = 0, count = 0;  ///< a step, or how many there are
  std::size_t at = 0, length = 0;
};

NamedStep step_in_name(const std::string& stem) {
  static const std::regex length(
      R"((?:^|[_\-. (])(?:h|dt|step|deltat)[=_\-]?([0-9]*\.?[0-9]+(?:e[-+]?[0-9]+)?))",
      std::regex::icase);
  static const std::regex count(R"((?:^|[_\-. (])(?:n|steps|nsteps|nt)[=_\-]?([0-9]+))",
                                std::regex::icase);
  std::smatch match;
  NamedStep found;
  if (std::regex_search(stem, match, length))
    found.step = std::stod(match[1].str());
  else if (std::regex_search(stem, match, count))
    found.count = std::stod(match[1].str());
  else
    return found;
  found.at = static_cast<std::size_t>(match.position(0));
  found.length = static_cast<std::size_t>(match.length(0));
  return found;
}

/// The time between rows; 0: they are not equally far apart, within what is written of times.
double spacing_of(const Trajectory& run, double half_place) {
  const std::size_t last = run.rows() - 1;
  const double apart = (run.times[last] - run.times[0]) / static_cast<double>(last);
  const double allowed = 1e-9 * apart + 2.1 * half_place;
  for (std::size_t k = 1; k <= last; ++k)
    if (std::abs(run.times[k] - run.times[k - 1] - apart) > allowed) return 0;
  return apart;
}

void find_step(Trajectory& run, double given, double half_place) {
  const std::string stem = std::filesystem::path(run.file).stem().string();
  const NamedStep named = step_in_name(stem);
  run.series = stem;
  if (named.length > 0) run.series.erase(named.at, named.length);
  if (run.series.empty()) run.series = "files";
  const double apart = spacing_of(run, half_place), length = run.times.back() - run.times.front();
  run.apart = apart;
  // Times are written to fewer digits than they have.
  for (std::size_t k = 1; apart > 0 && k + 1 < run.rows(); ++k)
    run.times[k] = run.times[0] + static_cast<double>(k) * apart;
  const double said = given > 0 ? given : named.count > 0 ? length / named.count : named.step;
  run.step = said > 0 ? said : apart;
  if (!(said > 0) || apart == 0) return;
  const double parts = apart / said;
  // A last row that is nearer than the others, or a step that does not divide the time, is not
  // what a name says.
  constexpr double same = 0.02;
  if (std::round(parts) >= 1 && std::abs(parts - std::round(parts)) <= 1e-6 * parts) {
    run.steps_a_row = static_cast<std::size_t>(std::round(parts));
    return;
  }
  if (std::round(parts) >= 1 && std::abs(parts - std::round(parts)) <= same)
    run.steps_a_row = static_cast<std::size_t>(std::round(parts));
  run.remarks.push_back(
      fmt::format("the step is said to be {:.6g}, and its rows are {:.6g} apart", said, apart));
}

void fill(Trajectory& run, const Case& c, const TableFile& file, const Places& places) {
  const std::size_t n = c.y0.size(), rows = file.lines.size();
  const std::vector<double>& times = file.columns[places.time].values;
  for (std::size_t k = 0; k < rows; ++k) {
    const double t = times[k] * places.time_factor;
    if (!std::isfinite(t) || (!run.times.empty() && t < run.times.back()))
      throw InputError(file.path, {file.lines[k], 1},
                       fmt::format("got the time {} after {}, expected times that ascend", t,
                                   run.times.empty() ? c.t0 : run.times.back()));
    if (run.times.empty() || t > run.times.back()) {
      run.times.push_back(t);
      run.states.resize(run.states.size() + n, nan);
      run.half_places.resize(run.states.size(), nan);
    }  // else an event: the state after it stands for its time
    const std::size_t row = run.states.size() - n;
    for (const Places::Of& of : places.components) {
      const double value = file.columns[of.column].values[k];
      run.states[row + of.component] = of.factor * value;
      run.half_places[row + of.component] =
          std::abs(of.factor) * file.columns[of.column].half_place(value);
    }
  }
  if (run.times.size() < 2)
    throw InputError(file.path, {file.lines.front(), 1},
                     "got one time in all rows, expected times that ascend");
}

/// Times that begin elsewhere than the problem, with its initial state, are shifted.
void shift_to_start(Trajectory& run, const Case& c) {
  const double shift = c.t0 - run.times.front();
  if (shift == 0 || !run.is_whole(c)) return;
  for (std::size_t i = 0; i < c.y0.size(); ++i)
    if (std::abs(run.states[i] - c.y0[i]) > 2 * run.half_places[i] + 1e-12 * std::abs(c.y0[i]))
      return;
  for (double& t : run.times) t += shift;
  run.remarks.push_back(
      fmt::format("its times begin at {:.6g} with the initial state, and are shifted by {:.6g}",
                  c.t0 - shift, shift));
}

}  // namespace

ColumnOf column_of(const std::string& text) {
  const std::size_t equal = text.find('='), times = text.rfind('*');
  ColumnOf of;
  if (equal == std::string::npos || equal == 0 || equal + 1 == text.size())
    throw InputError(fmt::format(
        "--map: got {}, expected COMPONENT=COLUMN or COMPONENT=COLUMN*FACTOR", shown(text)));
  of.component = text.substr(0, equal);
  of.column = text.substr(equal + 1);
  if (times != std::string::npos && times > equal) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + times + 1, end, of.factor);
    if (error != std::errc() || rest != end || of.factor == 0 || !std::isfinite(of.factor))
      throw InputError(fmt::format("--map: got the factor {}, expected a number",
                                   shown(text.substr(times + 1))));
    of.column = text.substr(equal + 1, times - equal - 1);
  }
  return of;
}

Trajectory read_trajectory(const Case& c, const std::string& path, const Reading& reading,
                           double step) {
  const TableFile file = read_table(path);
  const Places places = places_of(c, file, reading);
  Trajectory run;
  run.file = path;
  fill(run, c, file, places);
  for (const Places::Of& of : places.components) run.components.push_back(of.component);
  std::ranges::sort(run.components);
  run.components.erase(std::unique(run.components.begin(), run.components.end()),
                       run.components.end());
  if (!run.is_whole(c)) {
    std::vector<std::string> names;
    for (const std::size_t i : run.components) names.push_back(component_names(c)[i]);
    run.remarks.push_back(
        fmt::format("it has {} of the components: {}", names.size(), fmt::join(names, ", ")));
  }
  shift_to_start(run, c);
  const Column& times = file.columns[places.time];
  find_step(run, step, std::abs(places.time_factor) * times.half_place(run.times.back()));
  return run;
}

}  // namespace odeum::brought
