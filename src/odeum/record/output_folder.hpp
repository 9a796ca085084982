// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace odeum::record {

/// What reading and writing files can come to; the command line answers it with exit code 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An open file, closed with its owner.
class OpenFile {
 public:
  explicit OpenFile(int descriptor = -1) : descriptor_(descriptor) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  void reset(int descriptor) {
    close();
    descriptor_ = descriptor;
  }
  /// False where the system says that not all was written.
  bool close();
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

/// The folder that a run writes to. Creating one makes the folder where it is missing and takes its
/// lock; a second run is refused with the holder's name. Every file appears whole under its name
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
  /// replaced, not followed.
  void write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
  OpenFile lock_;
};

/// What a study has finished so far, kept in its output folder, so that `--resume` after a kill can
/// go on where it ended. One line a finished piece of work: a key and its result. A line that was
/// not written whole is ignored. The journal holds a fingerprint of the run's options: a journal of
/// another run is not used.
class Journal {
 public:
  /// Opens `<folder>/.<study>.journal`; starts it anew unless `resume` and the fingerprint agrees.
  Journal(const OutputFolder& folder, const std::string& study, const std::string& fingerprint,
          bool resume);
  /// The result that is held for a key. Key and result may have any characters.
  std::optional<std::string> find(const std::string& key) const;
  /// Adds a result and flushes it; where that fails (FileError), nothing of it stays in the file.
  /// Safe to call from several threads.
  void add(const std::string& key, const std::string& result);
  /// Removes the file: the study is complete.
  void finish();
  std::size_t size() const { return held_.size(); }

 private:
  std::filesystem::path path_;
  std::map<std::string, std::string> held_;
  std::mutex mutex_;
  OpenFile file_;
  std::size_t length_ = 0;  ///< of the whole lines in the file
};

}  // namespace odeum::record
