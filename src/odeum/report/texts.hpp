// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

namespace odeum::report {

/// The page's style sheet, reports/viewer/page.css; built in.
std::string_view page_style();

/// The script of the report's views, reports/viewer/page.js with its parts; built in.
std::string_view page_js();

/// The parts of a replay page, reports/viewer/replay.*; built in.
std::string_view replay_html();
std::string_view replay_css();
std::string_view replay_js();

/// reports/findings.md and what lies under reports/findings/*.md, one after the other; built in.
std::string_view findings();

/// reports/trade-offs.md; built in.
std::string_view trade_offs();

/// reports/columns.md and those of the studies; built in.
std::string_view columns_text();

}  // namespace odeum::report
