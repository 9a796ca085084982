// SPDX-License-Identifier: BSD-3-Clause
// The box that holds the scene, the largest speed and strain.
const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
let fastest = 0;
const strains = [];
const springLength = (k, s) =>
  Math.hypot(
    ...[0, 1, 2].map((d) => position(k, ends[2 * s + 1], d) - position(k, ends[2 * s], d)),
  );
const strainOf = (length, s) => (rest[s] > 0 ? length / rest[s] - 1 : length);
for (let k = 0; k <= last; ++k) {
  for (let i = 0; i < counts[k]; ++i) {
    for (let d = 0; d < 3; ++d) {
      const x = position(k, i, d);
      if (!Number.isFinite(x)) continue;
      low[d] = Math.min(low[d], x);
      high[d] = Math.max(high[d], x);
    }
    const v = Math.hypot(velocity(k, i, 0), velocity(k, i, 1), velocity(k, i, 2));
    if (Number.isFinite(v)) fastest = Math.max(fastest, v);
  }
  const stride = Math.max(1, Math.floor((rest.length * times.length) / 200000));
  for (let s = k % stride; s < rest.length; s += stride)
    strains.push(strainOf(springLength(k, s), s));
}
for (const surface of scene.surfaces) {
  if (surface.kind !== 'sphere') continue;
  for (let d = 0; d < 3; ++d) {
    low[d] = Math.min(low[d], surface.center[d] - surface.radius);
    high[d] = Math.max(high[d], surface.center[d] + surface.radius);
  }
}
if (!(low[0] <= high[0])) {
  low.fill(-1);
  high.fill(1);
}
fastest = fastest || 1;
// The 98th percentile of strain, so that single springs do not compress the colour scale.
const sizes = strains
  .filter(Number.isFinite)
  .map(Math.abs)
  .sort((a, b) => a - b);
let strainMax = sizes.length ? Math.max(sizes[Math.floor(0.98 * (sizes.length - 1))], 1e-6) : 1;
const center = low.map((x, d) => (x + high[d]) / 2);
const extent = Math.max(Math.hypot(...low.map((x, d) => high[d] - x)), 1e-3);
