// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum {

/// The solvers on one problem, in the order of a list of solvers:
///
///     const Entrant* const found = c.entrants.find(id);  // library/method
///     if (found && found->unfit.empty()) outcome = found->solve(request);
///
/// An entrant is made when it is first asked for, so that a run of one solver enrols one. Copies
/// share their entrants, which stay where they are. Thread-safe but for add().
class Entrants {
 public:
  /// Called on each entrant when it is made.
  using Finish = std::function<void(Entrant&)>;

  Entrants() = default;
  /// `solvers` has to outlive this.
  Entrants(const std::vector<Solver>& solvers, ErasedContest contest, Finish finish = {});
  /// An entrant that is none of the solvers, after them and those added before.
  void add(Entrant entrant);

  std::size_t size() const;
  /// Information on entrant k without enrolling it; fields that depend on the problem are unset.
  const SolverInfo& info(std::size_t k) const;
  /// Entrant k < size(), which stays where it is as long as a copy of this lives.
  const Entrant& operator[](std::size_t k) const;
  const Entrant& back() const { return (*this)[size() - 1]; }
  /// The entrant of an id, library/method; null where there is none.
  const Entrant* find(const std::string& id) const;

  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Entrant;
    using difference_type = std::ptrdiff_t;
    using pointer = const Entrant*;
    using reference = const Entrant&;
    Iterator() = default;
    Iterator(const Entrants* of, std::size_t k) : of_(of), k_(k) {}
    const Entrant& operator*() const { return (*of_)[k_]; }
    const Entrant* operator->() const { return &(*of_)[k_]; }
    Iterator& operator++() { return ++k_, *this; }
    Iterator operator++(int) { return {of_, k_++}; }
    bool operator==(const Iterator& other) const { return k_ == other.k_; }

   private:
    const Entrants* of_ = nullptr;
    std::size_t k_ = 0;
  };
  /// Going through them makes each.
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size()}; }

  /// How many entrants this program has made.
  static std::size_t made();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

/// Every solver, own and of each library, those of plug-ins last: built once, after which no
/// library can be added (add_runtime_library).
const std::vector<Solver>& all_solvers();

}  // namespace odeum
