// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace odeum::record {

/// An error of reading or writing a file; exit code 4 of the command line.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An open file, closed by its destructor.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  /// False where the system reports that not all was written.
  bool close();
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Writes all of a text to an open file; false where the system reports an error (errno).
bool write_all(const OpenFile& file, std::string_view text);

/// The folder that a run writes to. The constructor makes the folder where it is missing and takes
/// its lock; a second run is refused with the holder's name. A file appears complete under its name
/// or not at all. Throws FileError.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes `text` to a file of that name (which may have folders of its own, never `..` and
  /// never a link): to a temporary first, flushed and checked, then renamed. A link of that name is
  /// replaced, not followed. Where the name ends in .gz, the file is the text compressed.
  void write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
  OpenFile lock_;
};

}  // namespace odeum::record
