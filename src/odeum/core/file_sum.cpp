// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/file_sum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <vector>

#include "odeum/core/checksum.hpp"

namespace odeum {

std::string sum_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  constexpr std::size_t words = 1U << 13U, lanes = 4;
  std::vector<std::uint64_t> block(words);
  // Independent sums, since each product waits for the one before.
  std::array<std::uint64_t, lanes> sums{1, 2, 3, 4};
  do {
    std::ranges::fill(block, 0);
    in.read(reinterpret_cast<char*>(block.data()), words * sizeof(std::uint64_t));
    for (std::size_t k = 0; k < words; k += lanes)
      for (std::size_t lane = 0; lane < lanes; ++lane)
        sums[lane] = (std::rotl(sums[lane], 29) ^ block[k + lane]) * 0x9e3779b97f4a7c15U;
  } while (in);
  std::string all;
  for (const std::uint64_t sum : sums) all += fmt::format("{:x}", sum);
  return fmt::format("{:016x}", checksum(all));
}

}  // namespace odeum
