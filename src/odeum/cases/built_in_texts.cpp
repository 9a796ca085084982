// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <stdexcept>
#include <string>

#include "odeum/cases/reference.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/cases/text_case.hpp"

// lists/*.inc are generated: the stem and the text of each text in cases/ and file in
// cases/reference and cases/scenes.
namespace odeum::cases {

std::string_view reference_text(const std::string& name) {
  static const std::map<std::string_view, std::string_view> all{
#include "lists/references.inc"
  };
  const auto found = all.find(name);
  if (found == all.end()) throw std::runtime_error("no reference " + name);
  return found->second;
}

const std::vector<BuiltInText>& built_in_texts() {
  static const std::vector<BuiltInText> all{
#include "lists/texts.inc"
  };
  return all;
}

const BuiltInText* built_in_text_of(const std::string& id) {
  for (const BuiltInText& text : built_in_texts())
    if (text.may_state(id))
      for (const Statement& statement : text_statements(text))
        if (statement.id == id) return &text;
  return nullptr;
}

TextSource source_of(const BuiltInText& text, const std::string& id,
                     const formula::Overrides& set) {
  return {"cases/" + text.stem + ".yaml", text.text, id, set};
}

const std::vector<SceneText>& all_scenes() {
  static const std::vector<SceneText> all{
#include "lists/scenes.inc"
  };
  return all;
}

}  // namespace odeum::cases
