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

#include "odeum/input/yaml_tree.hpp"

namespace odeum {

namespace {

/// A file that is open for reading, closed by its destructor.
class Source {
 public:
  // Not blocking: opening a FIFO without a writer would not return.
  explicit Source(const std::string& path)
      : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)),
        failed_(file_ < 0 || ::fstat(file_, &status_) != 0) {}
  ~Source() {
    if (file_ >= 0) ::close(file_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  bool failed() const { return failed_; }
  const struct stat& status() const { return status_; }
  bool is_regular() const { return S_ISREG(status_.st_mode); }
  /// Adds the file to a text, until that has more than `most` bytes; false: errno says why not.
  bool add_to(std::string& text, std::size_t most) const {
    char buffer[1 << 16];
    while (text.size() <= most) {
      const ssize_t n = ::read(file_, buffer, sizeof buffer);
      if (n == 0) break;
      if (n < 0 && errno != EINTR) return false;
      if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
    }
    return true;
  }

 private:
  int file_;
  struct stat status_ {};
  bool failed_;
};

}  // namespace

std::string read_text_file(const std::string& path, const std::string& name, std::size_t most_bytes,
                           const std::string& raise) {
  const auto refuse = [&](const std::string& what, const std::string& got,
                          const std::string& expected) {
    return InputError(path, {},
                      fmt::format("{}: {}; got {}, expected {}", name, what, got, expected));
  };
  const Source file(path);
  if (file.failed()) throw refuse("cannot be read", std::strerror(errno), "a file");
  const auto mode = file.status().st_mode;
  if (!file.is_regular())
    throw refuse("not a regular file",
                 S_ISDIR(mode)    ? "a directory"
                 : S_ISFIFO(mode) ? "a FIFO"
                                  : "a device",
                 "a file");
  std::string text;
  const bool larger = static_cast<std::uintmax_t>(file.status().st_size) > most_bytes;
  if (!larger && !file.add_to(text, most_bytes))
    throw refuse("cannot be read", std::strerror(errno), "a file");
  if (larger || text.size() > most_bytes)
    throw refuse("too large", fmt::format("more than {} bytes", most_bytes),
                 raise.empty() ? "at most that" : "at most that (" + raise + ")");
  return text;
}

std::optional<std::string> text_of_file(const std::filesystem::path& path) {
  const Source file(path.string());
  std::string text;
  if (file.failed() || !file.is_regular() || !file.add_to(text, text.max_size() - 1))
    return std::nullopt;
  return text;
}

bool write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  return out.good();
}

}  // namespace odeum
