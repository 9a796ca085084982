// SPDX-License-Identifier: BSD-3-Clause
// A line chart in SVG, coloured by the style sheet.
//
// plot(host, spec) fills the element `host`. spec:
//   height, description; x, y: axes (axes.js);
//   cloud: [{x, y, run}], grey dots;
//   curves: [{name, colour (a CSS colour), shape 0-7, dashed, points: [{x, y, run}], window: [x, x],
//     bare: without marks, wide: a broad line}],
//     labelled at their right end; the part between the two x of `window` is drawn thick;
//   levels: [{y, text, shaded}], a line across, shaded: with what is below it;
//   slopes: [orders], guides;
//   tell(run, curve): lines of text for the tooltip; pick(run, curve): on a click or Enter.
const shapes = ['M0-3.6A3.6 3.6 0 1 1 0 3.6 3.6 3.6 0 1 1 0-3.6z', 'M-3.2-3.2H3.2V3.2H-3.2z', 'M0-4.4 4 3H-4z',
  'M0-4.6 4.6 0 0 4.6-4.6 0z', 'M0 4.4 4-3H-4z', 'M-4 0H4M0-4V4', 'M-3.4-3.4 3.4 3.4M-3.4 3.4 3.4-3.4',
  'M-4.2-1.4H-1.4V-4.2H1.4V-1.4H4.2V1.4H1.4V4.2H-1.4V1.4H-4.2z'];
const pathOf = (points, x, y) => points.map((p, i) => `${i ? 'L' : 'M'}${x.at(p.x).toFixed(1)} ${y.at(p.y).toFixed(1)}`).join('');
const shorten = (text, most) => (text.length <= most ? text : `${text.slice(0, most - 1)}…`);

// Places texts one below the other, each as near as possible to where it wants to be.
const spread = (wanted, gap, low, high) => {
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b]);
  const placed = [];
  order.forEach((i, k) => { placed[k] = Math.max(wanted[i], k ? placed[k - 1] + gap : low); });
  let limit = high;
  for (let k = placed.length - 1; k >= 0; --k) { placed[k] = Math.min(placed[k], limit); limit = placed[k] - gap; }
  const result = [];
  order.forEach((i, k) => { result[i] = placed[k]; });
  return result;
};

const drawAxes = (size, x, y, spec) => {
  const grid = [], labels = [];
  for (const value of x.ticks(52)) {
    grid.push(`M${x.at(value).toFixed(1)} ${size.top}V${size.bottom}`);
    labels.push(svg('text', { x: x.at(value), y: size.bottom + 15, class: 'middle' }, x.label(value)));
  }
  for (const value of y.ticks(30)) {
    grid.push(`M${size.left} ${y.at(value).toFixed(1)}H${size.right}`);
    labels.push(svg('text', { x: size.left - 5, y: y.at(value) + 4, class: 'end' }, y.label(value)));
  }
  return [svg('path', { class: 'grid', d: grid.join('') }), labels,
    svg('path', { d: `M${size.left} ${size.top}V${size.bottom}H${size.right}` }),
    svg('text', { x: (size.left + size.right) / 2, y: size.bottom + 33, class: 'middle' }, spec.x.label || ''),
    svg('text', { transform: `translate(12,${(size.top + size.bottom) / 2}) rotate(-90)`, class: 'middle' }, spec.y.label || '')];
};

const drawLevels = (size, y, levels) => levels.filter((level) => y.holds(level.y)).map((level) => {
  const at = y.at(level.y);
  return [level.shaded ? svg('rect', { class: 'shade', x: size.left, y: at, width: size.right - size.left, height: Math.max(0, size.bottom - at) }) : null,
    svg('path', { class: level.shaded ? 'guide dotted' : 'asked', d: `M${size.left} ${at}H${size.right}` }),
    svg('text', { class: 'note', x: size.left + 4, y: level.shaded ? at + 12 : at - 4 }, level.text)];
});

// Lines error ~ x^order through the upper right of the field.
const drawSlopes = (size, x, y, orders) => orders.map((order) => {
  const far = x.value(size.right - 8), top = y.value(size.top + 8);
  const bottom = y.value(size.bottom - 4), near = x.value(size.left + 4);
  const end = top * (near / far) ** order;
  const point = end >= bottom ? { x: near, y: end } : { x: far * (bottom / top) ** (1 / order), y: bottom };
  return [svg('path', { class: 'guide', d: pathOf([{ x: far, y: top }, point], x, y) }),
    svg('text', { class: 'note', x: x.at(point.x) + 3, y: y.at(point.y) - 4 }, String(order))];
});

const drawCurve = (curve, x, y) => {
  const inside = curve.points.filter((p) => x.holds(p.x) && y.holds(p.y));
  const parts = [];
  if (inside.length > 1 && !curve.loose) parts.push(svg('path', { class: `curve${curve.dashed ? ' dashed' : ''}${curve.wide ? ' broad' : ''}`, d: pathOf(inside, x, y) }));
  if (curve.window) {
    const within = inside.filter((p) => p.x >= curve.window[0] * (1 - 1e-6) && p.x <= curve.window[1] * (1 + 1e-6));
    if (within.length > 1) parts.push(svg('path', { class: 'curve window', d: pathOf(within, x, y) }));
  }
  for (const p of curve.bare ? [] : inside)
    parts.push(svg('path', { class: 'marker', d: shapes[curve.shape || 0], transform: `translate(${x.at(p.x).toFixed(1)},${y.at(p.y).toFixed(1)})` }));
  return svg('g', { style: { color: curve.colour } }, parts);
};

