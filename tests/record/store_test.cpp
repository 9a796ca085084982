// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/store.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "support/temporary_folder.hpp"

namespace odeum::tests::store_test {
namespace {

namespace fs = std::filesystem;
using record::Store;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Store, HoldsWhatWasAddedWhateverItsCharacters) {
  const TemporaryFolder folder;
  const std::vector<std::string> texts{"plain",
                                       "",
                                       "tab\there",
                                       "two\nlines\n",
                                       "back\\slash\\",
                                       "\\n is not a line",
                                       "\\",
                                       std::string("nul\0!", 5),
                                       "\r\n",
                                       "h\xc3\xa4"};
  Store store(folder.path());
  for (const std::string& dependencies : texts)
    for (const std::string& key : texts) store.add(dependencies, key, key + dependencies);
  EXPECT_EQ(store.problem(), "");
  Store again(folder.path());
  for (const std::string& dependencies : texts)
    for (const std::string& key : texts)
      EXPECT_EQ(again.take(dependencies, key), key + dependencies);
  EXPECT_EQ(again.take("plain", "never added"), std::nullopt);
  EXPECT_EQ(again.take("never was", "plain"), std::nullopt);
  EXPECT_EQ(again.taken(), store.added());
}

// A line cut anywhere, and one in which a character changed, is not a result and spoils no other.
TEST(Store, ALineThatIsNotAsItWasWrittenIsNone) {
  const TemporaryFolder folder;
  Store(folder.path()).add("dependencies", "first", "1");
  const fs::path path = files_in(folder.path()).front();
  const std::size_t one = text_of(path).size();
  Store(folder.path()).add("dependencies", "second", "2");
  const std::string whole = text_of(path);
  for (std::size_t length = one; length <= whole.size(); ++length) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, length);
    Store(folder.path()).add("dependencies", "third", "3");
    Store store(folder.path());
    EXPECT_EQ(store.take("dependencies", "first"), "1") << length;
    EXPECT_EQ(store.take("dependencies", "second").has_value(), length + 1 >= whole.size())
        << length;
    EXPECT_EQ(store.take("dependencies", "third"), "3") << length;
  }
  std::string changed = whole;
  changed[one - 2] = '9';
  std::ofstream(path, std::ios::binary) << changed;
  Store store(folder.path());
  EXPECT_EQ(store.take("dependencies", "first"), std::nullopt);
  EXPECT_EQ(store.take("dependencies", "second"), "2");
}

TEST(Store, TakesResultsOfSeveralThreadsAndRunsAtOnce) {
  const TemporaryFolder folder;
  Store one(folder.path()), other(folder.path());
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < 4; ++thread)
      threads.emplace_back([&, thread] {
        for (int i = 0; i < 100; ++i)
          (thread % 2 ? one : other)
              .add("dependencies", std::to_string(thread) + ":" + std::to_string(i),
                   std::string(500, 'x'));
      });
  }
  Store all(folder.path());
  for (int thread = 0; thread < 4; ++thread)
    for (int i = 0; i < 100; ++i)
      EXPECT_TRUE(all.take("dependencies", std::to_string(thread) + ":" + std::to_string(i)));
}

TEST(Store, RemovesWhatWasUsedLeastRecently) {
  const TemporaryFolder folder;
  for (const char* dependencies : {"a", "b", "c"})
    Store(folder.path()).add(dependencies, "key", std::string(1000, 'x'));
  for (const fs::path& path : files_in(folder.path()))
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_TRUE(Store(folder.path()).take("b", "key"));  // now it was used last
  { const Store smaller(folder.path(), 1500); }
  Store store(folder.path());
  EXPECT_FALSE(store.take("a", "key"));
  EXPECT_TRUE(store.take("b", "key"));
  EXPECT_FALSE(store.take("c", "key"));
}

TEST(Store, SaysWhyItKeepsNothingAndGoesOn) {
  Store nowhere("/dev/null/results");
  EXPECT_NE(nowhere.problem(), "");
  nowhere.add("dependencies", "key", "result");
  EXPECT_EQ(nowhere.take("dependencies", "key"), std::nullopt);
  EXPECT_EQ(nowhere.added(), 0U);
}

}  // namespace
}  // namespace odeum::tests::store_test
