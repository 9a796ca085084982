// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/runtime_library.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include <fmt/format.h>

namespace odeum {
namespace {

std::vector<RuntimeLibrary>& libraries() {
  static std::vector<RuntimeLibrary> all;
  return all;
}
std::atomic<bool> closed = false;

}  // namespace

const std::vector<LibraryInfo>& built_in_libraries() {
  static const std::vector<LibraryInfo> all{
#include "lists/libraries.inc"  // generated: the libraries with their versions
  };
  return all;
}

void add_runtime_library(RuntimeLibrary library) {
  if (closed) throw std::logic_error("a library was added after solvers or cases had been listed");
  const auto taken = [&](const LibraryInfo& info) {
    return info.name == library.info.name ||
           std::ranges::count(info.libraries, library.info.name) > 0;
  };
  bool found = library.info.name == "odeum" ||
               std::any_of(built_in_libraries().begin(), built_in_libraries().end(), taken);
  for (const RuntimeLibrary& other : libraries()) found = found || taken(other.info);
  if (found)
    throw LoadError(fmt::format("there is a library of the name {} already", library.info.name));
  libraries().push_back(std::move(library));
}

const std::vector<RuntimeLibrary>& runtime_libraries() {
  closed = true;
  return libraries();
}

const std::vector<LibraryInfo>& all_libraries() {
  static const std::vector<LibraryInfo> all = [] {
    std::vector<LibraryInfo> list = built_in_libraries();
    for (const RuntimeLibrary& each : runtime_libraries()) list.push_back(each.info);
    return list;
  }();
  return all;
}

}  // namespace odeum
