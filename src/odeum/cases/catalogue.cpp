// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/catalogue.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "odeum/cases/foreign_case.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum {
namespace cases {

// lists/cases.inc is generated: the stems of the C++ files in cases/.
#define ODEUM_ITEM(stem) std::vector<Statement> stem();
#include "lists/cases.inc"
#undef ODEUM_ITEM

}  // namespace cases
namespace {

struct Known {
  Statement statement;
  bool built_in = false;
  std::unique_ptr<const Case> made = nullptr;
};

/// What one file states, or all plug-ins, or the user. A text is read when one of its cases may be
/// meant: to read them all takes longer than a short run.
struct File {
  std::string name;
  const cases::BuiltInText* text = nullptr;  ///< null: it states its cases in C++
  std::deque<Known> cases = {};
  bool is_read = false;

  void add(std::vector<Statement> statements) {
    for (Statement& statement : statements) cases.push_back({std::move(statement), true});
  }
};

/// The cases that are there without a user, in the order of their files.
std::deque<File> built_in() {
  std::deque<File> files;
#define ODEUM_ITEM(stem) files.emplace_back(File{#stem}).add(cases::stem());
#include "lists/cases.inc"
#undef ODEUM_ITEM
  for (const cases::BuiltInText& text : cases::built_in_texts())
    files.push_back({text.stem, &text});
  std::ranges::sort(files, [](const File& a, const File& b) { return a.name < b.name; });
  File& given = files.emplace_back(File{"plug-ins"});
  for (const RuntimeLibrary& library : runtime_libraries())
    if (library.problems)
      for (foreign::ProblemCallbacks& problem : library.problems())
        given.cases.push_back({cases::foreign_statement(std::move(problem))});
  return files;
}

/// Only what a user gives is added later; cases stay where they are.
struct Catalogue {
  std::deque<File> files = built_in();
  File user = {"the user's"};
  std::mutex reading = {}, making = {};

  std::deque<Known>& cases_of(File& file) {
    const std::lock_guard lock(reading);
    if (file.text && !std::exchange(file.is_read, true))
      file.add(cases::text_statements(*file.text));
    return file.cases;
  }
};
Catalogue& catalogue() {
  static Catalogue the_catalogue;
  return the_catalogue;
}

void for_each(bool with_user, const std::function<void(Known&)>& visit) {
  for (File& file : catalogue().files)
    for (Known& known : catalogue().cases_of(file)) visit(known);
  if (with_user)
    for (Known& known : catalogue().user.cases) visit(known);
}

Known* find_in(std::deque<Known>& all, const std::string& id) {
  for (Known& known : all)
    if (known.statement.id == id) return &known;
  return nullptr;
}

Known* find(const std::string& id) {
  for (File& file : catalogue().files)
    if (!file.text || file.text->may_state(id))
      if (Known* const known = find_in(catalogue().cases_of(file), id)) return known;
  return find_in(catalogue().user.cases, id);
}

const Case& made(Known& known) {
  const std::lock_guard lock(catalogue().making);
  if (!known.made) known.made = std::make_unique<const Case>(case_of(known.statement));
  return *known.made;
}

}  // namespace

Case case_before_truth(const Statement& statement) {
  const auto named = [id = statement.id, title = statement.title, tags = statement.tags](Case c) {
    c.id = id;
    c.title = title;
    c.tags.insert(c.tags.end(), tags.begin(), tags.end());
    return c;
  };
  Case c = named(statement.make());
  if (c.with_values)
    c.with_values = [named, with = std::move(c.with_values)](const std::vector<double>& values,
                                                             const TruthBounds& bounds) {
      return named(with(values, bounds));
    };
  return c;
}

Case case_of(const Statement& statement) {
  Case c = case_before_truth(statement);
  complete(c);
  return c;
}

std::vector<std::string> known_ids() {
  std::vector<std::string> ids;
  for_each(true, [&](Known& known) { ids.push_back(known.statement.id); });
  return ids;
}

bool knows_case(const std::string& id) { return find(id) != nullptr; }

const Case& known_case(const std::string& id) {
  Known* const known = find(id);
  if (!known) throw std::out_of_range("no case " + id);
  return made(*known);
}

bool is_built_in(const Case& c) {
  const Known* const known = find(c.id);
  return known && known->built_in && known->made.get() == &c;
}

std::vector<std::reference_wrapper<const Case>> all_cases() {
  std::vector<std::reference_wrapper<const Case>> list;
  for_each(false, [&](Known& known) { list.emplace_back(made(known)); });
  return list;
}

std::vector<const Case*> known_cases() {
  std::vector<const Case*> list;
  for_each(true, [&](Known& known) { list.push_back(&made(known)); });
  return list;
}

const Case& add_user_case(Statement statement) {
  if (find(statement.id)) throw std::invalid_argument("a case named " + statement.id + " exists");
  return made(catalogue().user.cases.emplace_back(Known{std::move(statement)}));
}

}  // namespace odeum
