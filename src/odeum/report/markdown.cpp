// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/markdown.hpp"

#include <fmt/format.h>

#include "odeum/report/html.hpp"

namespace odeum::report {
namespace {

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string inline_html(std::string_view text);

// A span between two equal marks at the head of the text: what it holds, or nothing.
std::string_view marked(std::string_view text, std::string_view mark) {
  if (!text.starts_with(mark)) return {};
  const auto end = text.find(mark, mark.size());
  if (end == std::string_view::npos) return {};
  const auto inner = text.substr(mark.size(), end - mark.size());
  const bool spaced = !inner.empty() && (inner.front() == ' ' || inner.back() == ' ');
  return spaced && mark != "`" ? std::string_view{} : inner;  // "2 * 3 * 4" is no emphasis
}

struct Link {
  std::string_view text, target;
  std::size_t length = 0;
};

Link link_at(std::string_view text) {
  if (!text.starts_with('[')) return {};
  const auto middle = text.find("](");
  if (middle == std::string_view::npos) return {};
  const auto end = text.find(')', middle);
  if (end == std::string_view::npos) return {};
  return {text.substr(1, middle - 1), text.substr(middle + 2, end - middle - 2), end + 1};
}

std::string link_html(const Link& link) {
  std::string shown = inline_html(link.text);
  if (!link.target.starts_with("https://") && !link.target.starts_with("http://")) return shown;
  return fmt::format("<a href=\"{}\">{}</a>", escape(link.target), shown);
}

std::string inline_html(std::string_view text) {
  std::string html;
  std::size_t shown = 0;
  const auto flush = [&](std::size_t i) { html += escape(text.substr(shown, i - shown)); };
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    std::string piece;
    std::size_t length = 0;
    if (const auto code = marked(rest, "`"); !code.empty()) {
      piece = fmt::format("<code>{}</code>", escape(code));
      length = code.size() + 2;
    } else if (const auto bold = marked(rest, "**"); !bold.empty()) {
      piece = fmt::format("<strong>{}</strong>", inline_html(bold));
      length = bold.size() + 4;
    } else if (const auto stressed = marked(rest, "*"); !stressed.empty()) {
      piece = fmt::format("<em>{}</em>", inline_html(stressed));
      length = stressed.size() + 2;
    } else if (const Link link = link_at(rest); link.length != 0) {
      piece = link_html(link);
      length = link.length;
    }
    if (length == 0) {
      ++i;
      continue;
    }
    flush(i);
    html += piece;
    i += length;
    shown = i;
  }
  flush(text.size());
  return html;
}

// The text of a list item, or an empty view: "- x", "* x", "12. x".
std::string_view item_text(std::string_view line, bool& ordered) {
  line = trim(line);
  if (line.starts_with("- ") || line.starts_with("* ")) {
    ordered = false;
    return trim(line.substr(2));
  }
  const auto digits = line.find_first_not_of("0123456789");
  if (digits == 0 || digits == std::string_view::npos || line.substr(digits, 2) != ". ") return {};
  ordered = true;
  return trim(line.substr(digits + 2));
}

std::string table_row(std::string_view line, const char* cell) {
  line = trim(line);
  line.remove_prefix(1);
  if (line.ends_with('|')) line.remove_suffix(1);
  std::string html = "<tr>";
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find('|', begin), line.size());
    html += fmt::format("<{0}>{1}</{0}>", cell, inline_html(trim(line.substr(begin, end - begin))));
    begin = end + 1;
  }
  return html + "</tr>\n";
}

/// Turns line after line into HTML; a block ends where a line of another kind begins.
class Converter {
 public:
  void line(std::string_view text) {
    if (trim(text).starts_with("```")) return fence();
    if (block_ == Block::code) {
      html_ += escape(text) + "\n";
      return;
    }
    const std::string_view bare = trim(text);
    bool ordered = false;
    if (bare.empty()) {
      close();
    } else if (const auto level = bare.find_first_not_of('#');
               level >= 1 && level <= 4 && bare.substr(level, 1) == " ") {
      close();
      html_ += fmt::format("<h{0}>{1}</h{0}>\n", level + 1, inline_html(trim(bare.substr(level))));
    } else if (bare.starts_with('|')) {
      table(bare);
    } else if (const auto item = item_text(text, ordered); !item.empty()) {
      flush_text();
      open(ordered ? Block::ordered : Block::bullets);
      text_ = item;
    } else {
      if (!in_list()) open(Block::paragraph);  // within a list, it goes on with the item
      if (!text_.empty()) text_ += ' ';
      text_ += bare;
    }
  }

  std::string finish() {
    close();
    return std::move(html_);
  }

 private:
  enum class Block { none, paragraph, bullets, ordered, table, code };

  static const char* tag(Block block) {
    constexpr const char* tags[] = {"", "p", "ul", "ol", "table", "pre"};
    return tags[static_cast<std::size_t>(block)];
  }
  bool in_list() const { return block_ == Block::bullets || block_ == Block::ordered; }

  void open(Block block) {
    if (block_ == block) return;
    close();
    block_ = block;
    html_ += fmt::format("<{}>", tag(block));
  }
  // Text is gathered until it is whole: a span may go over the end of a line.
  void flush_text() {
    if (!text_.empty()) {
      const std::string html = inline_html(text_);
      html_ += in_list() ? fmt::format("<li>{}</li>\n", html) : html;
    }
    text_.clear();
  }
  void close() {
    flush_text();
    if (block_ != Block::none) html_ += fmt::format("</{}>\n", tag(block_));
    block_ = Block::none;
  }
  void fence() {
    if (block_ == Block::code) return close();
    open(Block::code);
  }
  void table(std::string_view line) {
    const bool heading = block_ != Block::table;
    open(Block::table);
    if (line.find_first_not_of("|-: ") == std::string_view::npos) return;  // the rule under it
    html_ += table_row(line, heading ? "th" : "td");
  }

  Block block_ = Block::none;
  std::string text_, html_;
};

}  // namespace

std::string markdown_to_html(std::string_view markdown) {
  Converter converter;
  while (!markdown.empty()) {
    const auto end = std::min(markdown.find('\n'), markdown.size());
    converter.line(markdown.substr(0, end));
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
  }
  return converter.finish();
}

}  // namespace odeum::report
