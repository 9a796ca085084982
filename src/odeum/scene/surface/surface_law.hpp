// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <concepts>

#include "odeum/scene/model/scene.hpp"

/// The potential that keeps two parts of surfaces apart: a point and a triangle, or two edges, at a
/// distance d below the thickness h; with x = d / h
///
///     phi(d) = 0.4 k h^2 (1 - x)^4 / x,   phi = phi' = phi'' = phi''' = 0 at x = 1.
///
/// It grows without bound as d falls to 0, so that the exact motion stays on its side. d is the
/// distance from the plane of the triangle, or between the lines of the edges, times a window that
/// falls from 1 to 0 where the nearest point leaves the triangle or an edge: windows of
/// neighbouring triangles add to 1 in a plane. Two edges that are nearly parallel have no potential
/// either; the points of their ends have. All of it has three continuous derivatives, so that
/// methods keep their order up to 4.
///
/// Its arguments are e1, e2 and r: a triangle's edges and the point seen from their corner; or two
/// edges, and the start of the second seen from that of the first. With w the part of r across e1
/// and e2, r = u e1 + v e2 + w, it takes d = |w|.
namespace odeum::scene {

template <class Real>
using Vec = std::array<Real, 3>;
template <class Real>
Real dot(const Vec<Real>& a, const Vec<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Vec<Real> across(const Vec<Real>& a, const Vec<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What comparisons of numbers give: a truth value, or with Lanes one for each lane.
template <class Real>
using MaskOf = decltype(Real() > Real());
inline bool any(bool mask) { return mask; }
inline bool all(bool mask) { return mask; }
template <std::floating_point Real>
Real select(bool first, const Real& a, const Real& b) {
  return first ? a : b;
}

/// A function and its derivative.
template <class Real>
struct Sloped {
  Real value{}, slope{};
};

/// A step from 0 at x <= 0 to 1 at x >= 1, with three continuous derivatives.
template <class Real>
Sloped<Real> rise(const Real& x) {
  const MaskOf<Real> begun = x > 0, rising = x < 1;
  const Real zero(0), one(1);
  if (!any(begun)) return {zero, zero};
  if (all(begun) && !any(rising)) return {one, zero};
  const Real x2 = x * x, rest = 1 - x;
  const Real value = x2 * x2 * (35 + x * (-84 + x * (70 - 20 * x)));
  const Real slope = 140 * x2 * x * rest * rest * rest;
  return {select(begun, select(rising, value, one), zero),
          select(begun, select(rising, slope, zero), zero)};
}

/// How far beyond its ends, in lengths, an edge or a triangle acts.
inline constexpr double reach = 0.15;
/// Edges at a smaller sine squared than this have a part of the potential.
inline constexpr double parallel = 0.04;

/// phi(d); 0 at 0 and below, where the exact motion never comes.
template <class Real>
Sloped<Real> repulsion(const SelfContact& law, const Real& d) {
  const Real x = d * (1 / law.thickness), rest = 1 - x;
  const MaskOf<Real> within = (x > 0) & (rest > 0);
  const Real zero(0);
  if (!any(within)) return {zero, zero};
  const Real inverse = 1 / x;
  const Real scale = 0.4 * law.stiffness * law.thickness * rest * rest * rest * inverse;
  return {select(within, Real(scale * law.thickness * rest), zero),
          select(within, Real(-scale * (1 + 3 * x) * inverse), zero)};
}

enum class Meeting { point_and_triangle, two_edges };

/// The potential, the forces that are its derivatives by r, e1 and e2 with the opposite sign, and
/// what friction needs.
template <class Real>
struct Apart {
  Real energy{}, distance{}, push{};  ///< push: -dE/dd, N
  Real weight{};                      ///< of the windows
  Real u{}, v{};
  Vec<Real> normal{}, on_r{}, on_e1{}, on_e2{};
};

/// Where the point is in the plane of the triangle, or the lines of the edges are nearest.
template <class Real>
struct Nearest {
  Real a{}, b{}, c{}, determinant{}, inverse{};  ///< of e1 and e2: [a b; b c]
  Real u{}, v{}, near2{}, far1{}, far2{};        ///< an end of the window is where one is -reach
  Vec<Real> w{};
  Real squared{};  ///< |w|^2
};

/// Whether the two are near enough for a force, and where.
template <class Real>
MaskOf<Real> is_near(Meeting kind, const SelfContact& law, double radius, const Vec<Real>& e1,
                     const Vec<Real>& e2, const Vec<Real>& r, Nearest<Real>& at) {
  at.a = dot(e1, e1), at.b = dot(e1, e2), at.c = dot(e2, e2);
  at.determinant = at.a * at.c - at.b * at.b;
  MaskOf<Real> near = at.determinant > 0;
  if (!any(near)) return near;
  const Real p1 = dot(e1, r), p2 = dot(e2, r);
  at.inverse = 1 / at.determinant;
  at.u = (at.c * p1 - at.b * p2) * at.inverse, at.v = (at.a * p2 - at.b * p1) * at.inverse;
  const bool edges = kind == Meeting::two_edges;
  at.far1 = edges ? 1 - at.u : 1 - at.u - at.v, at.near2 = edges ? -at.v : at.v;
  at.far2 = edges ? 1 + at.v : at.far1;
  near = near & (at.u > -reach) & (at.near2 > -reach) & (at.far1 > -reach) & (at.far2 > -reach);
  if (!any(near)) return near;
  for (std::size_t k = 0; k < 3; ++k) at.w[k] = r[k] - at.u * e1[k] - at.v * e2[k];
  at.squared = dot(at.w, at.w);
  const double most = law.thickness + radius;
  return near & (at.squared < most * most) & (at.squared > radius * radius);
}

/// False where there is no force; `apart` is then undefined. The point of a triangle may be a ball
/// of a radius, from whose surface d counts.
template <class Real>
MaskOf<Real> meet(Meeting kind, const SelfContact& law, double radius, const Vec<Real>& e1,
                  const Vec<Real>& e2, const Vec<Real>& r, Apart<Real>& apart) {
  Nearest<Real> at;
  MaskOf<Real> acts = is_near(kind, law, radius, e1, e2, r, at);
  if (!any(acts)) return acts;
  const auto& [a, b, c, determinant, inverse, u, v, near2, far1, far2, w, squared] = at;
  const bool edges = kind == Meeting::two_edges;
  using std::sqrt;
  const Real length = sqrt(squared), d = length - radius;
  const Sloped<Real> phi = repulsion(law, d);
  constexpr double steep = 1 / (2 * reach);
  const auto window = [](const Real& x) {
    Sloped<Real> s = rise(Real((x + reach) * steep));
    s.slope = s.slope * steep;
    return s;
  };
  const Sloped<Real> u0 = window(u), u1 = window(far1), v0 = window(near2);
  const Sloped<Real> v1 = edges ? window(far2) : Sloped<Real>{Real(1), Real(0)};
  const Real per_ac = edges ? 1 / (a * c) : Real(0);
  const Sloped<Real> angle =
      edges ? rise(Real(determinant * per_ac * (1 / parallel))) : Sloped<Real>{Real(1), Real(0)};
  const Real in_u = u0.value * u1.value, in_v = v0.value * v1.value;
  const Real weight = in_u * in_v * angle.value;
  acts = acts & (weight > 0);
  if (!any(acts)) return acts;
  // Derivatives by d, u, v and the sine squared. The far end of a triangle moves with u and v.
  const Real by_d = weight * phi.slope, scale = phi.value * angle.value;
  Real by_u = scale * in_v * (u0.slope * u1.value - u0.value * u1.slope);
  Real by_v = scale * in_u * (v0.slope * v1.value - v0.value * v1.slope);
  if (edges)
    by_v = -by_v;
  else
    by_v = by_v - scale * in_v * u0.value * u1.slope;
  // With the inverse of [a b; b c]: du = (row of it times (e1, e2)) dr, and so on; w is across.
  const Real au = (c * by_u - b * by_v) * inverse, av = (a * by_v - b * by_u) * inverse;
  const Real per_length = 1 / length;
  apart.energy = weight * phi.value, apart.weight = weight;
  apart.distance = d, apart.push = -by_d;
  apart.u = u, apart.v = v;
  for (std::size_t k = 0; k < 3; ++k) {
    apart.normal[k] = w[k] * per_length;
    apart.on_r[k] = -(by_d * apart.normal[k] + au * e1[k] + av * e2[k]);
    apart.on_e1[k] = -u * apart.on_r[k] - au * w[k];
    apart.on_e2[k] = -v * apart.on_r[k] - av * w[k];
  }
  if (!edges) return acts;
  const Real by_sine = phi.value * in_u * in_v * angle.slope * (1 / parallel);
  const Real s12 = 2 * by_sine * b * per_ac;
  const Real s11 = s12 * b * c * per_ac, s22 = s12 * b * a * per_ac;
  for (std::size_t k = 0; k < 3; ++k) {
    apart.on_e1[k] = apart.on_e1[k] + s12 * e2[k] - s11 * e1[k];
    apart.on_e2[k] = apart.on_e2[k] + s12 * e1[k] - s22 * e2[k];
  }
  return acts;
}

/// The same of a point that is r away from the centre of a ball; its force is on_r.
template <class Real>
MaskOf<Real> meet_ball(const SelfContact& law, double radius, const Vec<Real>& r,
                       Apart<Real>& apart) {
  const Real squared = dot(r, r);
  const double most = law.thickness + radius;
  const MaskOf<Real> acts = (squared < most * most) & (squared > radius * radius);
  if (!any(acts)) return acts;
  using std::sqrt;
  const Real length = sqrt(squared), inverse = 1 / length;
  const Sloped<Real> phi = repulsion(law, Real(length - radius));
  const Real none(0);
  apart.u = apart.v = none, apart.on_e1 = apart.on_e2 = {none, none, none};
  apart.weight = Real(1);
  apart.energy = phi.value, apart.distance = length - radius, apart.push = -phi.slope;
  for (std::size_t k = 0; k < 3; ++k) {
    apart.normal[k] = r[k] * inverse;
    apart.on_r[k] = apart.push * apart.normal[k];
  }
  return acts;
}

/// Adds friction to the forces: of r, e1 and e2 that change at the rates dr, d1 and d2 the nearest
/// points slide at s = dr - u d1 - v d2 less its part along the normal, with the force
/// -mu N s / sqrt(|s|^2 + slow^2). It acts on both points, a distance d apart: it keeps the
/// momentum, and turns the pair by mu N d.
template <class Real>
void add_friction(const SelfContact& law, double slow, const Vec<Real>& d1, const Vec<Real>& d2,
                  const Vec<Real>& dr, Apart<Real>& apart) {
  Vec<Real> s;
  for (std::size_t k = 0; k < 3; ++k) s[k] = dr[k] - apart.u * d1[k] - apart.v * d2[k];
  const Real along = dot(s, apart.normal);
  for (std::size_t k = 0; k < 3; ++k) s[k] = s[k] - along * apart.normal[k];
  using std::sqrt;
  const Real factor = law.friction * apart.push / sqrt(dot(s, s) + slow * slow);
  for (std::size_t k = 0; k < 3; ++k) {
    const Real f = -factor * s[k];
    apart.on_r[k] = apart.on_r[k] + f;
    apart.on_e1[k] = apart.on_e1[k] - apart.u * f;
    apart.on_e2[k] = apart.on_e2[k] - apart.v * f;
  }
}

}  // namespace odeum::scene
