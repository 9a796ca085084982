// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/runtime_library.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include <fmt/format.h>

namespace odeum {
namespace {

std::vector<LateLibrary>& libraries() {
  static std::vector<LateLibrary> all;
  return all;
}
std::atomic<bool> closed = false;

}  // namespace

void add_late_library(LateLibrary library) {
  if (closed) throw std::logic_error("a library was added after the cases had been built");
  const auto taken = [&](const LibraryInfo& info) {
    return info.name == library.info.name ||
           std::count(info.libraries.begin(), info.libraries.end(), library.info.name) > 0;
  };
  bool found = library.info.name == "odeum" ||
               std::any_of(built_in_libraries().begin(), built_in_libraries().end(), taken);
  for (const LateLibrary& other : libraries()) found = found || taken(other.info);
  if (found)
    throw LateError(fmt::format("there is a library of the name {} already", library.info.name));
  libraries().push_back(std::move(library));
}

const std::vector<LateLibrary>& late_libraries() {
  closed = true;
  return libraries();
}

const std::vector<LibraryInfo>& all_libraries() {
  static const std::vector<LibraryInfo> all = [] {
    std::vector<LibraryInfo> list = built_in_libraries();
    for (const LateLibrary& late : late_libraries()) list.push_back(late.info);
    return list;
  }();
  return all;
}

}  // namespace odeum
