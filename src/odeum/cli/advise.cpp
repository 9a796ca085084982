// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "odeum/advise/answer.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/studies/convergence/settings.hpp"
#include "odeum/truth/computed_truth.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::cli {
namespace {

struct AdviseOptions {
  std::string what, format = "table", time, frame, out;
  bool code = false;
  std::vector<std::string> vary;
  std::optional<double> until;
  advise::Wishes wishes;
  ProblemOptions problems;
};

void read_times(AdviseOptions& options) {
  const bool error = options.wishes.error != 0, time = !options.time.empty();
  if (error == time) throw UsageError("advise needs --error or --time, and not both");
  if (error) require_positive("--error", options.wishes.error);
  if (options.wishes.energy != 0) {
    if (!error) throw UsageError("--energy: an energy needs --error");
    require_positive("--energy", options.wishes.energy);
  }
  if (options.wishes.horizon != 0) {
    if (options.wishes.energy == 0) throw UsageError("--horizon: a horizon needs --energy");
    require_positive("--horizon", options.wishes.horizon);
  }
  if (time)
    options.wishes.time_ns = number_of(
        "--time", options.time, {{"", 1e9}, {"s", 1e9}, {"ms", 1e6}, {"us", 1e3}, {"ns", 1}});
  if (!options.frame.empty()) options.wishes.frame = number_of("--frame", options.frame, {{"", 1}});
  // The error is to hold at each frame.
  if (error) options.problems.span.frame = options.wishes.frame;
  if (options.until) options.problems.span.until = *options.until;
}

/// The cases of a box: its middle, then its corners, of more than three parameters eight of them in
/// which each one and each pair take both ends equally often.
struct Box {
  std::vector<Case> cases;
  std::vector<std::vector<std::string>> points;  ///< by case the values of --set
  std::vector<const Case*> pointers() const {
    std::vector<const Case*> all;
    for (const Case& c : cases) all.push_back(&c);
    return all;
  }
};

struct Range {
  std::string name;
  double from, to;
  double at(int side) const {  // -1, 0, 1
    if (side != 0) return side < 0 ? from : to;
    return from > 0 && to >= 10 * from ? std::sqrt(from * to) : 0.5 * (from + to);
  }
};

/// Reads `k=0.5..2`. Throws UsageError.
Range range_of(const std::string& text) {
  const std::size_t equals = text.find('='), dots = text.find("..");
  Range range{text.substr(0, equals), 0, 0};
  const auto read = [&](std::size_t from, std::size_t to, double& number) {
    const char *first = text.data() + from, *last = text.data() + to;
    const auto [stop, error] = std::from_chars(first, last, number);
    return error == std::errc{} && stop == last && std::isfinite(number);
  };
  if (equals == std::string::npos || dots == std::string::npos || dots < equals ||
      !read(equals + 1, dots, range.from) || !read(dots + 2, text.size(), range.to) ||
      !(range.from < range.to))
    throw UsageError("--vary: got {}, expected NAME=FROM..TO with FROM below TO", shown(text));
  return range;
}

Box box_of(const Case& c, const std::vector<Range>& ranges, const TruthBounds& bounds) {
  constexpr std::size_t most = 7, full = 3;
  if (ranges.size() > most) throw UsageError("--vary takes {} parameters at most", most);
  // Columns of a Hadamard matrix of eight rows.
  constexpr unsigned columns[most] = {1, 2, 4, 7, 3, 5, 6};
  const unsigned corners = ranges.size() < full ? 1U << ranges.size() : 8;
  Box box;
  for (unsigned row = 0; row <= corners; ++row) {
    std::vector<std::string> sets;
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      const bool odd = std::popcount((row - 1) & columns[j]) % 2 == 1;
      sets.push_back(fmt::format("{}={}", ranges[j].name,
                                 ranges[j].at(row == 0 ? 0
                                              : odd    ? 1
                                                       : -1)));
    }
    box.cases.push_back(with_sets(c, sets, bounds));
    box.points.push_back(std::move(sets));
  }
  return box;
}

/// The values of --set without those of parameters that vary.
std::vector<std::string> fixed_sets(std::vector<std::string> sets,
                                    const std::vector<Range>& ranges) {
  std::erase_if(sets, [&](const std::string& set) {
    return std::ranges::any_of(
        ranges, [&](const Range& range) { return set.starts_with(range.name + "="); });
  });
  return sets;
}

std::string commented(const std::string& lines) {
  std::istringstream stream(lines);
  std::string text;
  for (std::string line; std::getline(stream, line);) text += "// " + line + "\n";
  return text;
}

/// A scene is watched all the time, and what is seen of it is not right at its quarters alone.
void watch(Case& c) {
  constexpr int looks = 64;
  const double length = c.stops.back() - c.t0;
  c.stops.clear();
  for (int k = 1; k <= looks; ++k) c.stops.push_back(c.t0 + length * k / looks);
}

