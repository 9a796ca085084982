// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>

#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/markdown.hpp"
#include "odeum/report/panels.hpp"
#include "odeum/report/png.hpp"
#include "odeum/report/table.hpp"
#include "odeum/report/texts.hpp"

namespace odeum::report {
namespace {

const std::string unknown = "\xEF\xBF\xBD";  // U+FFFD

TEST(SafeText, EntitiesForMarkup) {
  EXPECT_EQ(escape("</script><b a=\"1\" c='2'>&amp;"),
            "&lt;/script&gt;&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
}

TEST(SafeText, OneLineWithoutControls) {
  EXPECT_EQ(plain("a\nb\tc\r"), "a b c ");
  EXPECT_EQ(plain("\x1b[31mred"), unknown + "[31mred");
  EXPECT_EQ(plain(std::string("\x01", 1) + "7\x02"), unknown + "7" + unknown);
  EXPECT_EQ(plain("\xC2\x9B"
                  "31m"),
            unknown + "31m")
      << "the one-character form of ESC [";
  EXPECT_EQ(plain("a\xE2\x80\xAEz"), "a" + unknown + "z") << "right-to-left override";
  EXPECT_EQ(plain(std::string_view("a\0b", 3)), "a" + unknown + "b");
}

TEST(SafeText, KeepsUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(plain("ζ ≤ 𝜋"), "ζ ≤ 𝜋");
  EXPECT_EQ(plain("\xff"
                  "a"),
            unknown + "a");
  EXPECT_EQ(plain("\xC0\xAF"), unknown + unknown) << "an overlong slash";
  EXPECT_EQ(plain("\xED\xA0\x80"), unknown + unknown + unknown) << "a surrogate";
  EXPECT_EQ(plain("\xE2\x82"), unknown + unknown) << "cut off";
}

TEST(SafeText, Numbers) {
  EXPECT_EQ(show_number(0.0123456), "0.0123");
  EXPECT_EQ(show_number(std::numeric_limits<double>::quiet_NaN()), "–");
  EXPECT_EQ(show_number(std::numeric_limits<double>::infinity()), "∞");
  EXPECT_EQ(show_count(1, "case"), "1 case");
  EXPECT_EQ(show_count(0, "case"), "0 cases");
}

TEST(SafeText, Base64AsInRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(SafeText, Addresses) {
  EXPECT_EQ(as_address("./a b\"<.csv"), "./a%20b%22%3C.csv");
  EXPECT_EQ(as_address("./javascript:x"), "./javascript%3Ax");
}

TEST(Markdown, Blocks) {
  EXPECT_EQ(markdown_to_html("# One\ntwo\nlines\n\n- a\n  b\n- c\n\n1. d\n"),
            "<h2>One</h2>\n<p>two lines</p>\n<ul><li>a b</li>\n<li>c</li>\n</ul>\n"
            "<ol><li>d</li>\n</ol>\n");
  EXPECT_EQ(markdown_to_html("```\na < b\n# no heading\n```\nc"),
            "<pre>a &lt; b\n# no heading\n</pre>\n<p>c</p>\n");
  EXPECT_EQ(markdown_to_html("| a | b |\n|---|--:|\n| 1 | `2` |\n"),
            "<table><tr><th>a</th><th>b</th></tr>\n<tr><td>1</td><td><code>2</code></td></tr>\n"
            "</table>\n");
}

TEST(Markdown, Spans) {
  EXPECT_EQ(markdown_to_html("**b** and *e* and `c*d*`"),
            "<p><strong>b</strong> and <em>e</em> and <code>c*d*</code></p>\n");
  EXPECT_EQ(markdown_to_html("2 * 3 * 4, a ** b"), "<p>2 * 3 * 4, a ** b</p>\n");
  EXPECT_EQ(markdown_to_html("[x](https://e.org/?a=\"b)"),
            "<p><a href=\"https://e.org/?a=&quot;b\">x</a></p>\n");
}

TEST(Markdown, NothingButTextFromMarkup) {
  EXPECT_EQ(markdown_to_html("<script>alert(1)</script>"),
            "<p>&lt;script&gt;alert(1)&lt;/script&gt;</p>\n");
  EXPECT_EQ(markdown_to_html("[x](javascript:alert(1))"), "<p>x)</p>\n");
}

TEST(Markdown, FindingsAreBuiltIn) {
  EXPECT_NE(findings().find("# Findings"), std::string_view::npos);
  EXPECT_NE(page_style().find("prefers-color-scheme: dark"), std::string_view::npos);
}

std::vector<SolverInfo> made_up(const char* library, const char* family, int count, double order) {
  SolverInfo solver;
  solver.library = library;
  solver.family = family;
  solver.order = order;
  std::vector<SolverInfo> list;
  for (int i = 0; i < count; ++i) {
    solver.method = std::string(family) + std::to_string(order) + "_" + std::to_string(i);
    list.push_back(solver);
  }
  return list;
}

TEST(Panels, HoldEverySolverOnceAndNeverTooMany) {
  std::vector<SolverInfo> solvers;
  for (const char* library : {"one", "two"})
    for (const int count : {1, 3, 7, 8, 9, 25})
      for (const char* family : {"explicit_rk", "multistep", "symplectic"})
        for (SolverInfo& solver : made_up(library, family, count, count)) solvers.push_back(solver);
  std::set<const SolverInfo*> seen;
  for (const Panel& panel : make_panels(solvers)) {
    EXPECT_FALSE(panel.solvers.empty());
    EXPECT_LE(panel.solvers.size(), curves_per_panel);
    for (const SolverInfo* solver : panel.solvers) {
      EXPECT_EQ(solver->library, panel.library);
      EXPECT_TRUE(seen.insert(solver).second);
    }
  }
  EXPECT_EQ(seen.size(), solvers.size());
}

TEST(Panels, SmallFamiliesShareOneAndLargeKindsAreNumbered) {
  std::vector<SolverInfo> small = made_up("one", "explicit_rk", 3, 2);
  for (const SolverInfo& solver : made_up("one", "multistep", 2, 4)) small.push_back(solver);
  const std::vector<Panel> one = make_panels(small);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].contents, "explicit rk, multistep; orders 2 to 4");

  const std::vector<SolverInfo> large = made_up("one", "explicit_rk", 9, 5);
  const std::vector<Panel> two = make_panels(large);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].contents, "explicit rk; order 5 (1 of 2)");
  EXPECT_EQ(two[1].solvers.size(), 5U);
}

