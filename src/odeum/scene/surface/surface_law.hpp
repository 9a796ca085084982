// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>

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
/// Of e1, e2 and r (a triangle's edges and the point seen from their corner; two edges, and the
/// start of the second seen from that of the first) it takes the part w of r across e1 and e2,
/// r = u e1 + v e2 + w, and d = |w|.
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

/// A function and its derivative.
template <class Real>
struct Sloped {
  Real value{}, slope{};
};

/// From 0 at x <= 0 to 1 at x >= 1, with three continuous derivatives.
template <class Real>
Sloped<Real> rise(const Real& x) {
  if (!(x > 0)) return {Real(0), Real(0)};
  if (!(x < 1)) return {Real(1), Real(0)};
  const Real x2 = x * x, rest = 1 - x;
  return {x2 * x2 * (35 + x * (-84 + x * (70 - 20 * x))), 140 * x2 * x * rest * rest * rest};
}

/// How far beyond its ends, in lengths, an edge or a triangle acts.
inline constexpr double reach = 0.15;
/// Edges at a smaller sine squared than this have a part of the potential.
inline constexpr double parallel = 0.04;

/// phi(d); 0 at 0 and below, where the exact motion never comes.
template <class Real>
Sloped<Real> repulsion(const SelfContact& law, const Real& d) {
  const Real x = d / law.thickness, rest = 1 - x;
  if (!(x > 0) || !(rest > 0)) return {};
  const Real scale = 0.4 * law.stiffness * law.thickness * rest * rest * rest / x;
  return {scale * law.thickness * rest, -scale * (1 + 3 * x) / x};
}

enum class Meeting { point_and_triangle, two_edges };

/// The potential, the forces that are its derivatives by r, e1 and e2 with the opposite sign, and
/// what friction needs.
template <class Real>
struct Apart {
  Real energy{}, distance{}, push{};  ///< push: -dE/dd, N
  Real u{}, v{};
  Vec<Real> normal{}, on_r{}, on_e1{}, on_e2{};
};

/// False where there is no force; `apart` is then undefined. The point of a triangle may be a ball
/// of a radius, from whose surface d counts.
template <class Real>
bool meet(Meeting kind, const SelfContact& law, double radius, const Vec<Real>& e1,
          const Vec<Real>& e2, const Vec<Real>& r, Apart<Real>& apart) {
  const Real a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2);
  const Real determinant = a * c - b * b;
  if (!(determinant > 0)) return false;
  const Real p1 = dot(e1, r), p2 = dot(e2, r), inverse = 1 / determinant;
  const Real u = (c * p1 - b * p2) * inverse, v = (a * p2 - b * p1) * inverse;
  const bool edges = kind == Meeting::two_edges;
  const Real far1 = edges ? 1 - u : 1 - u - v, near2 = edges ? -v : v;
  const Real far2 = edges ? 1 + v : far1;
  if (!(u > -reach && near2 > -reach && far1 > -reach && far2 > -reach)) return false;
  Vec<Real> w;
  for (std::size_t k = 0; k < 3; ++k) w[k] = r[k] - u * e1[k] - v * e2[k];
  const Real squared = dot(w, w);
  const double most = law.thickness + radius;
  if (!(squared < most * most) || !(squared > radius * radius)) return false;
  using std::sqrt;
  const Real length = sqrt(squared), d = length - radius;
  const Sloped<Real> phi = repulsion(law, d);
  const auto window = [](const Real& x) {
    Sloped<Real> s = rise(Real((x + reach) / (2 * reach)));
    s.slope = s.slope / (2 * reach);
    return s;
  };
  const Sloped<Real> u0 = window(u), u1 = window(far1), v0 = window(near2);
  const Sloped<Real> v1 = edges ? window(far2) : Sloped<Real>{Real(1), Real(0)};
  const Sloped<Real> angle =
      edges ? rise(Real(determinant / (a * c) / parallel)) : Sloped<Real>{Real(1), Real(0)};
  const Real in_u = u0.value * u1.value, in_v = v0.value * v1.value;
  const Real weight = in_u * in_v * angle.value;
  if (!(weight > 0)) return false;
  // Derivatives by d, u, v and the sine squared. The far end of a triangle moves with u and v.
  const Real by_d = weight * phi.slope, scale = phi.value * angle.value;
  Real by_u = scale * in_v * (u0.slope * u1.value - u0.value * u1.slope);
  Real by_v = scale * in_u * (v0.slope * v1.value - v0.value * v1.slope);
  if (edges)
    by_v = -by_v;
  else
    by_v = by_v - scale * in_v * u0.value * u1.slope;
  const Real by_sine = phi.value * in_u * in_v * angle.slope / parallel;
  // With the inverse of [a b; b c]: du = (row of it times (e1, e2)) dr, and so on; w is across.
  const Real au = (c * by_u - b * by_v) * inverse, av = (a * by_v - b * by_u) * inverse;
  const Real ratio = b / (a * c), s12 = 2 * by_sine * ratio;
  const Real s11 = s12 * b / a, s22 = s12 * b / c;
  apart.energy = weight * phi.value;
  apart.distance = d, apart.push = -by_d;
  apart.u = u, apart.v = v;
  for (std::size_t k = 0; k < 3; ++k) {
    apart.normal[k] = w[k] / length;
    apart.on_r[k] = -(by_d * apart.normal[k] + au * e1[k] + av * e2[k]);
    apart.on_e1[k] = -u * apart.on_r[k] - au * w[k] + s12 * e2[k] - s11 * e1[k];
    apart.on_e2[k] = -v * apart.on_r[k] - av * w[k] + s12 * e1[k] - s22 * e2[k];
  }
  return true;
}

/// The same of a point that r away from the centre of a ball; its force is on_r.
template <class Real>
bool meet_ball(const SelfContact& law, double radius, const Vec<Real>& r, Apart<Real>& apart) {
  const Real squared = dot(r, r);
  const double most = law.thickness + radius;
  if (!(squared < most * most) || !(squared > radius * radius)) return false;
  using std::sqrt;
  const Real length = sqrt(squared);
  const Sloped<Real> phi = repulsion(law, Real(length - radius));
  apart = {};
  apart.energy = phi.value, apart.distance = length - radius, apart.push = -phi.slope;
  for (std::size_t k = 0; k < 3; ++k) {
    apart.normal[k] = r[k] / length;
    apart.on_r[k] = apart.push * apart.normal[k];
  }
  return true;
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
