// SPDX-License-Identifier: BSD-3-Clause
// What the program keeps between runs, and the compiler that it starts: damage, strangers, limits.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include "odeum/formula/cache.hpp"
#include "odeum/input/text_file.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::cache_test {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
 protected:
  Cache() {
    tests::write_text(folder_.path() / "a.yaml",
                      "states: {y: 1}\nequations: {y: -y*cos(t)}\ntime: {end: 2}\n");
  }
  std::string command(const std::string& variables, const std::string& file = "a") const {
    const std::string folder = folder_.path().string();
    return "export XDG_CACHE_HOME='" + folder + "' " + variables +
           " && exec '" ODEUM_BINARY "' run '" + folder + "/" + file +
           ".yaml' --solver rk4 --step 0.01";
  }
  std::string run(const std::string& variables = "", const std::string& file = "a") const {
    const tests::Result result = tests::shell(command(variables, file));
    EXPECT_EQ(result.code, 0) << result.output;
    return result.output;
  }
  fs::path cache() const { return folder_.path() / "odeum"; }
  /// The only entry with this extension, or one more than those.
  fs::path entry(const std::string& extension, const fs::path& but = {}) const {
    for (const auto& each : fs::directory_iterator(cache()))
      if (each.path().extension() == extension && each.path() != but) return each.path();
    return {};
  }
  void script(const std::string& text) const {
    tests::write_text(folder_.path() / "cc", "#!/bin/sh\n" + text);
    fs::permissions(folder_.path() / "cc", fs::perms::owner_all);
  }
  std::size_t unfinished() const {
    std::size_t found = 0;
    for (const auto& each : fs::directory_iterator(cache()))
      found += each.path().filename().string().starts_with("work-") ? 1 : 0;
    return found;
  }
  tests::TemporaryFolder folder_;
};

// One digit of the reference gave an error of 0.01 against a truth "known to 1e-14".
TEST_F(Cache, ADamagedReferenceIsMadeAgain) {
  const std::string first = run();
  const fs::path file = entry(".reference");
  std::string text = tests::text_of(file);
  const std::string whole = text;
  text[text.find("0.", text.find("\n0.5 ") + 5) + 3] ^= 1;
  ASSERT_NE(text, whole);
  tests::write_text(file, text);
  const std::string second = run();
  EXPECT_EQ(second.substr(second.find("\nerror ")), first.substr(first.find("\nerror ")));
  EXPECT_EQ(tests::text_of(file), whole);
}

// It was computed again by every run with --out; other parameters have another one.
TEST_F(Cache, KeepsTheTruthAtTheOutputsOfARun) {
  const std::string folder = folder_.path().string();
  const auto run = [&](const std::string& words) {
    const tests::Result result = tests::shell(
        "export XDG_CACHE_HOME='" + folder +
        "' && exec '" ODEUM_BINARY "' run lotka_volterra --solver rk4 --step 0.1 --out '" + folder +
        "/out' " + words);
    EXPECT_EQ(result.code, 0) << result.output;
    return result.output.substr(result.output.find("\nerror "));
  };
  const auto entries = [&] {
    std::map<fs::path, fs::file_time_type> all;
    for (const auto& each : fs::directory_iterator(cache()))
      if (each.path().extension() == ".reference") all[each.path()] = each.last_write_time();
    return all;
  };
  const std::string first = run("");
  const auto kept = entries();
  EXPECT_EQ(kept.size(), 1U);
  EXPECT_EQ(run(""), first);
  EXPECT_EQ(entries(), kept);
  EXPECT_NE(run("--set a=1.4"), first);
  EXPECT_EQ(entries().size(), 2U);
}

// Also after days where its process is at work, at once where that is gone.
TEST_F(Cache, WhatAKilledRunLeftGoesAndWhatIsInUseStays) {
  run();
  const std::string pid = std::to_string(::getpid());
  std::string used = formula::unfinished_in(cache()), left = used;
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  left.replace(left.rfind(pid), pid.size(), std::to_string(gone));
  for (const std::string& folder : {used, left}) {
    fs::create_directories(fs::path(folder) / "resources");
    fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::hours(48));
  }
  run();  // only reads
  EXPECT_TRUE(fs::exists(left));
  tests::write_text(folder_.path() / "b.yaml",
                    "states: {y: 1}\nequations: {y: y*cos(t)}\ntime: {end: 2}\n");
  run("", "b");
  EXPECT_TRUE(fs::exists(used));
  EXPECT_FALSE(fs::exists(left));
}

