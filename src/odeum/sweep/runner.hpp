// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/sweep/sweep.hpp"

namespace odeum::sweep {

/// Runs members one after the other, for one thread at a time.
class Runner {
 public:
  /// Without a family a case is made for each member.
  Runner(const Plan& plan, std::optional<Family> family);
  /// `refused` where the values make no problem, or the solver does not fit it.
  Outcome run(const std::vector<double>& values, const Request& request);
  /// Of an outcome of run() that is ok, the last one.
  double value(const Quantity& quantity, const Outcome& outcome) const;
  const std::vector<double>& y0() const { return *y0_; }

 private:
  const Plan& plan_;
  std::optional<Family> family_;
  Case case_;
  std::function<double(const double*)> energy_;
  std::shared_ptr<const std::vector<double>> y0_;
};

/// The runners of several threads: each takes one that is free, or makes one.
class Runners {
 public:
  explicit Runners(const Plan& plan);
  bool in_place() const { return in_place_; }
  std::unique_ptr<Runner> take();
  void give(std::unique_ptr<Runner> runner);

 private:
  const Plan& plan_;
  bool in_place_ = false;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Runner>> free_;
};

/// A runner until the end of the scope.
class Lent {
 public:
  explicit Lent(Runners& from) : from_(from), lent_(from.take()) {}
  ~Lent() { from_.give(std::move(lent_)); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  Runner* operator->() const { return lent_.get(); }

 private:
  Runners& from_;
  std::unique_ptr<Runner> lent_;
};

}  // namespace odeum::sweep
