// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odeum::record {

/// Results that runs of the program have measured, in a folder that they share. A file for each
/// text of dependencies, which identifies all that its results depend on; in it a line for each
/// result. Each line has a checksum, and damaged lines are skipped. Nothing throws: unreadable
/// results count as absent, and problem() tells why writing failed.
class Store {
 public:
  /// The end of the names of its files.
  static constexpr std::string_view extension = ".results";

  /// Makes the folder, and removes the files that were used least recently until the rest has at
  /// most `most_bytes`.
  explicit Store(std::filesystem::path folder, std::uintmax_t most_bytes = 1U << 30);

  /// Takes results from another store's folder too.
  void read_also(const std::filesystem::path& folder) { also_.push_back(folder); }

  /// The result of a key, which is then no longer held in memory. Dependencies, key and result may
  /// have any characters. Safe to call from several threads, as add is.
  std::optional<std::string> take(const std::string& dependencies, const std::string& key);
  /// Keeps a result, also for other runs that go on at the same time.
  void add(const std::string& dependencies, const std::string& key, const std::string& result);

  std::size_t taken() const { return taken_; }
  std::size_t added() const { return added_; }
  const std::filesystem::path& folder() const { return folder_; }
  /// Why results are not kept; empty: they are.
  const std::string& problem() const { return problem_; }

 private:
  using Results = std::map<std::string, std::string>;
  std::filesystem::path file_of(const std::string& dependencies) const;
  Results& results_of(const std::string& dependencies);
  void append(const std::filesystem::path& path, const std::string& dependencies,
              const std::string& line);

  void read(const std::filesystem::path& path, const std::string& dependencies, Results& into);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> also_;
  std::mutex mutex_;
  std::map<std::string, Results> held_;  ///< by dependencies, once a result was asked for
  std::size_t taken_ = 0, added_ = 0;
  std::string problem_;
};

}  // namespace odeum::record
