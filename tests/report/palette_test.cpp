// SPDX-License-Identifier: BSD-3-Clause
// The colours of the page's curves, as readers with the usual colour deficiencies see them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/report/shared_files.hpp"

namespace odeum::report::palette_test {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

// Machado, Oliveira and Fernandes (2009), doi:10.1109/TVCG.2009.113, complete deficiencies, on
// linear sRGB.
constexpr Matrix normal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix protanopia{{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranopia{{{0.367322, 0.860646, -0.227968},
                               {0.280085, 0.672501, 0.047413},
                               {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix tritanopia{{{1.255528, -0.076749, -0.178779},
                             {-0.078411, 0.930809, 0.147602},
                             {0.004733, 0.691367, 0.303900}}};
// Linear sRGB to XYZ with the white point D65, IEC 61966-2-1.
constexpr Matrix to_xyz{{{0.4124564, 0.3575761, 0.1804375},
                         {0.2126729, 0.7151522, 0.0721750},
                         {0.0193339, 0.1191920, 0.9503041}}};
constexpr Triple white{0.95047, 1, 1.08883};

Triple product(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
  return result;
}

/// The linear components of the colour `--name` in a part of the style sheet.
Triple colour(const std::string& style, const std::string& name) {
  const std::size_t at = style.find("--" + name + ": #");
  if (at == std::string::npos) throw std::runtime_error("no colour " + name);
  Triple linear{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(style.substr(at + name.size() + 5 + 2 * i, 2), nullptr, 16) / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return linear;
}

/// CIE L*a*b* of a colour that a reader sees so.
Triple lab(const Matrix& sight, const Triple& linear) {
  Triple seen = product(sight, linear);
  for (double& c : seen) c = std::clamp(c, 0.0, 1.0);
  Triple f = product(to_xyz, seen);
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = f[i] / white[i];
    f[i] = x > 216.0 / 24389 ? std::cbrt(x) : (24389.0 / 27 * x + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double luminance(const Triple& linear) { return product(to_xyz, linear)[1]; }

/// The page's colours for light and for dark: what follows the second `--paper` is for dark.
std::array<std::string, 2> schemes() {
  const std::string style = shared_text("viewer/page.css");
  const std::size_t dark = style.find("--paper:", style.find("--paper:") + 1);
  return {style.substr(0, dark), style.substr(dark)};
}

double least_distance(const Matrix& sight, const std::vector<Triple>& colours) {
  double least = INFINITY;
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Triple a = lab(sight, colours[i]), b = lab(sight, colours[j]);
      least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  return least;
}

std::vector<Triple> curve_colours(const std::string& scheme) {
  std::vector<Triple> colours;
  for (std::size_t i = 0; i < 8; ++i) colours.push_back(colour(scheme, "s" + std::to_string(i)));
  return colours;
}

// A distance of 2.3 can just be seen side by side (Mahy, Van Eycken and Oosterlinck 1994); thin
// lines apart from each other need several times that.
TEST(Palette, CurvesAreToldApartWithEveryColourDeficiency) {
  for (const std::string& scheme : schemes()) {
    const std::vector<Triple> colours = curve_colours(scheme);
    for (const Matrix& sight : {normal, protanopia, deuteranopia})
      EXPECT_GT(least_distance(sight, colours), 20);
    EXPECT_GT(least_distance(tritanopia, colours), 15);
  }
}

// Printed in grey, and with no sight of colour at all, lightness is what is left.
TEST(Palette, CurvesDifferInLightness) {
  for (const std::string& scheme : schemes()) {
    std::vector<double> lightness;
    for (const Triple& c : curve_colours(scheme)) lightness.push_back(lab(normal, c)[0]);
    std::sort(lightness.begin(), lightness.end());
    for (std::size_t i = 1; i < lightness.size(); ++i)
      EXPECT_GT(lightness[i] - lightness[i - 1], 5);
  }
}

// WCAG 2.1, 1.4.11: graphics have a contrast of 3 against what is beside them; 1.4.3: text of 4.5.
TEST(Palette, CurvesAndTextsStandOutFromThePaper) {
  const auto contrast = [](const Triple& a, const Triple& b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
  };
  for (const std::string& scheme : schemes()) {
    const Triple paper = colour(scheme, "paper");
    for (const Triple& c : curve_colours(scheme)) EXPECT_GT(contrast(c, paper), 3);
    for (const char* text : {"ink", "dim", "link", "bad"})
      for (const char* ground : {"paper", "card"})
        EXPECT_GT(contrast(colour(scheme, text), colour(scheme, ground)), 4.5) << text;
    for (const char* ground : {"confirmed", "higher", "lower", "floors", "undetermined", "failed"})
      EXPECT_GT(contrast(colour(scheme, "ink"), colour(scheme, ground)), 4.5) << ground;
  }
}

}  // namespace
}  // namespace odeum::report::palette_test
