// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/origin.hpp"

#include <fmt/format.h>

#include "odeum/report/html.hpp"

namespace odeum::report {

std::string origin_text(const Origin& origin, bool empty) {
  std::string html;
  if (!origin.problem.empty())
    html = fmt::format("<p class=\"missing\">{}</p>\n", escape(origin.problem));
  const std::string how =
      fmt::format("<code>odeum {}</code> with this folder as <code>--out</code>", origin.command);
  if (empty) return html + "<p>Not measured in this run: " + how + " measures it.</p>\n";
  if (!origin.measured)
    return html +
           "<p>Not measured in this run: these are results of an earlier one, which the folder "
           "held.</p>\n";
  if (!origin.selection.empty())
    html += fmt::format(
        "<p>To keep a report short, it runs a selection: {}. {} runs every pair, and the next "
        "report shows those too.</p>\n",
        escape(origin.selection), how);
  return html;
}

}  // namespace odeum::report
