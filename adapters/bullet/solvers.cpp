// SPDX-License-Identifier: BSD-3-Clause
#include "bullet/solvers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

#include "engine.hpp"
#include "expressible.hpp"
#include "soft_body.hpp"
#include "variants.hpp"

namespace odeum::adapters::bullet {
namespace {

struct Method {
  const char* name;
  const char* scheme;  ///< its step, and where Bullet defines it
  double order;
  bool our_forces;  ///< each step evaluates forces of the adapter; otherwise the engine's own
  std::string (*objection)(const scene::Scene&);
  MakeEngine make;
  std::map<std::string, std::string> options;
  std::vector<Variant> variants = {};
};

constexpr double no_claim = std::numeric_limits<double>::quiet_NaN();

const Method methods[] = {
    {"soft_body_force",
     "btSoftBody::predictMotion: symplectic Euler (v += h f(x, v)/m, then x += h v), the step "
     "rounded to float",
     1,
     true,
     objection_of_forces,
     make_soft_body_force,
     {}},
    {"soft_body_collision",
     "as soft_body_force, but contacts are fCollision::SDF_RS, a model of its own: nodes are "
     "projected out of rigid bodies without a rebound, and friction takes its coefficient of the "
     "sliding at each step",
     no_claim,
     true,
     objection_of_collision,
     make_soft_body_collision,
     {}},
    {"soft_body_links",
     "btSoftBody::PSolve_Links, position-based, 1 sweep, kLST set so that one link does backward "
     "Euler at small strain; its spring law is k l (l^2 - L^2)/(l^2 + L^2), not k (l - L), and "
     "damping between free particles is left out",
     1,
     false,
     objection_of_links,
     make_soft_body_links,
     {{"sweeps", "Gauss-Seidel sweeps over the links"}},
     {{{"sweeps", 4}}, {{"sweeps", 16}}}},
    {"soft_body_links_stock",
     "btSoftBody::PSolve_Links, position-based, 1 sweep, kLST = 1 (the default): lengths are "
     "projected to the rest lengths, for any stiffness",
     no_claim,
     false,
     objection_of_stock_links,
     make_soft_body_links_stock,
     {{"sweeps", "Gauss-Seidel sweeps over the links"}},
     {{{"sweeps", 4}}, {{"sweeps", 16}}}},
    {"deformable_explicit",
     "btDeformableMultiBodyDynamicsWorld: v* = v + h f(x)/m, then backward Euler in the damping, "
     "then x += h v",
     1,
     false,
     objection_of_deformable,
     make_deformable_explicit,
     {}},
    {"deformable_implicit",
     "btDeformableMultiBodyDynamicsWorld, setImplicit(true): one Newton step of backward Euler, "
     "linearised at x + h v",
     1,
     false,
     objection_of_deformable,
     make_deformable_implicit,
     {{"sweeps", "limit of conjugate gradient iterations"}, {"newton", "Newton iterations"}},
     {{{"sweeps", 4}}, {{"sweeps", 16}}, {{"newton", 2}}}},
    {"deformable_self_collision",
     "as deformable_explicit, but surfaces meet by fCollision::VF_DD and setSelfCollision(true), a "
     "model of its own: a node nearer to a face than the thickness is pushed off by impulses and a "
     "repulsion of its own law; edges do not meet edges",
     no_claim,
     false,
     objection_of_self_collision,
     make_deformable_self_collision,
     {}},
};

Outcome failed(Status status, std::string detail) {
  Outcome outcome;
  outcome.status = status;
  outcome.detail = std::move(detail);
  return outcome;
}

std::string objection_to(const scene::Scene& scene, const Method& method) {
  auto objection = objection_of_bodies(scene);
  return objection.empty() ? method.objection(scene) : objection;
}

/// Entry e of [all positions, all velocities] of the scene's n particles. The body may have nodes
/// added by the adapter after them.
double entry(const btSoftBody& body, std::size_t n, std::size_t e) {
  const bool velocity = e >= 3 * n;
  const std::size_t k = velocity ? e - 3 * n : e;
  const btSoftBody::Node& node = body.m_nodes[static_cast<int>(k / 3)];
  return (velocity ? node.m_v : node.m_x)[static_cast<int>(k % 3)];
}

/// The scene's own initial state, and the case's in the entries that the case has.
std::vector<double> initial_state(const scene::Scene& scene, const std::vector<double>& y0) {
  std::vector<double> state = scene::start_of(scene);
  for (std::size_t i = 0; i < y0.size(); ++i)
    state[scene.select.empty() ? i : scene.select[i]] = y0[i];
  return state;
}

/// Bullet neither reports a number that is not finite nor stops at one (a NaN in the deformable
/// solver's change of velocity is even set to zero), so that every step is checked. Below the limit
/// of distance no clamp has acted.
bool in_reach(const btSoftBody& body, double h) {
  for (int i = 0; i < body.m_nodes.size(); ++i)
    for (int d = 0; d < 3; ++d)
      if (!(std::abs(body.m_nodes[i].m_x[d]) < beyond_reach &&
            std::abs(body.m_nodes[i].m_v[d]) * h < beyond_reach))
        return false;
  return true;
}

Outcome run(const Method& method, const ErasedContest& contest, const Request& request,
            Guard& guard) {
  if (request.mode == Mode::adaptive)
    return refused("runs at a fixed step only: btDynamicsWorld::stepSimulation has no tolerance");
  const scene::Scene& scene = *contest.scene;
  if (!finite(scene)) return failed(Status::non_finite, "a number of the scene is not finite");
  if (auto objection = objection_to(scene, method); !objection.empty())
    return refused(std::move(objection));
  const FixedGrid grid(contest.t0, request);
  if (request.steps == 0 || !grid.fits())
    return refused("needs every stop on a step of the fixed grid");

  const auto count = [&](const char* option) {
    const auto asked = request.options.find(option);
    return asked == request.options.end()
               ? 0
               : static_cast<int>(std::clamp(asked->second, 0.0, 1'000'000.0));
  };
  const auto engine =
      method.make(scene, initial_state(scene, *contest.y0),
                  {.h = grid.h(), .sweeps = count("sweeps"), .newton = count("newton")});
  const std::size_t n = contest.view.dimension;
  std::vector<double> y(n);
  Outcome outcome;
  outcome.states.reserve(n * grid.stop_count());
  outcome.t = contest.t0;
  for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
    for (std::uint64_t& i = outcome.counters.steps; i < grid.index_of(stop); ++i) {
      outcome.t = grid.t(i);
      if (!guard.admit()) return outcome;
      engine->exert(outcome.t, guard);
      const bool stepped = engine->step(grid.h());
      outcome.counters.products = engine->products();
      if (!stepped) {
        outcome.status = Status::step_too_small;
        outcome.detail = fmt::format("Bullet ignores steps below SIMD_EPSILON, h = {}", grid.h());
        return outcome;
      }
      if (!in_reach(engine->body(), grid.h())) {
        outcome.status = Status::non_finite;
        outcome.detail = fmt::format(
            "a node of the btSoftBody is not finite or beyond {} m after the step from t = {}",
            beyond_reach, outcome.t);
        return outcome;
      }
    }
    for (std::size_t i = 0; i < n; ++i)
      y[i] = entry(engine->body(), scene.size(), scene.select.empty() ? i : scene.select[i]);
    outcome.record(request.stops[stop], y.data(), n);
  }
  return outcome;
}

Outcome solve(const Method& method, const ErasedContest& contest, const Request& request) {
  Guard guard(contest.view.dimension, request.budget);
  Outcome outcome;
  try {
    outcome = run(method, contest, request, guard);
  } catch (const std::exception& error) {
    outcome = refused(error.what());
  }
  const std::uint64_t products = outcome.counters.products;
  guard.conclude(request, outcome);
  // The guard's budget bounds the steps; the engine's own force evaluations are unknown.
  outcome.counters.products = products;
  if (!method.our_forces) outcome.counters.rhs_evaluations = 0;
  return outcome;
}

std::string unfit(const Method& method, const ErasedContest& contest) {
  if (!contest.scene)
    return "needs a scene of particles and springs, none of them emitted: a physics engine takes "
           "bodies";
  const scene::Scene& scene = *contest.scene;
  const std::size_t entries = scene.select.empty() ? 6 * scene.size() : scene.select.size();
  if (entries != contest.view.dimension) return "needs a scene whose state maps onto the case's";
  return objection_to(scene, method);
}

SolverInfo info_of(const Method& method) {
  SolverInfo info;
  info.library = "bullet";
  info.method = method.name;
  info.family = "physics_engine";
  info.common_use = CommonUse::engine;
  info.order = method.order;
  info.needs = "a scene";
  info.options = method.options;
  info.source = std::string("Bullet 3.24, ") + method.scheme;
  return info;
}

}  // namespace

void add_variants(std::map<std::string, std::vector<Variant>>& all) {
  for (const Method& method : methods) all[info_of(method).id()] = method.variants;
}

void add_solvers(std::vector<Solver>& all) {
  for (const Method& method : methods)
    all.push_back({info_of(method), [&method](const ErasedContest& contest, Entrant& entrant) {
                     entrant.unfit = unfit(method, contest);
                     if (!entrant.unfit.empty()) return;
                     entrant.solve = [&method, contest](const Request& request) {
                       return solve(method, contest, request);
                     };
                   }});
}

}  // namespace odeum::adapters::bullet
