// SPDX-License-Identifier: BSD-3-Clause
// Fixed surfaces: planes as grids, spheres as shaded triangles.
const still = { lines: [], lineColours: [], faces: [], faceColours: [] };
const grid = (point, normal, colour) => {
  const n = unit(normal), helper = Math.abs(n[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const a = unit(cross(n, helper)), b = cross(n, a), half = 0.7 * extent, lines = 12;
  const foot = dot(center.map((x, d) => x - point[d]), n);
  const origin = center.map((x, d) => x - foot * n[d]);
  for (let k = -lines / 2; k <= lines / 2; ++k)
    for (const [along, across] of [[a, b], [b, a]])
      for (const end of [-half, half]) {
        for (let d = 0; d < 3; ++d)
          still.lines.push(origin[d] + end * along[d] + ((2 * k * half) / lines) * across[d]);
        still.lineColours.push(...colour);
      }
};
for (const surface of scene.surfaces) {
  if (surface.kind === 'plane') grid(surface.point, surface.normal, [0.5, 0.55, 0.6, 0.35]);
  if (surface.kind !== 'sphere') continue;
  const rings = 24,
    at = (i, j) => {
      const t = (Math.PI * i) / rings, p = (Math.PI * j) / rings;
      return [Math.sin(t) * Math.cos(p), Math.sin(t) * Math.sin(p), Math.cos(t)];
    };
  for (let i = 0; i < rings; ++i)
    for (let j = 0; j < 2 * rings; ++j)
      for (const [x, y] of [
        [i, j], [i + 1, j], [i + 1, j + 1], [i, j], [i + 1, j + 1], [i, j + 1],
      ]) {
        const n = at(x, y), light = 0.35 + 0.25 * n[up] + 0.15 * n[ahead];
        for (let d = 0; d < 3; ++d)
          still.faces.push(surface.center[d] + 0.985 * surface.radius * n[d]);
        still.faceColours.push(0.75 * light, 0.8 * light, 0.9 * light, 1);
      }
}
if (!scene.surfaces.some((s) => s.kind === 'plane')) {
  const floor = center.slice(), normal = [0, 0, 0];
  floor[up] = low[up];
  normal[up] = 1;
  grid(floor, normal, [0.4, 0.42, 0.45, 0.2]);
}
