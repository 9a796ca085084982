// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/file_sum.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.hpp"

namespace odeum::file_sum_test {
namespace {

TEST(FileSum, TellsAChangeOfAnyByte) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "file").string();
  const auto sum_with = [&](std::size_t size, std::size_t at, char byte) {
    std::string bytes(size, 'a');
    if (at < size) bytes[at] = byte;
    std::ofstream(path, std::ios::binary) << bytes;
    return sum_of_file(path);
  };
  constexpr std::size_t block = 65'536;
  for (const std::size_t size : {std::size_t{10}, block, 3 * block + 5}) {
    const std::string same = sum_with(size, size, 'a');
    EXPECT_EQ(same.size(), 16U);
    EXPECT_EQ(sum_with(size, size, 'a'), same);
    for (const std::size_t at : {std::size_t{0}, size / 2, size - 1})
      EXPECT_NE(sum_with(size, at, 'b'), same) << at << " of " << size;
    EXPECT_NE(sum_with(size + 1, size + 1, 'a'), same);
  }
  EXPECT_EQ(sum_of_file("/nothing/here"), sum_of_file("/nothing/there"));
}

}  // namespace
}  // namespace odeum::file_sum_test
