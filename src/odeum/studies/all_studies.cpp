// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "odeum/studies/study.hpp"

// lists/studies.inc is generated: the folders of studies that have a study.cpp.
namespace odeum::study {

#define ODEUM_ITEM(folder) std::unique_ptr<Study> make_##folder();
#include "lists/studies.inc"
#undef ODEUM_ITEM

Studies make_studies() {
  Studies studies;
#define ODEUM_ITEM(folder) studies.push_back(make_##folder());
#include "lists/studies.inc"
#undef ODEUM_ITEM
  std::ranges::stable_sort(studies, [](const auto& a, const auto& b) {
    return a->declaration().place < b->declaration().place;
  });
  return studies;
}

}  // namespace odeum::study
