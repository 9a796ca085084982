// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/loaded_processes.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "odeum/isolated/child_process.hpp"
#include "odeum/isolated/handed_request.hpp"

namespace odeum::loaded_processes_test {
namespace {

/// Solvers of the library under test, by number.
enum Kind : std::size_t { sound, crashes, hangs, throws };

/// A library whose loading and solves are counted in memory that all processes share.
class Library {
 public:
  struct Counts {
    std::atomic<int> loaded{0}, seen{0}, changed{0};
  };
  Counts& counts() const { return *static_cast<Counts*>(shared_->get()); }

  isolated::LoadedWork work(double problem, bool with_thread = false) {
    const auto load = [this, with_thread] {
      if (is_loaded_) return;
      is_loaded_ = true;
      ++counts().loaded;
      if (with_thread) std::thread([] { ::pause(); }).detach();
    };
    return {std::make_shared<const double>(problem), 2, load,
            [this, load, problem](std::size_t kind, const Request& request) {
              load();
              ++counts().seen;
              counts().changed += runs_++;
              if (kind == crashes) std::abort();
              if (kind == hangs) ::pause();
              if (kind == throws) throw std::runtime_error("a fault");
              Outcome outcome;
              for (const double stop : request.stops) {
                const double y[] = {problem * stop, request.tolerance.absolute(1)};
                outcome.record(stop, y, 2);
              }
              outcome.counters.steps = request.steps;
              return outcome;
            }};
  }

 private:
  std::shared_ptr<isolated::SharedMemory> shared_ =
      std::make_shared<isolated::SharedMemory>(sizeof(Counts));
  bool is_loaded_ = false;
  int runs_ = 0;
};

Request request_to(std::vector<double> stops) {
  Request request;
  request.mode = Mode::adaptive;
  request.steps = 7;
  request.tolerance = {1e-3, std::vector<double>{1e-4, 3e-7}};
  request.stops = std::move(stops);
  return request;
}

// Each of 50 solves of SciPy in a study of one case took a second of Python's start.
TEST(LoadedProcesses, ALibraryIsLoadedOnceForAProblemAndEachSolveIsTheFirst) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer has a thread of its own, so that no process is copied";
#endif
  Library library;
  isolated::LoadedProcesses processes;
  const isolated::Unchanging unchanging;
  isolated::Ended ended = 0;
  const isolated::LoadedWork one = library.work(2), other = library.work(5);
  for (int k = 1; k <= 3; ++k) {
    // A longer request needs more memory than those before it.
    const std::size_t stops = k == 3 ? 5000 : 2;
    std::vector<double> times;
    for (std::size_t i = 1; i <= stops; ++i) times.push_back(static_cast<double>(i * k));
    const Outcome outcome = processes.solve(one, sound, request_to(times), ended);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    ASSERT_EQ(outcome.states.size(), 2 * stops);
    EXPECT_EQ(outcome.states[2], 2.0 * 2 * k);
    EXPECT_EQ(outcome.states[3], 3e-7);
    EXPECT_EQ(outcome.counters.steps, 7U);
    EXPECT_EQ(processes.solve(other, sound, request_to({3}), ended).states.at(0), 15);
  }
  EXPECT_EQ(library.counts().loaded, 2);
  EXPECT_EQ(library.counts().seen, 6);
  EXPECT_EQ(library.counts().changed, 0) << "a solve saw what another one had changed";
}

TEST(LoadedProcesses, AFaultCostsItsOwnSolveOnly) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer has a thread of its own, so that no process is copied";
#endif
  ::setenv("ODEUM_SILENCE_SECONDS", "0.5", 1);
  Library library;
  isolated::LoadedProcesses processes;
  const isolated::Unchanging unchanging;
  isolated::Ended ended = 0;
  const isolated::LoadedWork work = library.work(2);
  const std::vector<std::pair<Kind, std::string>> faults{
      {crashes, "crashed: Aborted"}, {hangs, "was ended"}, {throws, "threw a fault"}};
  for (const auto& [fault, words] : faults) {
    const Outcome outcome = processes.solve(work, fault, request_to({1}), ended);
    EXPECT_EQ(outcome.status, fault == hangs ? Status::over_budget : Status::refused);
    EXPECT_NE(outcome.detail.find(words), std::string::npos) << outcome.detail;
    EXPECT_EQ(ended, fault == hangs ? 1U : 0U);
    EXPECT_EQ(processes.solve(work, sound, request_to({1}), ended).status, Status::ok);
  }
  EXPECT_EQ(library.counts().loaded, 1);
}