/// Whether `odeum run --stops` has the stops of the case.
bool may_stop(const AdviseOptions& options, const Case& c) {
  return !options.code && !options.problems.span.given() && !c.measures_particles &&
         (c.timed_stops() == c.stops || study::convergence_stops(c) == c.stops);
}

int advise_on(Session& session, AdviseOptions& options, const CLI::App& command) {
  read_times(options);
  if (options.code && (options.format != "table" || !options.vary.empty()))
    throw UsageError("--code: a program is text, of one set of parameters: without {}",
                     options.vary.empty() ? "--format" : "--vary");
  if (command.count("--seconds") > 0) require_positive("--seconds", options.wishes.seconds);
  check_solver_globs(options.wishes.solvers);
  for (const std::string& library : options.wishes.libraries) check_solver_globs({library + "/*"});
  // A folder that can't be written is refused before the race.
  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  options.wishes.start = std::chrono::steady_clock::now();
  // The deadline is in seconds; a truth that is found within them is kept.
  constexpr double usual = 40, share = 0.4;
  session.truth_bounds = {
      options.wishes.start +
          std::chrono::milliseconds(std::llround(
              1e3 * (options.wishes.seconds > 0 ? share * options.wishes.seconds : usual))),
      options.wishes.error > 0 ? options.wishes.error / 100 : 0};
  std::vector<Range> ranges;
  for (const std::string& text : options.vary) ranges.push_back(range_of(text));
  const Case given = case_of(session, options.what, options.problems, [&](Case& c) {
    if (c.measures_particles && options.wishes.frame == 0) watch(c);
  });
  Box box;
  if (ranges.empty())
    box.cases.push_back(given);
  else
    box = box_of(given, ranges, session.truth_bounds);
  for (Case& each : box.cases) truth::know_truth(each, each.stops, session.truth_bounds);
  const Case& c = box.cases.front();
  advise::Asked asked{shell_word(options.what),
                      words_of(fixed_sets(options.problems.sets, ranges), command), box.points,
                      options.until};
  // The truth is known up to there.
  if (c.end() > c.stops.back()) asked.until = c.stops.back();
  options.wishes.may_stop = may_stop(options, c);
  advise::Advice advice;
  try {
    advice = advise::advise(box.pointers(), options.wishes);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  const std::string text = advise::text_of(advice, c, asked);
  if (options.code && advice.failure.empty()) {
    const Entrant& winner = *advice.candidates[advice.winner].entrant;
    const Request& winner_request = advice.candidates[advice.winner].found->request();
    print(commented(text) + code_of(c, struct_of(c, winner.info), winner, winner_request));
  } else {
    print(options.format == "json"  ? advise::json_of(advice, c, asked).dump(2) + "\n"
          : options.format == "csv" ? advise::csv_of(advice)
                                    : text);
  }
  if (folder) remark_on_page(advise::write_page(*folder, advice, c, asked));
  return advise::is_whole(advice, c) ? success : check_failed;
}

}  // namespace

void add_advise(CLI::App& app, Session& session, int& result) {
  const auto options = std::make_shared<AdviseOptions>();
  CLI::App* command = app.add_subcommand(
      "advise",
      "which solver, at which setting, has an error on a problem in the least time, or the least "
      "error within a time");
  add_option(*command, "problem CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu", options->what,
             "a case, a scene, a problem's file, or an FMU")
      ->required();
  add_option(*command, "--error E", options->wishes.error,
             "the largest error at the problem's stops, in the units of its errors: the "
             "least time to it");
  add_option(*command, "--time T", options->time,
             "the processor time of a run, as 5ms: the least error within it");
  add_option(*command, "--frame DT", options->frame,
             "fixed steps that divide it, as 1/60: with --time, which is then that of a frame, or "
             "with --error at each frame");
  add_option(*command, "--until T", options->until, "end time; default: the horizon");
  add_option(*command, "--energy E", options->wishes.energy,
             "with --error: the largest error of the energy, relative to its size");
  add_option(*command, "--horizon T", options->wishes.horizon,
             "with --energy: the time up to which it holds, for problems that conserve it");
  add_option(*command, "--vary NAME=FROM..TO ...", options->vary,
             "a box of parameters, as k=0.5..2: one setting for its middle and its corners")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_option(*command, "--library NAME,...", options->wishes.libraries,
             "only solvers of these: cvode,gsl")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_option(*command, "--solver GLOB...", options->wishes.solvers,
             "solvers, as library/method with * and ? (a method alone: Odeum's own)")
      ->transform(with_library);
  add_option(
      *command, "--seconds S", options->wishes.seconds,
      "for the answer, the truth included; default: 20, and up to 600 for thirty of the best "
      "runs where one takes over 2 ms");
  add_format(*command, options->format);
  command->add_flag("--code", options->code,
                    "print a C++ program that makes the run, with the answer as its comment");
  add_option(*command, "--out DIR", options->out,
             "folder for the files: race.csv, advice.json and a page with the diagram");
  add_problem_options(*command, options->problems, false);
  command->callback(
      [options, command, &session, &result] { result = advise_on(session, *options, *command); });
}

}  // namespace odeum::cli