const drawNames = (size, x, y, curves, room) => {
  const ends = [];
  for (const curve of curves) {
    const inside = curve.points.filter((p) => x.holds(p.x) && y.holds(p.y));
    if (inside.length) ends.push({ curve, end: inside.reduce((a, b) => (b.x > a.x ? b : a)) });
  }
  if (!ends.length || room < 40) return [];
  const gap = Math.min(14, (size.bottom - size.top) / ends.length);
  const places = spread(ends.map(({ end }) => y.at(end.y)), gap, size.top + 4, size.bottom);
  return ends.map(({ curve, end }, i) => svg('g', { style: { color: curve.colour } },
    svg('path', { class: 'leader', d: `M${(x.at(end.x) + 5).toFixed(1)} ${y.at(end.y).toFixed(1)}L${size.right + 4} ${places[i].toFixed(1)}` }),
    svg('text', { class: 'name', x: size.right + 7, y: places[i] + 4 }, shorten(curve.name, Math.floor((room - 8) / 7)),
      svg('title', {}, curve.name))));
};

// The tooltip: the nearest run to the pointer; arrows and Enter do the same from the keyboard.
const attachPointer = (host, picture, spec, x, y) => {
  const tip = html('div', { class: 'tip', role: 'status', hidden: true });
  const ring = svg('circle', { class: 'ring', r: 7, visibility: 'hidden' });
  picture.append(ring);
  host.append(tip);
  const drawn = [];
  spec.curves.forEach((curve, c) => curve.points.forEach((point) => { if (x.holds(point.x) && y.holds(point.y)) drawn.push({ point, curve, c, near: 22 }); }));
  (spec.cloud || []).forEach((point) => { if (x.holds(point.x) && y.holds(point.y)) drawn.push({ point, curve: null, c: -1, near: 8 }); });
  let shown = null;
  const show = (item) => {
    shown = item;
    tip.hidden = !item;
    ring.setAttribute('visibility', item ? 'visible' : 'hidden');
    if (!item) return;
    const left = x.at(item.point.x), top = y.at(item.point.y);
    ring.setAttribute('cx', left);
    ring.setAttribute('cy', top);
    tip.replaceChildren(...spec.tell(item.point.run, item.curve).map((line, i) => html(i ? 'div' : 'strong', {}, line)));
    tip.style.left = `${Math.min(left + 12, Math.max(0, host.clientWidth - tip.offsetWidth - 4))}px`;
    tip.style.top = `${top + 14}px`;
  };
  const nearest = (event) => {
    const box = picture.getBoundingClientRect(), px = event.clientX - box.left, py = event.clientY - box.top;
    let best = null, least = 1;
    for (const item of drawn) {
      const away = Math.hypot(x.at(item.point.x) - px, y.at(item.point.y) - py) / item.near;
      if (away < least) { least = away; best = item; }
    }
    return best;
  };
  picture.addEventListener('pointermove', (event) => show(nearest(event)));
  picture.addEventListener('pointerleave', () => show(null));
  picture.addEventListener('blur', () => show(null));
  picture.addEventListener('click', (event) => { const item = nearest(event); show(item); if (item && spec.pick) spec.pick(item.point.run, item.curve); });
  picture.addEventListener('keydown', (event) => {
    const own = drawn.filter((item) => item.curve), i = own.indexOf(shown);
    const onCurve = (c) => own.find((item) => item.c === c);
    const next = { ArrowRight: own[Math.min(own.length - 1, i + 1)], ArrowLeft: own[Math.max(0, i - 1)],
      ArrowDown: shown && onCurve(shown.c + 1), ArrowUp: shown && onCurve(shown.c - 1) }[event.key];
    if (event.key === 'Enter' && shown && spec.pick) spec.pick(shown.point.run, shown.curve);
    else if (event.key === 'Escape') show(null);
    else if (next) show(next);
    else if (!event.key.startsWith('Arrow')) return;
    event.preventDefault();
  });
};

const plot = (host, spec) => {
  const width = Math.max(280, host.clientWidth || 640), height = spec.height || 400;
  const longest = Math.max(0, ...spec.curves.map((curve) => curve.name.length));
  const room = width < 520 ? 0 : Math.min(longest * 7 + 12, width * 0.3);
  const size = { left: 58, right: width - room - 12, top: 10, bottom: height - 42 };
  const x = makeAxis(spec.x, size.left, size.right), y = makeAxis(spec.y, size.bottom, size.top);
  const dots = (spec.cloud || []).filter((p) => x.holds(p.x) && y.holds(p.y))
    .map((p) => `M${x.at(p.x).toFixed(1)} ${y.at(p.y).toFixed(1)}h0`).join('');
  const picture = svg('svg', { class: 'plot live', width, height, viewBox: `0 0 ${width} ${height}`, role: 'img', tabindex: 0, 'aria-label': spec.description },
    drawAxes(size, x, y, spec), drawLevels(size, y, spec.levels || []), drawSlopes(size, x, y, spec.slopes || []),
    svg('path', { class: 'cloud', d: dots }), spec.curves.map((curve) => drawCurve(curve, x, y)),
    drawNames(size, x, y, spec.curves, room));
  host.classList.add('plot-host');
  // Where there is no room beside the field, the names stand below it.
  const names = room ? [] : [html('ul', { class: 'legend' }, spec.curves.map((curve) =>
    html('li', {}, svg('svg', { viewBox: '-8 -6 16 12', 'aria-hidden': 'true', style: { color: curve.colour } }, svg('path', { class: 'marker', d: shapes[curve.shape || 0] })), curve.name)))];
  host.replaceChildren(picture, ...names);
  attachPointer(host, picture, spec, x, y);
  return { x, y };
};
