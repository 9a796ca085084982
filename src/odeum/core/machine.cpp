// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/machine.hpp"

#include <fmt/chrono.h>

#include <fstream>

#ifdef __linux__
#include <link.h>
#endif

namespace odeum {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos)
        return line.substr(colon + 2);
  return "unknown";
}

std::vector<std::string> loaded_libraries() {
  std::vector<std::string> files;
#ifdef __linux__
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* list) {
        // The program itself has no name here.
        if (*info->dlpi_name)
          static_cast<std::vector<std::string>*>(list)->emplace_back(info->dlpi_name);
        return 0;
      },
      &files);
#endif
  return files;
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace odeum
