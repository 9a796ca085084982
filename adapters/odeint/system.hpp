// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeint/tripped.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum::adapters::odeint {

/// Problem P as odeint calls it, guarded and inlined: the system of its first-order steppers.
template <Ode P>
struct System {
  const Guarded<P>* problem;

  void operator()(const State<P>& y, State<P>& dydt, double t) const {
    problem->rhs(t, y.data(), dydt.data());
    if (problem->tripped()) throw Tripped{};
  }
};

/// Positions or velocities of a second-order problem.
template <SecondOrder P>
using Half = detail::StateOf<double, P::dimension == dynamic ? dynamic : P::dimension / 2>;

/// q'' = a(t, q, v) as odeint's velocity_verlet calls it.
template <SecondOrder P>
struct SecondOrderSystem {
  const Guarded<P>* problem;

  void operator()(const Half<P>& q, const Half<P>& v, Half<P>& a, double t) const {
    problem->acceleration(t, q.data(), v.data(), a.data());
    if (problem->tripped()) throw Tripped{};
  }
};

/// q'' = a(q) as odeint's symplectic steppers call it: they pass neither time nor velocity. The
/// guard therefore reports the time at the start of the step.
template <Separable P>
struct SymplecticSystem {
  const Guarded<P>* problem;
  const double* step_start = nullptr;

  void operator()(const Half<P>& q, Half<P>& a) const {
    const double* const no_velocity = nullptr;  // typed: the problem's function may be a template
    problem->acceleration(*step_start, q.data(), no_velocity, a.data());
    if (problem->tripped()) throw Tripped{};
  }
};

}  // namespace odeum::adapters::odeint
