// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <stdexcept>

#include "odeum/cases/foreign_case.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/cli/conditions.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/report/text.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::cli {
namespace {

std::string& mark() {
  static std::string text;
  return text;
}

/// By the id of a case the words that name it on a command line.
std::map<std::string, std::string>& loaded_words() {
  static std::map<std::string, std::string> words;
  return words;
}

bool has_yaml_name(const std::string& word) {
  return word.ends_with(".yaml") || word.ends_with(".yml");
}

std::optional<SceneSource> scene_that_is_there(const std::string& word) {
  std::error_code ignored;
  const auto scene = find_scene(word);
  return scene && (scene->text || std::filesystem::exists(word, ignored)) ? scene : std::nullopt;
}

bool is_fmu(const std::string& word) { return word.ends_with(".fmu"); }

/// The file's name without folder and extension.
std::string stem_of(const std::string& path) {
  return report::file_stem(std::filesystem::path(path).stem().string());
}

/// The id; with `otherwise` where a case has it, and a number where one of a file before has that.
std::string unused_id(const std::string& id, const std::string& otherwise) {
  std::string unused = id;
  for (int number = 1; knows_case(unused); ++number)
    unused = id + otherwise + (number == 1 ? "" : std::to_string(number));
  return unused;
}

/// Leaves those statements of a file's text that a command takes, one at least.
using Choice = std::function<void(const std::string& text, std::vector<Statement>& statements)>;

const Case& load_fmu(const std::string& path, const std::vector<std::string>& sets,
                     const SpanCheck& check) {
  try {
    foreign::ProblemCallbacks given = open_fmu(path, overrides_of(sets));
    given.id = unused_id(stem_of(path), "_fmu");
    mark() += " " + given.content;
    const odeum_problem& p = given.functions;
    if (check) check(p.t0, p.stops[p.stop_count - 1]);
    return add_user_case(cases::foreign_statement(std::move(given)));
  } catch (const LoadError& error) {
    throw UsageError(error.what());
  }
}

Cases load_text(const std::string& path, const std::vector<std::string>& sets, const Choice& choose,
                const cases::Span& span = {}) {
  try {
    const std::string text = formula::problem_text(path);
    std::vector<Statement> statements =
        cases::text_statements(path, text, stem_of(path), overrides_of(sets), span);
    if (choose) choose(text, statements);
    Cases given;
    for (Statement& statement : statements) {
      statement.id = unused_id(statement.id, "_text");
      given.push_back(&add_user_case(std::move(statement)));
    }
    mark() += fmt::format(" {} {}", formula::content_key(text), sets);
    return given;
  } catch (const InputError& error) {
    throw UsageError(error.what());
  } catch (const std::invalid_argument& error) {
    throw UsageError("--set: {}", error.what());
  } catch (const std::length_error& error) {
    throw UsageError("{}:1:1: {}", path, error.what());
  }
}

/// The text that a command names, a file's or a built-in one; none where it is no text.
std::optional<cases::TextSource> source_of(const std::string& what, const ProblemOptions& options,
                                           const Case& c) {
  const formula::Overrides set = overrides_of(options.sets);
  if (is_problem_file(what) && !is_fmu(what)) {
    const std::string text = formula::problem_text(what);
    std::vector<Statement> statements = cases::text_statements(what, text, stem_of(what), set);
    keep_chosen(what, options.chosen, statements);
    return cases::TextSource{what, text, statements.front().id, set};
  }
  const cases::BuiltInText* const text = cases::built_in_text_of(c.id);
  return text ? std::optional(cases::source_of(*text, c.id, set)) : std::nullopt;
}

}  // namespace

std::string struct_of(const std::string& what, const ProblemOptions& options, const Case& c,
                      const SolverInfo& solver) {
  try {
    if (const auto source = source_of(what, options, c))
      return cases::CaseText(*source).as_struct(solver.family == "taylor");
  } catch (const std::exception& error) {
    throw UsageError("--code: {}", error.what());
  }
  return {};
}

cases::Conditions conditions_of(const std::string& what, const ProblemOptions& options,
                                const Case& c) {
  const auto source = source_of(what, options, c);
  return source ? cases::conditions_of(cases::CaseText(*source).problem()) : cases::Conditions();
}

std::string SceneSource::read(std::size_t most_bytes, const std::string& raise) const {
  return text ? *text : read_text_file(file, "scene", most_bytes, raise);
}

std::optional<SceneSource> find_scene(const std::string& what) {
  std::error_code ignored;
  const SceneSource file{what, std::nullopt};
  if (has_yaml_name(what)) return file;
  if (knows_case(what)) return std::nullopt;
  for (const cases::SceneText& scene : cases::all_scenes())
    if (scene.name == what) return SceneSource{what, std::string(scene.text)};
  if (std::filesystem::exists(what, ignored)) return file;
  return std::nullopt;
}

void add_problem_options(CLI::App& command, ProblemOptions& options, bool words) {
  if (words)
    add_option(command, "problem CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu", options.words,
               "cases, with * and ?, scenes, and files of your own problems and FMUs");
  else
    add_option(command, "--case ID", options.chosen,
               "of a problem's file that has several cases: the one that is meant");
  add_option(command, "--set NAME=VALUE", options.sets,
             "another value of a parameter, see odeum list cases --parameters: --set B=2.5")
      ->allow_extra_args(false);
}

