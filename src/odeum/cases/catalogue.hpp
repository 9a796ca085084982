// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum {

/// A case that is known, and made when it is first asked for.
struct Statement {
  std::string id;
  std::string title;
  /// Tags given by the author. A text gains those that follow from its equations.
  std::vector<std::string> tags;
  /// The rest of the case, before its truth where that has to be computed. Throws InputError for a
  /// text that is wrong.
  std::function<Case()> make;
};

/// The case of that statement, with its id, title and tags, before its truth is computed.
Case case_before_truth(const Statement& statement);
/// The same with its truth.
Case case_of(const Statement& statement);

/// The ids of every case: the project's in the order of the files in cases/, those of plug-ins, and
/// those that a user gave to this run. Nothing is made.
std::vector<std::string> known_ids();
/// Whether there is a case of that id. Other texts than those that may state it are not read.
bool knows_case(const std::string& id);
/// The case of that id, made once: it stays where it is until the program ends. Thread-safe. Throws
/// std::out_of_range where there is none.
const Case& known_case(const std::string& id);
/// Whether that very case is the project's: not made with other parameters, of a plug-in or a user.
bool is_built_in(const Case& c);

/// Makes every case of the project and of plug-ins; known_cases() adds those of the user.
std::vector<std::reference_wrapper<const Case>> all_cases();
std::vector<const Case*> known_cases();

/// Adds a case of a user. It is added before a study begins, by one thread, and runs only where it
/// is named. Throws std::invalid_argument where one of that id is known.
const Case& add_user_case(Statement statement);

}  // namespace odeum