TEST(LoadedProcesses, ALibraryWithThreadsIsLoadedInEachSolve) {
  Library library;
  isolated::LoadedProcesses processes;
  const isolated::Unchanging unchanging;
  isolated::Ended ended = 0;
  const isolated::LoadedWork work = library.work(2, true);
  for (int k = 0; k < 2; ++k)
    EXPECT_EQ(processes.solve(work, sound, request_to({1}), ended).status, Status::ok);
  // Once more in the process whose copies would lack the thread.
  EXPECT_EQ(library.counts().loaded, 3);
}

TEST(LoadedProcesses, ThreadsSolveAtOnce) {
  Library library;
  isolated::LoadedProcesses processes;
  const isolated::Unchanging unchanging;
  const isolated::LoadedWork work = library.work(2);
  std::atomic<int> sum = 0;
  std::vector<std::thread> threads;
  for (int k = 1; k <= 4; ++k)
    threads.emplace_back([&, k] {
      const isolated::Unchanging own;
      isolated::Ended ended = 0;
      for (int i = 0; i < 5; ++i)
        sum += static_cast<int>(
            processes.solve(work, sound, request_to({1.0 * k}), ended).states.at(0));
    });
  for (std::thread& each : threads) each.join();
  EXPECT_EQ(sum, 5 * 2 * (1 + 2 + 3 + 4));
  EXPECT_LE(library.counts().loaded, 4);
}

// The stability of a plug-in's solver had no limit: each solve was of the problem at the first.
TEST(LoadedProcesses, AProblemThatChangesIsTheOneOfNow) {
  isolated::LoadedProcesses processes;
  isolated::Ended ended = 0;
  double rate = 1;
  const isolated::LoadedWork work{std::make_shared<const double>(0), 1, [] {},
                                  [&](std::size_t, const Request& request) {
                                    Outcome outcome;
                                    outcome.record(request.stops.back(), &rate, 1);
                                    return outcome;
                                  }};
  for (; rate < 4; ++rate)
    EXPECT_EQ(processes.solve(work, sound, request_to({1}), ended).states.at(0), rate);
}

TEST(HandedRequest, IsTheSame) {
  Request request = request_to({0.1, 1, 2.5});
  request.over_stops = true;
  request.budget = {123, 4.5, false};
  request.options = {{"max_order", 5}, {"fraction", 0.1}};
  request.tolerance = request.tolerance.with_relative(1e-5 / 3);
  const Request other = isolated::request_of(isolated::bytes_of(request).data());
  EXPECT_EQ(isolated::bytes_of(other), isolated::bytes_of(request));
  EXPECT_EQ(other.stops, request.stops);
  EXPECT_EQ(other.options, request.options);
  EXPECT_EQ(other.tolerance.thresholds, request.tolerance.thresholds);
  EXPECT_EQ(other.tolerance.absolutes(), request.tolerance.absolutes());
  EXPECT_EQ(other.budget.evaluations, 123U);
  EXPECT_EQ(other.budget.seconds, 4.5);
  EXPECT_FALSE(other.budget.watched);
  EXPECT_TRUE(other.over_stops);
  EXPECT_EQ(other.mode, Mode::adaptive);
}

}  // namespace
}  // namespace odeum::loaded_processes_test
