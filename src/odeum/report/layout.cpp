// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/layout.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/texts.hpp"

namespace odeum::report {

std::string document(const std::string& title, const std::string& top, const std::string& main,
                     const std::vector<std::string>& scripts) {
  std::string loads;
  for (const std::string& script : scripts)
    loads += fmt::format("<script src=\"{}\" defer></script>\n", as_address(script));
  // 'self' of a page that is opened from a disk is nothing in some browsers, hence file:.
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' "
      "file:; style-src 'unsafe-inline'; script-src 'self' file:; base-uri 'none'; form-action "
      "'none'\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n{}</head>\n<body>\n{}{}<main>\n{}</main>\n</body>\n</html>\n",
      escape(title), page_style(), loads, marker_symbols(), top, main);
}

std::string data_name(const CaseFacts& c) {
  return "case_" + std::filesystem::path(c.file).stem().string();
}

}  // namespace odeum::report
