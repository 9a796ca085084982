// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// Every solver, own and of each library, on a problem through its shared type
/// (problem/shared.hpp). A malformed request throws std::invalid_argument before any of them is
/// called. `also` is called on each entrant that fits.
Entrants enroll(const ErasedContest& contest, const Entrants::Finish& also = {});

/// The same of a problem that nothing changes between solves: a library that is slow to load is
/// loaded once for it (isolated/loaded_processes.hpp).
Entrants enroll_unchanging(const ErasedContest& contest, const Entrants::Finish& also = {});

/// A problem whose right-hand side (acceleration, of second order) is written for any real type.
template <class P>
concept InExtendedPrecision = Ode<P> &&(
    requires(const P& p, const long double* y, long double* f) { p.rhs(0.0L, y, f); } ||
    requires(const P& p, const long double* q, long double* a) { p.acceleration(0.0L, q, q, a); });

/// The problem in extended precision, without a truth.
template <InExtendedPrecision P>
ExtendedProblem in_extended_precision(std::shared_ptr<const P> problem,
                                      const std::vector<double>& y0) {
  ExtendedProblem extended;
  extended.y0.assign(y0.begin(), y0.end());
  extended.f = [p = std::move(problem)](long double t, const long double* y, long double* f) {
    if constexpr (SecondOrder<P>) {
      const std::size_t half = size_of(*p) / 2;
      std::copy_n(y + half, half, f);
      p->acceleration(t, y, y + half, f + half);
    } else {
      p->rhs(t, y, f);
    }
  };
  return extended;
}

/// Sets the problem of case `c`, and its scene for physics engines where it has one.
template <Ode P>
void set_problem(Case& c, P problem, std::shared_ptr<const scene::Scene> scene = nullptr) {
  Contest<P> contest;
  contest.problem = std::make_shared<const P>(std::move(problem));
  contest.t0 = c.t0;
  contest.y0 = std::make_shared<const std::vector<double>>(c.y0);
  contest.scene = std::move(scene);
  c.problem = erase(contest);
  if constexpr (InExtendedPrecision<P>)
    c.extended =
        std::make_shared<const ExtendedProblem>(in_extended_precision<P>(contest.problem, c.y0));
  c.entrants = enroll_unchanging(c.problem);
  if constexpr (WithEnergy<P>)
    c.energy = [p = contest.problem](const double* y) { return p->energy(y); };
}

/// A probe over a problem with variable parameters: `place(problem, scene, first, second)` sets
/// them.
template <Ode P, class Scene, class Place>
Probe make_probe(P problem, std::vector<double> y0, Scene scene, Place place) {
  auto movable = std::make_shared<P>(std::move(problem));
  auto movable_scene = std::make_shared<Scene>(std::move(scene));
  Contest<P> contest;
  contest.problem = movable;
  contest.y0 = std::make_shared<const std::vector<double>>(std::move(y0));
  contest.scene = movable_scene;
  return {enroll(erase(contest)),
          [=](double first, double second) { place(*movable, *movable_scene, first, second); }};
}

}  // namespace odeum::cases
