// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace odeum::record {

/// An archive that can't be read; the message says why. Exit code 2.
class ArchiveError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The texts of an archive by their names: manifest.json and the tables of a folder of results.
using Archive = std::map<std::string, std::string>;

/// The name of the archive in such a folder.
inline constexpr const char* archive_name = "results.tar.gz";

/// The manifest and all tables of a folder, those that are compressed unpacked, as a .tar file that
/// any archiver opens and that is compressed as it is written; the same bytes for the same texts.
/// Throws FileError for a table that can't be read.
std::string archive_of(const std::filesystem::path& folder);

/// Reads such a file into memory; nothing is unpacked to a disk. Throws ArchiveError for what is
/// not one: bytes that are damaged or cut off, more than a quarter of a gigabyte of text, names
/// with folders, links, and anything but a manifest and tables.
Archive read_archive(const std::filesystem::path& path);

}  // namespace odeum::record
