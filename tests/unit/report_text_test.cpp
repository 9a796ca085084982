// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/markdown.hpp"
#include "odeum/report/panels.hpp"
#include "odeum/report/plots.hpp"
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
            "<h3>One</h3>\n<p>two lines</p>\n<ul><li>a b</li>\n<li>c</li>\n</ul>\n"
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

TEST(Plots, RangesPassOverWhatNoLogarithmHas) {
  LogRange range;
  for (const double value : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    range.include(value);
  EXPECT_TRUE(range.empty());
  range.include(2);
  range.include(0.5);
  EXPECT_EQ(range.low, 0.5);
  EXPECT_EQ(range.high, 2);
}

TEST(Plots, TidyingKeepsALonePointsMarkerAndDropsALines) {
  const std::string line = "<path stroke='rgb(  1,   1,   3)'  d='M1.00,2.00 L3.00,4.00  '/>\n\t";
  const std::string marker =
      "<use xlink:href='#gpPt3' transform='translate(1.00,2.00) scale(2.06)' "
      "color='rgb(  1,   1,   3)'/>\n";
  const auto tidied = [](const std::string& body) {
    return tidy_svg("<svg><g id=\"gnuplot_canvas\"><defs>x</defs><g>" + body + "</g></g></svg>",
                    "d");
  };
  EXPECT_NE(tidied(line + marker + marker).find("class=\"c3\""), std::string::npos);
  EXPECT_EQ(tidied(line + marker + marker).find("<use"), std::string::npos);
  EXPECT_NE(tidied(marker).find("<use href=\"#m3\" x=\"1\" y=\"2\"/>"), std::string::npos);
  EXPECT_EQ(tidy_svg("not an image", "d"), "");
}

TEST(Plots, TidyingShortensCoordinatesButNoLabel) {
  const std::string tidied = tidy_svg(
      "<svg><defs>x</defs><g><path d='M1.25,20.04 L.5,3'/><text>0.025</text></g></svg>", "d 1.25");
  EXPECT_NE(tidied.find("M1.2,20 L.5,3"), std::string::npos) << tidied;
  EXPECT_NE(tidied.find(">0.025<"), std::string::npos) << tidied;
  EXPECT_NE(tidied.find("\"d 1.25\""), std::string::npos) << tidied;
}

}  // namespace
}  // namespace odeum::report
