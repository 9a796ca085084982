// SPDX-License-Identifier: BSD-3-Clause
// What is known of the stability of a solver: its limits and its region; and the eigenvalues of a
// problem that ask for it.
'use strict';
(() => {
  const { load, facts, functions, idOf, number } = odeum;

  let regionsRead = null;

  const loadRegions = () => {
    regionsRead =
      regionsRead ||
      load('regions').then(
        (data) => new Map(data.map((region) => [`${region.solver}:${region.plane}`, region])),
      );
    return regionsRead;
  };

  // Whether a point is inside: an odd number of loops around it.
  const isInside = (region, px, py) => {
    let inside = false;
    for (const loop of region.loops)
      for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
        const [xi, yi, xj, yj] = [loop[i], loop[i + 1], loop[j], loop[j + 1]];
        if (yi > py !== yj > py && px < ((xj - xi) * (py - yi)) / (yj - yi) + xi) inside = !inside;
      }
    return inside;
  };

  // How far from 0 along a ray the region reaches; {value, beyond: to the edge of the picture}.
  const reach = (region, dx, dy) => {
    const [left, right, bottom, top] = region.box;
    // The axes of the picture are edges of loops: a hair inside of them.
    const x0 = 0, y0 = region.plane === 'oscillator' ? dy : 0,
      sy = region.plane === 'oscillator' ? 0 : dy;
    const sx = region.plane === 'oscillator' ? 1 : dx;
    const step = (right - left) / 2000;
    let last = 0;
    // Within a cell of the grid around 0, where every growth is near 1, the outline tells nothing.
    for (let s = 1.5 * region.cell; ; s += step) {
      const px = x0 + s * sx, py = Math.max(bottom + 1e-6, y0 + s * sy);
      if (px < left + step || px > right - step || py > top - step)
        return { value: last, beyond: true };
      if (!isInside(region, px, py)) return { value: last, beyond: false };
      last = s;
    }
  };

  const limitNumber = (id, axis) => {
    const row = facts.limits.find(
      (limit) => idOf(limit) === id && limit.axis === axis && limit.status !== 'not_applicable',
    );
    return row ? row.limit : undefined;
  };

  // The eigenvalue that is largest, and does not grow; `oscillating`: of those with an imaginary
  // part, for solvers of second-order problems, whose stability is known for vibrations alone.
  const fastestEigenvalue = (c, oscillating) =>
    c.eigenvalues
      .filter(
        (z) =>
          z[0] <= 1e-6 * Math.hypot(...z) && Math.hypot(...z) > 0 && (!oscillating || z[1] > 0),
      )
      .reduce((a, b) => (!a || Math.hypot(...b) > Math.hypot(...a) ? b : a), null);

  // Whether an eigenvalue of a case grows at least as fast as `z` is large.
  const growsAsFast = (c, z) =>
    c.eigenvalues.some(
      (w) => w[0] > 1e-6 * Math.hypot(...w) && Math.hypot(...w) >= 0.999 * Math.hypot(...z),
    );

  // h |lambda| to which a solver is stable along an eigenvalue.
  const limitOf = async (id, z) => {
    const size = Math.hypot(...z), re = z[0] / size, im = z[1] / size;
    if (im === 0 && limitNumber(id, 'real') !== undefined)
      return { value: limitNumber(id, 'real') };
    if (Math.abs(re) < 1e-9)
      for (const axis of ['imaginary', 'oscillator'])
        if (limitNumber(id, axis) !== undefined) return { value: limitNumber(id, axis) };
    const regions = await loadRegions().catch(() => new Map());
    const region = regions.get(`${id}:lambda`) || regions.get(`${id}:oscillator`);
    if (!region || !region.loops.length) return null;
    const found = reach(region, re, region.plane === 'oscillator' ? -re : im);
    return found.beyond && limitNumber(id, 'real') === Infinity ? { value: Infinity } : found;
  };

  // The step below which a solver is stable on a case, by its limit on the real axis and the
  // fastest eigenvalue of the case, where that is real; `finest`: the finest that was unstable.
  functions.needed_step = (id, library, solver, finest) => {
    const c = facts.caseOf.get(id), z = c && fastestEigenvalue(c),
      limit = limitNumber(`${library}/${solver}`, 'real');
    const still = finest > 0 ? ` It is unstable at h = ${number(finest, 2)} still` : '';
    if (!z || z[1] || !(limit > 0) || !Number.isFinite(limit)) return still && `${still}.`;
    const step = limit / -z[0];
    // The eigenvalue is that of one time: what was run says more.
    if (step > finest)
      return (
        `${still}, below ${number(limit)} / |λ| = ${number(step, 2)} with ` +
        `λ = ${number(z[0], 2)} at t = ${number(c.eigenvalues_time)}.`
      );
    return (
      ` It takes h < ${number(step, 2)}, ${number((c.end - c.start) / step, 2)} steps to ` +
      `t = ${number(c.end)}: ${number(limit)} / |λ|, λ = ${number(z[0], 2)} at ` +
      `t = ${number(c.eigenvalues_time)}.`
    );
  };

  Object.assign(odeum, {
    loadRegions, isInside, limitNumber, fastestEigenvalue, growsAsFast, limitOf,
  });
})();
