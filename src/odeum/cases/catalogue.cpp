// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/catalogue.hpp"

#include <algorithm>
#include <deque>
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
  std::unique_ptr<const Case> made;
};

/// The cases that are there without a user, in the order of their files.
std::deque<Known> built_in() {
  std::vector<std::pair<std::string, std::vector<Statement>>> files;
#define ODEUM_ITEM(stem) files.emplace_back(#stem, cases::stem());
#include "lists/cases.inc"
#undef ODEUM_ITEM
  for (const cases::BuiltInText& text : cases::built_in_texts())
    files.emplace_back(text.stem, cases::text_statements(text));
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::deque<Known> all;
  for (auto& [file, statements] : files)
    for (Statement& statement : statements) all.push_back({std::move(statement), true, nullptr});
  for (const RuntimeLibrary& library : runtime_libraries())
    if (library.problems)
      for (foreign::ProblemCallbacks& given : library.problems())
        all.push_back({cases::foreign_statement(std::move(given)), false, nullptr});
  return all;
}

/// Only what a user gives is added later; cases stay where they are.
struct Catalogue {
  std::deque<Known> all = built_in();
  std::size_t without_user = all.size();
  std::mutex mutex = {};
};
Catalogue& catalogue() {
  static Catalogue the_catalogue;
  return the_catalogue;
}

Known* find(const std::string& id) {
  for (Known& known : catalogue().all)
    if (known.statement.id == id) return &known;
  return nullptr;
}

const Case& made(Known& known) {
  const std::lock_guard lock(catalogue().mutex);
  if (!known.made) known.made = std::make_unique<const Case>(case_of(known.statement));
  return *known.made;
}

}  // namespace

Case case_of(const Statement& statement) {
  const auto named = [id = statement.id, title = statement.title, tags = statement.tags](Case c) {
    c.id = id;
    c.title = title;
    c.tags.insert(c.tags.end(), tags.begin(), tags.end());
    return c;
  };
  Case c = named(statement.make());
  if (c.with_values)
    c.with_values = [named, with = std::move(c.with_values)](const std::vector<double>& values) {
      return named(with(values));
    };
  return c;
}

std::vector<std::string> known_ids() {
  std::vector<std::string> ids;
  for (const Known& known : catalogue().all) ids.push_back(known.statement.id);
  return ids;
}

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
  for (std::size_t k = 0; k < catalogue().without_user; ++k)
    list.emplace_back(made(catalogue().all[k]));
  return list;
}

std::vector<const Case*> known_cases() {
  std::vector<const Case*> list;
  for (Known& known : catalogue().all) list.push_back(&made(known));
  return list;
}

const Case& add_user_case(Statement statement) {
  if (find(statement.id)) throw std::invalid_argument("a case named " + statement.id + " exists");
  return made(catalogue().all.emplace_back(Known{std::move(statement), false, nullptr}));
}

}  // namespace odeum
