// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace odeum::adapters::fmi {

/// A folder of the cache folder, else of the system's temporary one, removed with all that is in it
/// at the end; where the program was killed, by the next one that uses the cache folder.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Unpacks modelDescription.xml, binaries and resources of a ZIP archive into a folder. Throws
/// LoadError, without a file name, for a file that is not a whole archive, has names that point out
/// of the folder, or is larger than 1 GB unpacked.
void unpack(const std::string& archive, const std::filesystem::path& folder);

}  // namespace odeum::adapters::fmi
