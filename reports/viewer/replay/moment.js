// SPDX-License-Identifier: BSD-3-Clause
// One moment: positions, interpolated between two frames with the same particles, and its drawing.
const moment = (t) => {
  let k = 0, top = last;
  while (k < top) {
    const middle = (k + top + 1) >> 1;
    if (times[middle] <= t) k = middle;
    else top = middle - 1;
  }
  const n = counts[k], base = 6 * firstParticle[k];
  const between = !emits && k < last ? (t - times[k]) / (times[k + 1] - times[k]) : 0;
  const next = base + 6 * n;
  const state = new Float32Array(6 * n);
  for (let i = 0; i < 6 * n; ++i)
    state[i] =
      between > 0
        ? states[base + i] + between * (states[next + i] - states[base + i])
        : states[base + i];
  return { k, n, state };
};
const radiusOf = (id) => Math.max(id < scene.listed ? radii[id] : 0, extent / 400);

const drawTrails = (now) => {
  const step = Math.max(1, Math.round(times.length / 600)),
    length = Number(byId('trail-length').value),
    places = [],
    colours = [];
  const every = Math.max(1, Math.ceil(now.n / 150));
  for (let i = 0; i < now.n; i += every) {
    const id = idOf(now.k, i);
    if (id < scene.listed && fixed[id]) continue;
    let from = [now.state[3 * i], now.state[3 * i + 1], now.state[3 * i + 2]];
    for (let back = 0; back < length; ++back) {
      const k = now.k - back * step;
      if (k < 0) break;
      const j = indexOf(k, id);
      if (j < 0) break;
      const to = [position(k, j, 0), position(k, j, 1), position(k, j, 2)];
      const fade = 0.5 * (1 - back / length);
      places.push(...from, ...to);
      colours.push(0.6, 0.75, 1, fade, 0.6, 0.75, 1, fade * (1 - 1 / length));
      from = to;
    }
  }
  draw(flat, gl.LINES, places, colours);
};
// An arrow a particle: the fastest is an eighth of the scene's size long.
const drawVelocities = (now) => {
  const places = [], colours = [], q = now.state, half = 3 * now.n, scale = extent / (8 * fastest);
  for (let i = 0; i < now.n; ++i) {
    const from = [0, 1, 2].map((d) => q[3 * i + d]),
      arrow = [0, 1, 2].map((d) => scale * q[half + 3 * i + d]);
    const length = Math.hypot(...arrow);
    if (!(length > extent / 1000)) continue;
    const tip = from.map((x, d) => x + arrow[d]);
    const side = unit(
      cross(
        arrow,
        Math.abs(arrow[up]) < 0.9 * length
          ? [0, 1, 2].map((d) => +(d === up))
          : [0, 1, 2].map((d) => +(d === ahead)),
      ),
    );
    places.push(...from, ...tip);
    for (const turn of [1, -1])
      places.push(
        ...tip, ...tip.map((x, d) => x - 0.25 * arrow[d] + turn * 0.12 * length * side[d]),
      );
    for (let corner = 0; corner < 6; ++corner) colours.push(1, 0.85, 0.4, 0.9);
  }
  draw(flat, gl.LINES, places, colours);
};
const drawSprings = (now) => {
  const places = [], colours = [];
  for (let s = 0; s < rest.length; ++s) {
    const a = 3 * ends[2 * s], b = 3 * ends[2 * s + 1], q = now.state;
    const length = Math.hypot(q[b] - q[a], q[b + 1] - q[a + 1], q[b + 2] - q[a + 2]);
    const colour = errors.length
      ? errorColour(now.k, a / 3).map((part, d) => (part + errorColour(now.k, b / 3)[d]) / 2)
      : strainColour(0.5 + (0.5 * strainOf(length, s)) / strainMax);
    places.push(q[a], q[a + 1], q[a + 2], q[b], q[b + 1], q[b + 2]);
    for (let twice = 0; twice < 2; ++twice) colours.push(...colour, 0.8);
  }
  draw(flat, gl.LINES, places, colours);
};
const drawCloths = (now) => {
  const places = [], colours = [], q = now.state;
  const corner = (i) => [q[3 * i], q[3 * i + 1], q[3 * i + 2]];
  for (const cloth of scene.cloths)
    for (let i = 0; i + 1 < cloth.rows; ++i)
      for (let j = 0; j + 1 < cloth.columns; ++j) {
        const a = cloth.first + i * cloth.columns + j, c = a + cloth.columns;
        for (const [x, y, z] of [
          [a, c, c + 1], [a, c + 1, a + 1],
        ]) {
          const p = corner(x), r = corner(y), s = corner(z);
          const n = unit(cross(r.map((v, d) => v - p[d]), s.map((v, d) => v - p[d])));
          const light = 0.25 + 0.4 * Math.abs(0.8 * n[up] + 0.5 * n[ahead] + 0.33 * n[aside]);
          [p, r, s].forEach((v, corner3) => {
            places.push(...v);
            if (errors.length)
              colours.push(
                ...errorColour(now.k, [x, y, z][corner3]).map((part) => part * (0.4 + light)), 1,
              );
            else colours.push(0.55 * light, 0.6 * light, 0.75 * light, 1);
          });
        }
      }
  draw(flat, gl.TRIANGLES, places, colours);
};
const touchColour = [1, 0.35, 0.1];
const drawParticles = (now) => {
  const places = [], colours = [], sizesOfPoints = [], q = now.state, half = 3 * now.n;
  for (let i = 0; i < now.n; ++i) {
    const id = idOf(now.k, i), v = half + 3 * i;
    if (lookOf(id)) continue;
    places.push(q[3 * i], q[3 * i + 1], q[3 * i + 2]);
    const colour = id < scene.listed && touches.has(now.k * scene.listed + id)
      ? touchColour
      : id < scene.listed && fixed[id]
        ? [0.75, 0.75, 0.75]
        : errors.length
          ? errorColour(now.k, i)
          : speedColour(Math.hypot(q[v], q[v + 1], q[v + 2]) / fastest);
    colours.push(...colour, 1);
    sizesOfPoints.push(radiusOf(id));
  }
  draw(sprite, gl.POINTS, places, colours, sizesOfPoints);
};
