// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/cases/case_text.hpp"
#include "odeum/cases/catalogue.hpp"

namespace odeum::cases {

/// A file of cases/ that is a text, built in.
struct BuiltInText {
  std::string stem, text;

  /// False where it has no case of that id, without reading it: it would have its words.
  bool may_state(const std::string& id) const {
    return stem == id || text.find(id) != std::string::npos;
  }
};
const std::vector<BuiltInText>& built_in_texts();
/// The one that states the case of that id; null where none does.
const BuiltInText* built_in_text_of(const std::string& id);
TextSource source_of(const BuiltInText& text, const std::string& id,
                     const formula::Overrides& set = {});

/// The cases that a problem file states: those below its `cases`, or one of the name `id`. Each has
/// its closed form, its reference, or a computed one for truth (kept in the cache folder by
/// content), and the steps of studies that the file gives, or that trial runs find. Its equations
/// are compiled when it is made, unless a built-in text has the same. `set` replaces parameters,
/// `span` the end and the stops. Throws InputError for a mistake in what is said of cases; make()
/// does for one in the problem, and std::length_error where the problem is too large.
std::vector<Statement> text_statements(const std::string& file, const std::string& text,
                                       const std::string& id, const formula::Overrides& set = {},
                                       const Span& span = {});
std::vector<Statement> text_statements(const BuiltInText& text);

/// A case's truth in words, and whether it is proved (see proof_of() in text_truth.hpp), which a
/// user's text says by itself. Of a built-in text it takes up to two seconds, the first time.
std::string with_proof(const Case& c);

}  // namespace odeum::cases
