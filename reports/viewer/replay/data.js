// SPDX-License-Identifier: BSD-3-Clause
// The page's data: frames of particles, springs, energies.
const byId = (id) => document.getElementById(id);
const report = document.documentElement.dataset; // read by the page's test
const scene = JSON.parse(byId('scene').textContent);
byId('title').textContent = document.title = scene.name || 'Scene';
byId('facts').replaceChildren(
  ...scene.facts.map((text) => Object.assign(document.createElement('li'), { textContent: text })),
);
const unpack = (text, Kind) => {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Kind(bytes.buffer);
};
const counts = unpack(scene.counts, Uint32Array), allIds = unpack(scene.ids, Uint32Array);
const states = unpack(scene.states, Float32Array), radii = unpack(scene.radii, Float32Array);
const fixed = unpack(scene.fixed, Uint32Array), ends = unpack(scene.springs, Uint32Array);
const rest = unpack(scene.rest, Float32Array);
// How far each particle is from where it should be, m, by frame; empty: not known.
const errors = unpack(scene.errors || '', Float32Array);
// Frame and particle of what touches, as one number each.
const touching = unpack(scene.touching || '', Uint32Array), touches = new Set();
for (let i = 0; i < touching.length; i += 2)
  touches.add(touching[i] * scene.listed + touching[i + 1]);
report.touching = touches.size;
const times = scene.times, last = times.length - 1, duration = times[last] || 1;

// Where each frame begins in the arrays.
const firstParticle = new Uint32Array(times.length + 1);
counts.forEach((n, k) => {
  firstParticle[k + 1] = firstParticle[k] + n;
});
const position = (k, i, d) => states[6 * firstParticle[k] + 3 * i + d];
const velocity = (k, i, d) => states[6 * firstParticle[k] + 3 * (counts[k] + i) + d];
const idOf = (k, i) => allIds[firstParticle[k] + i];
const emits = counts.some((n) => n !== scene.listed);
// Particles are sorted by id: binary search.
const indexOf = (k, id) => {
  if (!emits) return id;
  let low = 0, high = counts[k] - 1;
  while (low <= high) {
    const middle = (low + high) >> 1, found = idOf(k, middle);
    if (found === id) return middle;
    if (found < id) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
};