// Another problem's object was loaded and run in its place.
TEST_F(Cache, AnotherObjectIsMadeAgain) {
  const std::string first = run();
  const fs::path object = entry(".so");
  tests::write_text(folder_.path() / "b.yaml",
                    "states: {y: 1}\nequations: {y: y*cos(t)}\ntime: {end: 2}\n");
  run("", "b");
  const fs::path other = entry(".so", object);
  fs::copy_file(other, object, fs::copy_options::overwrite_existing);
  const std::string second = run();
  EXPECT_NE(text_of_file(object), text_of_file(other));
  EXPECT_EQ(second.substr(second.find("\nstate ")), first.substr(first.find("\nstate ")));
  EXPECT_NE(run().find("from the cache"), std::string::npos);
}

TEST_F(Cache, AFolderInWhichOthersMayWriteIsNotUsed) {
  fs::create_directory(cache());
  ASSERT_EQ(::chmod(cache().c_str(), 0777), 0);
  run();
  EXPECT_TRUE(fs::is_empty(cache()));
}

TEST_F(Cache, AFolderOfAnotherOwnerIsNotUsed) {
  fs::create_directory(cache());
  fs::permissions(cache(), fs::perms::owner_all);
  constexpr uid_t nobody = 65534;
  if (::chown(cache().c_str(), nobody, static_cast<gid_t>(-1)) != 0)
    GTEST_SKIP() << "only root gives a folder away";
  run();
  EXPECT_TRUE(fs::is_empty(cache()));
}

// Who owns a folder above can put another one in its place between a check and its use.
TEST_F(Cache, AFolderThatAnotherCouldReplaceIsNotUsed) {
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0777), 0);
  run();
  EXPECT_TRUE(fs::is_empty(cache()));
  ASSERT_EQ(::chmod(folder_.path().c_str(), 01777), 0);
  run();
  EXPECT_FALSE(fs::is_empty(cache())) << "in a folder with the sticky bit nobody else can";
}

TEST_F(Cache, AFolderBelowThatOfAnotherOwnerIsNotUsed) {
  constexpr uid_t nobody = 65534;
  if (::chown(folder_.path().c_str(), nobody, static_cast<gid_t>(-1)) != 0)
    GTEST_SKIP() << "only root gives a folder away";
  run();
  EXPECT_TRUE(fs::is_empty(cache()));
  const tests::Result doctor =
      tests::shell("XDG_CACHE_HOME='" + folder_.path().string() + "' odeum doctor");
  EXPECT_NE(doctor.output.find("cache      none: " + folder_.path().string() +
                               " belongs to another user"),
            std::string::npos)
      << doctor.output;
}

TEST_F(Cache, ACompilerThatDoesNotEndIsEnded) {
  script("sleep 1000 & sleep 1000\n");  // longer than a test may take
  const std::string output =
      run("CC='" + (folder_.path() / "cc").string() + "' ODEUM_COMPILER_SECONDS=0.3");
  EXPECT_NE(output.find("interpreted"), std::string::npos) << output;
  EXPECT_NE(output.find("did not end within 0.8 s"), std::string::npos) << output;
}

// Each level has a part of the time, of the processor: the others finish in it.
TEST_F(Cache, ALevelOfOptimisationThatTakesTooLongIsFollowedByALowerOne) {
  script("case \" $* \" in *\" -O2 \"*) while :; do :; done;; esac\nexec cc \"$@\"\n");
  // With the truth the code is loaded twice, and from the cache when it is spoken of.
  const std::string output = tests::shell(command("CC='" + (folder_.path() / "cc").string() +
                                                  "' ODEUM_COMPILER_SECONDS=2") +
                                          " --no-truth")
                                 .output;
  EXPECT_NE(output.find("at -O1, since -O2 took more than 1 s of the processor"), std::string::npos)
      << output;
  EXPECT_EQ(output.find("interpreted"), std::string::npos) << output;
}

TEST_F(Cache, ACompilerEndsWithTheProgram) {
  const std::string alive = (folder_.path() / "alive").string();
  script("(while true; do echo >> '" + alive + "'; sleep 0.02; done) & sleep 1000\n");
  // The program is killed once its compiler works: nothing of the compiler goes on.
  const tests::Result result =
      tests::shell("(" + command("CC='" + (folder_.path() / "cc").string() + "'") +
                   ") & program=$!; n=0; " + "while [ ! -s '" + alive +
                   "' ] && [ $n -lt 5000 ]; do sleep 0.02; n=$((n+1)); done; kill -9 $program; "
                   "wait $program; true");
  ASSERT_TRUE(fs::exists(alive)) << result.output;
  bool stands_still = false;
  for (int tries = 0; tries < 200 && !stands_still; ++tries) {
    const auto size = fs::file_size(alive);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stands_still = fs::file_size(alive) == size;
  }
  EXPECT_TRUE(stands_still);
  // What was left is removed by the next run, which does not read it.
  EXPECT_EQ(unfinished(), 1U);
  EXPECT_NE(run().find("compiled by"), std::string::npos);
  EXPECT_EQ(unfinished(), 0U);
}

}  // namespace
}  // namespace odeum::cache_test
