// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/raster.hpp"

#include <gtest/gtest.h>

#include "odeum/core/shell_word.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::trajectories::film_test {
namespace {

std::array<int, 3> pixel(const std::vector<std::uint8_t>& rgb, std::size_t width, std::size_t x,
                         std::size_t y) {
  const std::size_t at = 3 * (y * width + x);
  return {rgb[at], rgb[at + 1], rgb[at + 2]};
}

TEST(Picture, TheNearerCoversTheFartherInAnyOrder) {
  for (const bool far_first : {true, false}) {
    Picture picture(40, 20, {0, 0, 0});
    const std::array<ScreenPoint, 3> near{{{5, 2, 1}, {35, 2, 1}, {20, 18, 1}}},
        far{{{0, 0, 2}, {40, 0, 2}, {0, 20, 2}}};
    if (far_first) picture.triangle(far, {1, 0, 0});
    picture.triangle(near, {0, 1, 0});
    if (!far_first) picture.triangle(far, {1, 0, 0});
    const auto rgb = picture.rgb();
    EXPECT_EQ(pixel(rgb, 40, 20, 8), (std::array{0, 255, 0}));
    EXPECT_EQ(pixel(rgb, 40, 2, 10), (std::array{255, 0, 0}));
    EXPECT_EQ(pixel(rgb, 40, 38, 18), (std::array{0, 0, 0}));
  }
}

TEST(Picture, LinesAndBallsHaveTheirWidths) {
  Picture picture(80, 30, {0, 0, 0});
  picture.line({5, 15.5, 1}, {45, 15.5, 1}, {1, 1, 1}, 1);
  picture.ball({65, 15, 1}, 10, 0.1, {0, 0, 1});
  const auto rgb = picture.rgb();
  for (std::size_t x = 6; x < 44; ++x) EXPECT_EQ(pixel(rgb, 80, x, 15)[0], 255) << x;
  EXPECT_EQ(pixel(rgb, 80, 15, 17)[0], 0);
  int blue = 0;  // the disc's area of 314 pixels, but for those at its rim
  for (std::size_t k = 2; k < rgb.size(); k += 3) blue += rgb[k] > 0 && rgb[k - 1] == 0 ? 1 : 0;
  EXPECT_NEAR(blue, 314, 35);
}

TEST(Picture, IsAPngFile) {
  const std::string png = png_of(3, 2, std::vector<std::uint8_t>(18, 7));
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 12), std::string("IHDR\0\0\0\3\0\0\0\2", 12));
  // The bytes of the end are the same in every file.
  EXPECT_EQ(png.substr(png.size() - 12), std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12));
}

TEST(Film, OfAScenesRunIsWrittenWithTheLineOfFfmpeg) {
  const tests::TemporaryFolder folder;
  // A name that a shell and the pattern of ffmpeg would read otherwise.
  const std::string out = (folder.path() / "it's 5%").string();
  const tests::Result result = tests::shell(
      "odeum run spring_explicit_euler --solver explicit_euler --step 0.05 --until 1 --no-truth "
      "--frames 3 --out " +
      shell_word(out));
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("ffmpeg -framerate 2 -i " + shell_word(out + "%/film/%04d.png") +
                               " -pix_fmt yuv420p " + shell_word(out + "/film.mp4")),
            std::string::npos)
      << result.output;
  for (const char* name : {"0001", "0002", "0003"})
    EXPECT_GT(tests::text_of(out + "/film/" + name + ".png").size(), 1000U);
  EXPECT_FALSE(std::filesystem::exists(out + "/film/0004.png"));
  EXPECT_EQ(tests::shell("odeum run flag --frames 3").code, 2);
  EXPECT_EQ(tests::shell("odeum run lotka_volterra --solver rk4 --step 0.1 --frames 3").code, 2);
}

}  // namespace
}  // namespace odeum::trajectories::film_test
