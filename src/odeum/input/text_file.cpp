// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include "odeum/input/yaml_tree.hpp"

namespace odeum {

std::string read_text_file(const std::string& path, const std::string& name, std::size_t most_bytes,
                           const std::string& raise) {
  const auto refuse = [&](const std::string& what, const std::string& got,
                          const std::string& expected) {
    return InputError(path, {},
                      fmt::format("{}: {}; got {}, expected {}", name, what, got, expected));
  };
  // Not blocking: opening a FIFO without a writer would not return.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) throw refuse("cannot be read", std::strerror(errno), "a file");
  struct Closer {
    int file;
    ~Closer() { ::close(file); }
  } const closer{file};
  struct stat status {};
  if (::fstat(file, &status) != 0) throw refuse("cannot be read", std::strerror(errno), "a file");
  if (!S_ISREG(status.st_mode))
    throw refuse("not a regular file",
                 S_ISDIR(status.st_mode)    ? "a directory"
                 : S_ISFIFO(status.st_mode) ? "a FIFO"
                                            : "a device",
                 "a file");
  const auto too_large = [&] {
    return refuse("too large", fmt::format("more than {} bytes", most_bytes),
                  raise.empty() ? "at most that" : "at most that (" + raise + ")");
  };
  if (static_cast<std::uintmax_t>(status.st_size) > most_bytes) throw too_large();
  std::string text;
  char buffer[1 << 16];
  while (true) {
    const ssize_t n = ::read(file, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw refuse("cannot be read", std::strerror(errno), "a file");
    if (n == 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
    if (text.size() > most_bytes) throw too_large();
  }
}

std::optional<std::string> text_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

bool write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  return out.good();
}

}  // namespace odeum
