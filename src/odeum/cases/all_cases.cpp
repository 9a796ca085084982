// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "odeum/cases/runtime_cases.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/case_files.hpp"

// lists/cases.inc is generated: the stems of the files in cases/.
namespace odeum {
namespace cases {

#define ODEUM_ITEM(stem) std::vector<Case> stem();
#include "lists/cases.inc"
#undef ODEUM_ITEM

}  // namespace cases
namespace {

std::map<std::string, std::string> files;

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    const auto add = [&](std::vector<Case> more, const char* file) {
      for (Case& c : more) {
        if (file) files[c.id] = file;
        list.push_back(std::move(c));
      }
    };
#define ODEUM_ITEM(stem) add(cases::stem(), #stem);
#include "lists/cases.inc"
#undef ODEUM_ITEM
    add(cases::runtime_cases(), nullptr);
    return list;
  }();
  return all;
}

const std::map<std::string, std::string>& case_files() {
  all_cases();
  return files;
}

}  // namespace odeum
