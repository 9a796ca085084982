// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/output_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <thread>
#include <vector>

#include "odeum/record/compress.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::output_folder_test {
namespace {

namespace fs = std::filesystem;
using record::FileError;
using record::OutputFolder;

/// The message of the FileError that `work` throws; empty where it throws none.
template <class Work>
std::string error_of(Work&& work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(OutputFolder, MakesItselfAndWritesWholeFiles) {
  const TemporaryFolder temporary;
  const OutputFolder folder(temporary.path() / "new" / "out");
  folder.write("a.csv", "one\n");
  folder.write("a.csv", "two\n");
  folder.write("sub/folder/b.csv", "");
  EXPECT_EQ(text_of(folder.path() / "a.csv"), "two\n");
  EXPECT_EQ(text_of(folder.path() / "sub/folder/b.csv"), "");
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{".lock", "a.csv", "sub"}));
}

TEST(OutputFolder, CompressesWhatEndsInGzToTheSameBytesEachTime) {
  const TemporaryFolder root;
  const OutputFolder folder(root.path() / "out");
  // Longer than a piece of the stream, and nothing that repeats.
  std::string text;
  for (unsigned k = 0, x = 1; k < 300'000; ++k)
    text += static_cast<char>((x = x * 1664525U + 1013904223U) >> 24U);
  for (const std::string& each : {text, std::string(), std::string("a,b\n")}) {
    folder.write("x.csv.gz", each);
    const std::string bytes = text_of(folder.path() / "x.csv.gz");
    EXPECT_EQ(record::text_of_gzip(bytes), each);
    folder.write("x.csv.gz", each);
    EXPECT_EQ(text_of(folder.path() / "x.csv.gz"), bytes);
    EXPECT_EQ(record::text_of_gzip(bytes.substr(0, bytes.size() - 9)), std::nullopt) << "cut off";
  }
  EXPECT_EQ(record::text_of_gzip("no gzip"), std::nullopt);
  EXPECT_EQ(record::text_of_gzip(""), std::nullopt);
}

TEST(OutputFolder, RefusesASecondHolderAndNamesTheFirst) {
  const TemporaryFolder temporary;
  {
    const OutputFolder first(temporary.path());
    const std::string error = error_of([&] { const OutputFolder second(temporary.path()); });
    EXPECT_NE(error.find("process " + std::to_string(::getpid())), std::string::npos) << error;
    EXPECT_NE(error.find(temporary.path().string()), std::string::npos) << error;
    EXPECT_NE(error_of([&] { const OutputFolder third(temporary.path()); }), "") << "still held";
  }
  EXPECT_EQ(error_of([&] { const OutputFolder again(temporary.path()); }), "");
}

TEST(OutputFolder, RemovesWhatAKilledRunLeftUnfinished) {
  const TemporaryFolder temporary;
  write_text(temporary.path() / ".odeum0.tmp", "half a li");
  const OutputFolder next(temporary.path());
  EXPECT_FALSE(fs::exists(temporary.path() / ".odeum0.tmp"));
}

TEST(OutputFolder, ThreadsWriteTheirFilesAtTheSameTime) {
  const TemporaryFolder temporary;
  const OutputFolder folder(temporary.path());
  const std::string text(100'000, 'x');
  const auto write = [&](const std::string& name) {
    for (int k = 0; k < 10; ++k) folder.write(name, text + name);
  };
  std::thread other(write, "in/a.csv");
  write("b.csv");
  other.join();
  for (const std::string name : {"in/a.csv", "b.csv"})
    EXPECT_EQ(text_of(folder.path() / name), text + name);
}

TEST(OutputFolder, IsFreeAgainWhenItsHolderIsKilled) {
  const TemporaryFolder temporary;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const OutputFolder held(temporary.path());
    [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
    for (;;) ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const std::string error = error_of([&] { const OutputFolder mine(temporary.path()); });
  EXPECT_NE(error.find("process " + std::to_string(child)), std::string::npos) << error;
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(error_of([&] { const OutputFolder mine(temporary.path()); }), "");
}

TEST(OutputFolder, StaysInside) {
  const TemporaryFolder temporary, outside;
  const OutputFolder folder(temporary.path() / "out");
  for (const char* name : {"../x", "a/../../x", "..", "/etc/x", "a/../b"})
    EXPECT_NE(error_of([&] { folder.write(name, "x"); }), "") << name;
  EXPECT_EQ(names_in(temporary.path()), std::vector<std::string>{"out"});
  fs::create_directory_symlink(outside.path(), folder.path() / "link");
  for (const char* name : {"link/x", "link/deeper/x"})
    EXPECT_NE(error_of([&] { folder.write(name, "x"); }), "") << name;
  EXPECT_TRUE(names_in(outside.path()).empty()) << "a link leads out of the folder";
}

TEST(OutputFolder, ReplacesALinkAndDoesNotFollowIt) {
  const TemporaryFolder temporary, outside;
  write_text(outside.path() / "precious", "keep");
  const OutputFolder folder(temporary.path());
  fs::create_symlink(outside.path() / "precious", folder.path() / "a.csv");
  fs::create_symlink(outside.path() / "precious", folder.path() / ".odeum0.tmp");
  folder.write("a.csv", "new");
  EXPECT_EQ(text_of(outside.path() / "precious"), "keep");
  EXPECT_FALSE(fs::is_symlink(folder.path() / "a.csv"));
  EXPECT_EQ(text_of(folder.path() / "a.csv"), "new");
}

TEST(OutputFolder, MayBeALinkItself) {
  const TemporaryFolder temporary, elsewhere;
  fs::create_directory_symlink(elsewhere.path(), temporary.path() / "out");
  const OutputFolder folder(temporary.path() / "out");
  folder.write("sub/a.csv", "x");
  EXPECT_EQ(text_of(elsewhere.path() / "sub/a.csv"), "x");
}

TEST(OutputFolder, RefusesALockThatIsALink) {
  const TemporaryFolder temporary, outside;
  write_text(outside.path() / "precious", "keep");
  fs::create_symlink(outside.path() / "precious", temporary.path() / ".lock");
  EXPECT_NE(error_of([&] { const OutputFolder folder(temporary.path()); }), "");
  EXPECT_EQ(text_of(outside.path() / "precious"), "keep");
}

TEST(OutputFolder, SaysWhereItCannotWrite) {
  const TemporaryFolder temporary;
  write_text(temporary.path() / "file", "");
  for (const fs::path& path : {temporary.path() / "file", temporary.path() / "file" / "out"}) {
    const std::string error = error_of([&] { const OutputFolder folder(path); });
    EXPECT_NE(error.find(path.string()), std::string::npos) << error;
  }
  const OutputFolder folder(temporary.path() / "out");
  fs::create_directory(folder.path() / "taken");
  EXPECT_NE(error_of([&] { folder.write("taken", "x"); }), "") << "a folder has that name";
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{".lock", "taken"}));
}

TEST(OutputFolder, AFailedWriteLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder temporary;
  const OutputFolder folder(temporary.path());
  folder.write("a.csv", "old");
  const std::string large(1 << 20, 'x');
  {
    const FullDisk full(1 << 16);
    EXPECT_NE(error_of([&] { folder.write("a.csv", large); }), "");
  }
  EXPECT_EQ(text_of(folder.path() / "a.csv"), "old");
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{".lock", "a.csv"}));
  folder.write("a.csv", large);
  EXPECT_EQ(text_of(folder.path() / "a.csv"), large);
}

}  // namespace
}  // namespace odeum::tests::output_folder_test
