// SPDX-License-Identifier: BSD-3-Clause
#include "fmi/archive.hpp"

#include <unistd.h>
#include <zip.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>

#include "odeum/formula/cache.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = 1'000'000'000;
constexpr zip_int64_t most_entries = 100'000;

struct CloseZip {
  void operator()(zip_t* zip) const { zip_discard(zip); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// Whether a name stays in the folder into which it is unpacked.
bool stays_inside(const std::string& name) {
  if (name.empty() || name.front() == '/' || name.find('\\') != std::string::npos ||
      name.find(':') != std::string::npos)
    return false;
  for (const fs::path& part : fs::path(name))
    if (part == "..") return false;
  return true;
}

bool is_wanted(const std::string& name) {
  return name == "modelDescription.xml" || name.starts_with("binaries/") ||
         name.starts_with("resources/");
}

/// Writes one entry; `budget` is what may still be unpacked, in bytes.
void unpack_entry(zip_t* zip, zip_uint64_t index, const fs::path& to, std::uint64_t& budget) {
  fs::create_directories(to.parent_path());
  const std::unique_ptr<zip_file_t, CloseZip> file(zip_fopen_index(zip, index, 0));
  if (!file)
    throw LoadError(
        fmt::format("{} in it cannot be read: {}", to.filename().string(), zip_strerror(zip)));
  std::ofstream out(to, std::ios::binary);
  std::vector<char> part(1 << 16);
  for (;;) {
    const zip_int64_t n = zip_fread(file.get(), part.data(), part.size());
    if (n < 0)
      throw LoadError(fmt::format("{} in it is damaged: {}", to.filename().string(),
                                  zip_file_strerror(file.get())));
    if (n == 0) break;
    if (static_cast<std::uint64_t>(n) > budget)
      throw LoadError(fmt::format("it unpacks to more than {} bytes", most_bytes));
    budget -= static_cast<std::uint64_t>(n);
    out.write(part.data(), n);
  }
  out.close();
  if (!out) throw LoadError(fmt::format("{} cannot be written", to.string()));
}

struct Entry {
  zip_uint64_t index;
  std::string name;
};

/// The entries that are unpacked, all of them looked at before anything is written. What they say
/// of their size need not be true: unpack_entry counts.
std::vector<Entry> wanted_entries(zip_t* zip, zip_int64_t entries) {
  std::vector<Entry> wanted;
  double total = 0;
  for (zip_int64_t i = 0; i < entries; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const char* const raw = zip_get_name(zip, index, 0);
    const std::string name = raw ? raw : "";
    if (!stays_inside(name))
      throw LoadError(fmt::format("has an entry that would be written outside of its folder: {}",
                                  foreign::cleaned(name.c_str())));
    if (!is_wanted(name) || name.back() == '/') continue;
    zip_stat_t status;
    zip_stat_init(&status);
    if (zip_stat_index(zip, index, 0, &status) == 0 && (status.valid & ZIP_STAT_SIZE) != 0)
      total += static_cast<double>(status.size);
    wanted.push_back({index, name});
  }
  if (total > static_cast<double>(most_bytes))
    throw LoadError(
        fmt::format("its entries have {:.0f} bytes, at most {} are unpacked", total, most_bytes));
  return wanted;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  // What a killed run leaves in the cache folder the next one removes.
  const std::string cache = formula::cache_folder();
  std::string name =
      formula::unfinished_in(cache.empty() ? fs::temp_directory_path() : fs::path(cache));
  if (!mkdtemp(name.data()))
    throw LoadError(fmt::format("no folder {} could be made: {}", name, std::strerror(errno)));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void unpack(const std::string& archive, const fs::path& folder) {
  int code = 0;
  const std::unique_ptr<zip_t, CloseZip> zip(zip_open(archive.c_str(), ZIP_RDONLY, &code));
  if (!zip) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string why = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw LoadError(fmt::format("is not a whole ZIP archive: {}", why));
  }
  const zip_int64_t entries = zip_get_num_entries(zip.get(), 0);
  if (entries > most_entries)
    throw LoadError(fmt::format("has {} entries, at most {} are read", entries, most_entries));
  const std::vector<Entry> wanted = wanted_entries(zip.get(), entries);
  std::uint64_t budget = most_bytes;
  for (const Entry& entry : wanted)
    unpack_entry(zip.get(), entry.index, folder / entry.name, budget);
}

}  // namespace odeum::adapters::fmi