TEST(Chart, AxesIgnoreWhatHasNoLogarithm) {
  Axis axis;
  for (const double value : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    axis.include(value);
  EXPECT_TRUE(axis.empty());
  axis.include(2);
  axis.include(0.5);
  EXPECT_EQ(axis.low, 0.5);
  EXPECT_EQ(axis.high, 2);
}

constexpr ChartSize hundred{100, 100, 0, 0, 0, 0};

TEST(Chart, PutsPointsWhereTheyBelong) {
  Chart logarithmic(hundred, {1, 100}, {1, 1e4}, {});
  logarithmic.line({{1, 1}, {10, 1e4}, {100, 100}}, "a");
  EXPECT_NE(logarithmic.svg().find("<path class=\"a\" d=\"M0 100L50 0L100 50\">"),
            std::string::npos)
      << logarithmic.svg();
  Chart linear(hundred, {-1, 1, false}, {0, 4, false}, {});
  linear.mark({0, 1}, 3);
  EXPECT_NE(linear.svg().find("<use href=\"#m3\" x=\"50\" y=\"75\">"), std::string::npos);
}

TEST(Chart, TicksAreRoundNumbers) {
  const std::string linear = Chart(hundred, {-1, 1, false}, {0.3, 2.7, false}, {}).svg();
  for (const char* label : {">-1<", ">0<", ">1<", ">2<"})
    EXPECT_NE(linear.find(label), std::string::npos) << label;
  const std::string decades = Chart(hundred, {1e-3, 1e3}, {0.9, 9}, {}).svg();
  EXPECT_NE(decades.find(">10<tspan dy=\"-5\" font-size=\"9\">3</tspan>"), std::string::npos);
  for (const char* label : {">1<", ">2<", ">5<"})
    EXPECT_NE(decades.find(label), std::string::npos) << label;
}

TEST(Chart, ALonePointKeepsItsMarkerAndSlopesHaveTheirSlope) {
  Chart chart(hundred, {1, 100}, {1e-8, 1}, {});
  chart.slopes({2});
  EXPECT_TRUE(chart.empty()) << "guides are not data";
  chart.curve({{10, 1e-4}}, 2);
  EXPECT_FALSE(chart.empty());
  EXPECT_NE(chart.svg().find("<use href=\"#m2\" x=\"50\" y=\"50\">"), std::string::npos);
  // From (91, 0.5), down by two decades for one to the left: to x = 1.1, 3.8 decades lower.
  EXPECT_NE(chart.svg().find("d=\"M97.9 3.8L2.1 51.7\""), std::string::npos) << chart.svg();
}

TEST(Chart, TextsAreEscaped) {
  Chart chart(hundred, {1, 2}, {1, 2}, {.x = "a<b", .y = "c&d", .description = "\"e\""});
  chart.mark({1, 1}, 0, "", "<i>");
  const std::string html = chart.svg() + legend({{.text = "<u>"}});
  for (const char* escaped : {"a&lt;b", "c&amp;d", "&quot;e&quot;", "&lt;i&gt;", "&lt;u&gt;"})
    EXPECT_NE(html.find(escaped), std::string::npos) << escaped;
}

TEST(Tables, AreEscapedAndEmptyWithoutRows) {
  Table table("a b");
  table.head({{"x<y"}, {.text = "z", .columns = 2}});
  EXPECT_EQ(table.html(), "");
  table.row({.text = "n&m", .title = "\"t\""},
            {{.text = "1", .style = "c"}, {.markup = "<b>2</b>"}});
  EXPECT_EQ(
      table.html(),
      "<div class=\"wide\"><table class=\"a b\"><thead><tr><th>x&lt;y</th><th colspan=\"2\">z"
      "</th></tr>\n</thead><tbody>\n<tr><th title=\"&quot;t&quot;\">n&amp;m</th><td class=\"c\">"
      "1</td><td><b>2</b></td></tr>\n</tbody></table></div>\n");
}

// Signature, and chunks whose lengths lead to one another, the first and the last as they must be.
TEST(Png, IsMadeOfWholeChunks) {
  const std::string png = png_of(3, {0, 1, 0, 1, 0, 1}, {{0, 0, 0, 255}, {255, 0, 0, 0}});
  ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::vector<std::string> chunks;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k)
      length = length << 8 | static_cast<unsigned char>(png[at + k]);
    chunks.push_back(png.substr(at + 4, 4));
    at += 12 + length;
    EXPECT_EQ(chunks.back() == "IEND", at == png.size());
  }
  EXPECT_EQ(chunks, (std::vector<std::string>{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"}));
  // The checksum of an empty IEND, as every PNG has it.
  EXPECT_EQ(png.substr(png.size() - 4), "\xAE\x42\x60\x82");
  EXPECT_THROW(png_of(2, {0, 0, 0}, {{}}), std::logic_error);
}

}  // namespace
}  // namespace odeum::report
