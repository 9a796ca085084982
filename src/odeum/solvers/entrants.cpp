// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/entrants.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "odeum/solvers/pieces.hpp"

namespace odeum {
namespace {

std::atomic<std::size_t> entrants_made = 0;

}  // namespace

struct Entrants::Shared {
  const std::vector<Solver>* solvers = nullptr;  ///< null: none
  ErasedContest contest = {};
  Finish finish = {};
  std::mutex mutex = {};
  std::vector<std::unique_ptr<Entrant>> made = {};  ///< of `solvers`, then those that were added
  std::map<const Solver*, std::unique_ptr<Entrant>> as_they_come = {};  ///< the second ones
};

Entrants::Entrants(const std::vector<Solver>& solvers, ErasedContest contest, Finish finish)
    : shared_(std::make_shared<Shared>()) {
  shared_->solvers = &solvers;
  shared_->contest = std::move(contest);
  shared_->finish = std::move(finish);
  shared_->made.resize(solvers.size());
}

void Entrants::add(Entrant entrant) {
  if (!shared_) shared_ = std::make_shared<Shared>();
  shared_->made.push_back(std::make_unique<Entrant>(std::move(entrant)));
}

std::size_t Entrants::size() const { return shared_ ? shared_->made.size() : 0; }

const SolverInfo& Entrants::info(std::size_t k) const {
  const std::vector<Solver>* const solvers = shared_->solvers;
  return solvers && k < solvers->size() ? (*solvers)[k].info : shared_->made[k]->info;
}

const Entrant& Entrants::operator[](std::size_t k) const {
  const std::lock_guard lock(shared_->mutex);
  std::unique_ptr<Entrant>& entrant = shared_->made[k];
  if (!entrant) {
    const Solver& solver = (*shared_->solvers)[k];
    entrant = std::make_unique<Entrant>(enrolled(solver, shared_->contest));
    if (shared_->finish) shared_->finish(*entrant);
    ++entrants_made;
  }
  return *entrant;
}

const Entrant* Entrants::find(const std::string& id) const {
  for (std::size_t k = 0; k < size(); ++k)
    if (info(k).id() == id) return &(*this)[k];
  if (!id.ends_with(as_it_comes) || !shared_ || !shared_->solvers) return nullptr;
  const auto solver =
      std::ranges::find(*shared_->solvers, id.substr(0, id.size() - as_it_comes.size()),
                        [](const Solver& each) { return each.info.id(); });
  if (solver == shared_->solvers->end()) return nullptr;
  const std::lock_guard lock(shared_->mutex);
  std::unique_ptr<Entrant>& entrant = shared_->as_they_come[&*solver];
  if (!entrant) {
    entrant = std::make_unique<Entrant>(enrolled_as_it_comes(*solver, shared_->contest));
    if (shared_->finish) shared_->finish(*entrant);
    ++entrants_made;
  }
  return entrant.get();
}

std::size_t Entrants::made() { return entrants_made; }

}  // namespace odeum
