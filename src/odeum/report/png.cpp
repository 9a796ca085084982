// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/png.hpp"

#include <zlib.h>

#include <stdexcept>

#include "odeum/record/compress.hpp"

namespace odeum::report {
namespace {

std::string big_endian(std::size_t number) {
  std::string bytes(4, '\0');
  for (std::size_t k = 0; k < 4; ++k) bytes[k] = static_cast<char>(number >> (24 - 8 * k) & 0xff);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto checksum =
      ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(data.size()) + body + big_endian(checksum);
}

}  // namespace

std::string png_of(std::size_t width, const std::vector<std::uint8_t>& pixels,
                   const std::vector<Colour>& palette) {
  const std::size_t height = pixels.size() / width;
  if (palette.size() > 16 || height * width != pixels.size())
    throw std::logic_error("png_of: a palette of more than 16 colours, or a row that is not whole");
  std::string colours, opacities, rows;
  for (const Colour& colour : palette) {
    for (const std::size_t k : {0, 1, 2}) colours += static_cast<char>(colour[k]);
    opacities += static_cast<char>(colour[3]);
  }
  for (std::size_t y = 0; y < height; ++y) {
    rows += '\0';  // the row is not filtered
    for (std::size_t x = 0; x < width; x += 2) {
      const std::uint8_t* pixel = &pixels[y * width + x];
      rows += static_cast<char>(pixel[0] << 4 | (x + 1 < width ? pixel[1] : 0));
    }
  }
  // Four bits a pixel, indices into a palette, neither filters nor interlacing of their own.
  const std::string format = {4, 3, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", big_endian(width) + big_endian(height) + format) +
         chunk("PLTE", colours) + chunk("tRNS", opacities) + chunk("IDAT", record::zlib_of(rows)) +
         chunk("IEND", "");
}

}  // namespace odeum::report
