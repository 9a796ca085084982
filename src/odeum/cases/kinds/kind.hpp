// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/span.hpp"
#include "odeum/formula/problem.hpp"

/// The kinds of problems that a person brings: each is a folder here with a function `Kind
/// <folder>_kind()`.
namespace odeum::cases {

/// A word of a command line that names a problem. The text of a file is read once. For one thread.
class Named {
 public:
  explicit Named(std::string word) : word_(std::move(word)) {}

  const std::string& word() const { return word_; }
  /// Whether its end is that of a YAML file's name.
  bool has_yaml_name() const { return word_.ends_with(".yaml") || word_.ends_with(".yml"); }
  bool is_file() const;  ///< a regular one
  bool exists() const;   ///< a file of any type, or a folder
  /// The file's text. Throws InputError as read_text_file() does, whose arguments these are.
  const std::string& text(const std::string& name, std::size_t most_bytes,
                          const std::string& raise = "") const;

 private:
  std::string word_;
  mutable std::optional<std::string> text_;
};

/// What a command gives beside the word.
struct Given {
  std::string id;          ///< of a file's only case
  formula::Overrides set;  ///< values of parameters
  Span span = {};
  std::string inputs = {};  ///< a file of inputs over time; empty: none
};

/// The cases that a file states, one at least.
struct ReadProblem {
  std::vector<Statement> statements;
  std::string content;  ///< tells the file from others
  std::vector<std::string> warnings = {};
};

struct Kind {
  const char* name = nullptr;  ///< in remarks
  /// What follows the id of a case that has the id of another one.
  const char* suffix = nullptr;
  bool has_frames = false;  ///< a run may be shown as one of a scene
  /// Whether the word names a problem of this kind. Does not throw.
  bool (*recognises)(const Named& named) = nullptr;
  /// Throws InputError, std::invalid_argument for a wrong value of a parameter, std::length_error
  /// for a problem that is too large, and LoadError for one whose code cannot be loaded.
  ReadProblem (*read)(const Named& named, const Given& given) = nullptr;
  bool has_inputs = false;  ///< over time, from a file
};

/// The kind of the problem that is named; null: a case of the catalogue, or nothing.
const Kind* kind_of(const Named& named);

/// Whether a file's text is that of a problem, with states or equations.
bool is_problem_text(const Named& named);
/// The text of a problem's file. Throws InputError.
const std::string& problem_text(const Named& named);
inline constexpr std::size_t most_model_bytes = 64'000'000;
/// The cases of a model in another format, from the text that `text` makes of it for an end, of
/// which such models name none: that of `given`, or 10.
ReadProblem translated(const Named& named, const Given& given,
                       const std::function<std::string(double end)>& text);
/// The text of a scene: its file's, or a built-in one. Throws InputError.
const std::string& scene_text(const Named& named, std::size_t most_bytes,
                              const std::string& raise = "");

}  // namespace odeum::cases
