// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <numeric>
#include <optional>
#include <string_view>

#include "odeum/input/text_file.hpp"
#include "odeum/record/compress.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::record {
namespace {

constexpr std::size_t block = 512;
constexpr std::size_t most_packed = std::size_t{1} << 28U, most_text = std::size_t{1} << 28U;

/// A header of the ustar format (POSIX.1-2001, pax, section "ustar Interchange Format").
struct Header {
  std::array<char, 100> name{};
  std::array<char, 8> mode{}, user{}, group{};
  std::array<char, 12> size{}, time{};
  std::array<char, 8> sum{};
  char kind = '0';
  std::array<char, 100> link{};
  std::array<char, 6> magic{};
  std::array<char, 2> version{};
  std::array<char, 247> more{};
};
static_assert(sizeof(Header) == block);

template <std::size_t N>
void set_octal(std::array<char, N>& field, std::size_t value) {
  fmt::format_to_n(field.data(), N - 1, "{:0{}o}", value, N - 1);
}

/// The number of a field, as it is written above; nothing where it is not one.
template <std::size_t N>
std::optional<std::size_t> octal_of(const std::array<char, N>& field) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + N, value, 8);
  if (error != std::errc() || end == field.data() + N || (*end != 0 && *end != ' ')) return {};
  return value;
}

/// The sum of a header's bytes, with blanks for the sum itself.
std::size_t sum_of(Header header) {
  header.sum.fill(' ');
  std::array<unsigned char, block> bytes{};
  std::memcpy(bytes.data(), &header, block);
  return std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
}

std::string header_of(const std::string& name, std::size_t size) {
  Header header;
  name.copy(header.name.data(), header.name.size() - 1);
  set_octal(header.mode, 0644);
  set_octal(header.user, 0);
  set_octal(header.group, 0);
  set_octal(header.size, size);
  set_octal(header.time, 0);
  std::memcpy(header.magic.data(), "ustar", header.magic.size());
  std::memcpy(header.version.data(), "00", header.version.size());
  set_octal(header.sum, sum_of(header));
  std::string bytes(block, '\0');
  std::memcpy(bytes.data(), &header, block);
  return bytes;
}

std::size_t padded(std::size_t size) { return (size + block - 1) / block * block; }

bool is_table(std::string_view name) {
  return name.ends_with(".csv") && name.size() < 100 && std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
         });
}

constexpr const char* manifest = "manifest.json";

class Unpacking {
 public:
  Unpacking(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), bytes_(bytes) {}

  Archive operator()() {
    Archive archive;
    while (bytes_.size() >= block && bytes_[0] != 0) {
      auto [name, text] = next();
      if (!archive.emplace(name, text).second) fail(fmt::format("has {} twice", name));
    }
    if (bytes_.size() < 2 * block || !std::ranges::all_of(bytes_, [](char c) { return c == 0; }))
      fail("does not end as an archive does");
    if (!archive.contains(manifest)) fail(fmt::format("has no {}", manifest));
    return archive;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw ArchiveError(fmt::format("{}: the archive {}; expected one that odeum report wrote ({})",
                                   path_.string(), what, archive_name));
  }

  std::pair<std::string, std::string> next() {
    Header header;
    std::memcpy(static_cast<void*>(&header), bytes_.data(), block);
    const std::optional<std::size_t> size = octal_of(header.size), sum = octal_of(header.sum);
    if (!size || !sum || *sum != sum_of(header) || header.name.back() != 0)
      fail("has a damaged header");
    const std::string name = header.name.data();
    if (header.kind != '0' || (name != manifest && !is_table(name)))
      fail(fmt::format("has \"{}\", which is neither {} nor a table", shown(name), manifest));
    if (bytes_.size() - block < padded(*size)) fail(fmt::format("is cut off in {}", name));
    std::string text(bytes_.substr(block, *size));
    bytes_.remove_prefix(block + padded(*size));
    return {name, text};
  }

  static std::string shown(std::string name) {
    for (char& c : name)
      if (c < ' ' || c > '~') c = '?';
    return name;
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
};

}  // namespace

std::string archive_of(const std::filesystem::path& folder) {
  constexpr std::string_view packed = ".csv.gz";
  Archive texts;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    const bool is_packed = name.ends_with(packed);
    if (name != manifest && !is_packed && !is_table(name)) continue;
    std::optional<std::string> text = text_of_file(entry.path());
    if (text && is_packed) text = text_of_gzip(*text);
    if (!text) throw FileError(entry.path().string() + ": cannot be read");
    if (is_packed) name.resize(name.size() - packed.size() + std::string_view(".csv").size());
    texts.emplace(std::move(name), std::move(*text));
  }
  std::string bytes;
  for (const auto& [name, text] : texts) {
    bytes += header_of(name, text.size()) + text;
    bytes.resize(padded(bytes.size()));
  }
  bytes.resize(bytes.size() + 2 * block);
  return bytes;
}

Archive read_archive(const std::filesystem::path& path) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  const std::optional<std::string> packed =
      failed || size > most_packed ? std::nullopt : text_of_file(path);
  if (!packed)
    throw ArchiveError(
        fmt::format("{}: got {}, expected an archive of at most {} MB", path.string(),
                    failed ? "a file that can't be read" : fmt::format("{} MB", size / 1'000'000),
                    most_packed / 1'000'000));
  const std::optional<std::string> bytes = text_of_gzip(*packed, most_text);
  if (!bytes)
    throw ArchiveError(
        fmt::format("{}: the archive is damaged or cut off, or has more than {} MB of text",
                    path.string(), most_text / 1'000'000));
  return Unpacking(path, *bytes)();
}

}  // namespace odeum::record