bool is_problem_file(const std::string& path) {
  if (is_fmu(path)) return true;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  try {
    return formula::looks_like_problem(path, formula::problem_text(path));
  } catch (const InputError&) {
    return false;
  }
}

void require_no_choice(const std::string& what, const std::string& chosen) {
  if (!chosen.empty())
    throw UsageError("--case: chooses a case of a problem's file; got {}, expected no --case",
                     shown(what));
}

Cases load_problems_of(const std::string& path, const std::vector<std::string>& sets) {
  return is_fmu(path) ? Cases{&load_fmu(path, sets, {})} : load_text(path, sets, {});
}

const Case& load_problem(const std::string& path, const ProblemOptions& options,
                         const SpanCheck& check) {
  if (is_fmu(path)) {
    require_no_choice(path, options.chosen);
    return load_fmu(path, options.sets, check);
  }
  return *load_text(
              path, options.sets,
              [&](const std::string& text, std::vector<Statement>& statements) {
                keep_chosen(path, options.chosen, statements);
                if (!check) return;
                const auto [t0, end] =
                    cases::CaseText({path, text, statements.front().id, overrides_of(options.sets)})
                        .span();
                check(t0, end);
              },
              options.span)
              .front();
}

std::optional<Case> load_before_truth(const std::string& path, const ProblemOptions& options) {
  if (is_fmu(path)) return std::nullopt;
  try {
    return cases::case_before_truth({path, formula::problem_text(path),
                                     options.chosen.empty() ? stem_of(path) : options.chosen,
                                     overrides_of(options.sets)});
  } catch (const std::exception&) {
    return std::nullopt;  // what is wrong is said when the problem is loaded
  }
}

std::optional<Case> scene_before_truth(const std::string& what) {
  const std::optional<SceneSource> source = find_scene(what);
  if (!source) return std::nullopt;
  try {
    const scene::ReadOptions options{.need_solver = false};
    const std::string text = source->read(options.most_bytes);
    return case_of(cases::scene_statement(stem_of(source->file), source->file, text,
                                          scene::read_scene(source->file, text, options).scene, {},
                                          false));
  } catch (const std::exception&) {
    return std::nullopt;  // what is wrong is said when the scene is loaded
  }
}

const Case& load_scene(const SceneSource& source, const std::vector<std::string>& sets,
                       const cases::Span& span) {
  if (!sets.empty()) throw UsageError("--set: a scene has no parameters; change its file");
  const scene::ReadOptions options{.need_solver = false};
  const std::string text = source.read(options.most_bytes);
  scene::ReadScene read = scene::read_scene(source.file, text, options);
  for (const std::string& warning : read.warnings) remark(warning + " (warning)");
  mark() += " " + formula::content_key(text);
  return add_user_case(cases::scene_statement(unused_id(stem_of(source.file), "_scene"),
                                              source.file, text, std::move(read.scene), span));
}

Case case_of(const std::string& what, const ProblemOptions& options, const SpanCheck& check) {
  if (is_problem_file(what) && !is_fmu(what)) return load_problem(what, options, check);
  if (!is_fmu(what)) require_no_choice(what, options.chosen);
  if (const auto scene = is_fmu(what) ? std::nullopt : find_scene(what))
    return load_scene(*scene, options.sets, options.span);
  const Case c =
      is_fmu(what) ? load_problem(what, options, check) : with_sets(find_case(what), options.sets);
  return options.span.given() ? cases::with_span(c, options.span) : c;
}

std::vector<std::string> load_problems(const ProblemOptions& options,
                                       const std::vector<std::string>& case_globs) {
  std::vector<std::string> globs, words = options.words;
  words.insert(words.end(), case_globs.begin(), case_globs.end());
  bool loaded = false;
  for (const std::string& word : words) {
    const bool is_text = is_problem_file(word);
    const auto scene = is_text ? std::nullopt : scene_that_is_there(word);
    // A file that does not exist is taken for a problem's.
    if (!scene && !is_text && !has_yaml_name(word)) {
      globs.push_back(word);
      continue;
    }
    for (const Case* c :
         scene ? Cases{&load_scene(*scene, options.sets)} : load_problems_of(word, options.sets)) {
      remark("{:<9}  {} ({})", scene ? "scene" : "problem", c->title, c->source);
      for (const auto& [name, fact] : c->facts) remark("{:<9}  {}", name, fact);
      std::string& name = loaded_words()[c->id] = shell_word(word);
      for (const std::string& set : options.sets) name += " --set " + shell_word(set);
      globs.push_back(c->id);
    }
    loaded = true;
  }
  if (!loaded && !options.sets.empty())
    throw UsageError("--set: parameters are those of a problem file or an FMU, and none was given");
  return globs;
}

std::string mark_of_loaded() { return mark(); }

report::Facts facts_for(const std::vector<const Case*>& cases, unsigned jobs) {
  report::Facts facts = report::describe(cases, all_libraries(), jobs);
  for (report::CaseFacts& each : facts.cases)
    if (const auto loaded = loaded_words().find(each.id); loaded != loaded_words().end())
      each.words = loaded->second;
  return facts;
}

}  // namespace odeum::cli
