// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/compress.hpp"

#include <zlib.h>

#include <new>

namespace odeum::report {

std::string zlib_of(std::string_view bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string packed(size, '\0');
  if (::compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

}  // namespace odeum::report
