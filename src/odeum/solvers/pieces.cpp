// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/pieces.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "odeum/solvers/event_run.hpp"
#include "odeum/solvers/projection.hpp"
#include "odeum/solvers/run_parts.hpp"

namespace odeum {
namespace {

using Clock = std::chrono::steady_clock;

Entrant whole(const Solver& solver, const ErasedContest& contest) {
  Entrant entrant;
  entrant.info = solver.info;
  solver.enroll(contest, entrant);
  offer_projection(solver, contest, entrant);
  return entrant;
}

/// The contest between two switches. The form of an implicit problem has its times clamped too.
ErasedContest contest_of(const ErasedContest& all, const std::shared_ptr<const Piece>& piece,
                         double t0, const std::vector<double>& y0) {
  ErasedContest contest = all;
  contest.switches = {};
  contest.events = nullptr;
  contest.view = piece->view();
  contest.keep_alive = piece;
  contest.t0 = t0;
  contest.y0 = std::make_shared<const std::vector<double>>(y0);
  if (!all.implicit) return contest;
  auto form = std::make_shared<ImplicitForm>(*all.implicit);
  form->residual = [piece, inner = all.implicit](double t, const double* y, const double* rates,
                                                 double* r) {
    inner->residual(piece->clamped(t), y, rates, r);
  };
  form->matrix = [piece, inner = all.implicit](double t, const double* y, const double* rates,
                                               double alpha, double* j) {
    inner->matrix(piece->clamped(t), y, rates, alpha, j);
  };
  if (all.implicit->constraints.values)
    form->constraints.values = [piece, inner = all.implicit](double t, const double* y,
                                                             double* values) {
      inner->constraints.values(piece->clamped(t), y, values);
    };
  contest.implicit = std::move(form);
  return contest;
}

/// A run from switch to switch.
class RunInPieces {
 public:
  RunInPieces(const Solver& solver, const ErasedContest& contest, const Request& request)
      : solver_(solver),
        contest_(contest),
        request_(request),
        begin_(Clock::now()),
        t_(contest.t0),
        y_(*contest.y0) {}

  Outcome operator()(const std::vector<Switch>& switches) {
    double first = -Piece::unbounded;
    for (const Switch& at : switches) {
      if (!make(first, at.before, end_at(at.t))) return std::move(all_);
      first = at.after;
    }
    make(first, Piece::unbounded, request_.stops.back());
    return std::move(all_);
  }

 private:
  /// A stop that is the same time but for rounding: no library makes a step between the two.
  double end_at(double t) const {
    if (same(t, t_)) return t_;
    const auto stop = std::ranges::find_if(request_.stops, [&](double s) { return same(s, t); });
    return stop != request_.stops.end() ? *stop : std::min(t, request_.stops.back());
  }
  static bool same(double a, double b) {
    constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
    return std::abs(a - b) <= roundings * std::max(std::abs(a), std::abs(b));
  }
  /// The piece from t_ to `end`; false where it failed.
  bool make(double first, double last, double end) {
    if (!(end > t_)) return true;
    const Entrant entrant = whole(
        solver_,
        contest_of(contest_, std::make_shared<const Piece>(contest_.view, first, last), t_, y_));
    return take(entrant.solve ? entrant.solve(request_of(end)) : refused(entrant.unfit), end);
  }
  Request request_of(double end) const {
    Request part = part_of(request_, t_, end);
    part.budget.evaluations -= std::min(part.budget.evaluations, all_.counters.work);
    part.budget.seconds -= std::chrono::duration<double>(Clock::now() - begin_).count();
    return part;
  }
  bool take(Outcome part, double end) {
    t_ = end;
    return add_part(all_, std::move(part), request_.stops, end, y_);
  }

  const Solver& solver_;
  const ErasedContest& contest_;
  const Request& request_;
  Clock::time_point begin_;
  double t_;
  std::vector<double> y_;
  Outcome all_;
};

}  // namespace

Entrant enrolled(const Solver& solver, const ErasedContest& contest) {
  Entrant entrant = whole(solver, contest);
  if (contest.events && entrant.solve) {
    entrant.extended = {};
    entrant.solve = [solver, contest](const Request& request) {
      const SegmentRun segment = [&](double first, double last, double t0,
                                     const std::vector<double>& y0, const Request& part) {
        const auto piece = std::make_shared<const Piece>(contest.view, first, last);
        const Entrant entrant = whole(solver, contest_of(contest, piece, t0, y0));
        return entrant.solve ? entrant.solve(part) : refused(entrant.unfit);
      };
      return run_with_events(contest, request, segment);
    };
    return entrant;
  }
  if (!contest.switches || !entrant.solve) return entrant;
  entrant.solve = [solver, contest, alone = std::move(entrant.solve)](const Request& request) {
    if (request.mode == Mode::fixed || request.stops.empty()) return alone(request);
    const std::vector<Switch> switches = contest.switches(contest.t0, request.stops.back());
    if (switches.empty()) return alone(request);
    return RunInPieces(solver, contest, request)(switches);
  };
  return entrant;
}

Entrant enrolled_as_it_comes(const Solver& solver, const ErasedContest& contest) {
  const auto piece =
      std::make_shared<const Piece>(contest.view, -Piece::unbounded, Piece::unbounded);
  Entrant entrant = whole(solver, contest_of(contest, piece, contest.t0, *contest.y0));
  entrant.info.method += as_it_comes;
  entrant.extended = {};
  if (!contest.events && !contest.switches && entrant.unfit.empty())
    entrant.unfit = "the problem has no switches and no events that " + solver.info.id() +
                    " locates, so that the two are one";
  if (!contest.events || !entrant.solve) return entrant;
  entrant.solve = [solver, contest, piece](const Request& request) {
    const auto run = [&](double t0, const std::vector<double>& y0, const Request& part) {
      const Entrant alone = whole(solver, contest_of(contest, piece, t0, y0));
      return alone.solve ? alone.solve(part) : refused(alone.unfit);
    };
    return run_as_it_comes(contest, request, run);
  };
  return entrant;
}

}  // namespace odeum
