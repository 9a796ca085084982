// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

namespace odeum::report {

/// The small part of Markdown that the findings use, as HTML: headings (two levels down, so that
/// they fit under the page's own), paragraphs, lists of one level, tables, fenced code, `code`,
/// **bold**, *emphasis* and [links](https://...). All else, HTML included, is shown as text; a link
/// to anything but a web page is shown as its text.
std::string markdown_to_html(std::string_view markdown);

}  // namespace odeum::report
