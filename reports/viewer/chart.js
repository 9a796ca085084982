// SPDX-License-Identifier: BSD-3-Clause
// Charts in SVG, coloured by the style sheet; scales, ticks and lines by D3 (version 5, as Debian
// 12 has it).
//
// plot(host, spec) fills the element `host` and returns the scales {x, y}. spec:
//   height, description; x, y: {low, high, log, label, text: (value) => string};
//   cloud: [{x, y, run}], grey dots;
//   curves: [{name, colour (CSS), shape 0-7, dashed, points: [{x, y, run}], window: [x, x],
//     bare: without marks, wide: a broad line, loose: marks alone, stairs, faint}], labelled at
//     their right end; the part between the two x of `window` is drawn thick;
//   levels: [{y, text, shaded}], a line across, shaded: with what is below it;
//   diagonal: the line y = x;
//   bands: [{low, high}]; slopes: [orders], guides; nameless: without names at the ends of curves;
//   tell(run, curve): lines of text for the tooltip; pick(run, curve): on a click or Enter.
'use strict';
(() => {
  const { number, svg, html } = odeum;

  const shapes = [
    'M0-3.6A3.6 3.6 0 1 1 0 3.6 3.6 3.6 0 1 1 0-3.6z', 'M-3.2-3.2H3.2V3.2H-3.2z', 'M0-4.4 4 3H-4z',
    'M0-4.6 4.6 0 0 4.6-4.6 0z', 'M0 4.4 4-3H-4z', 'M-4 0H4M0-4V4',
    'M-3.4-3.4 3.4 3.4M-3.4 3.4 3.4-3.4',
    'M-4.2-1.4H-1.4V-4.2H1.4V-1.4H4.2V1.4H1.4V4.2H-1.4V1.4H-4.2z',
  ];
  const shorten = (text, most) => (text.length <= most ? text : `${text.slice(0, most - 1)}…`);

  // An axis: values to pixels from `from` to `to`, and its ticks.
  const makeAxis = (spec, from, to) => {
    const scale = (spec.log ? d3.scaleLog() : d3.scaleLinear())
      .domain([spec.low, spec.high])
      .range([from, to]);
    const decades = spec.log ? Math.log10(spec.high / spec.low) : 0,
      length = Math.abs(to - from);
    const holds = (v) =>
      Number.isFinite(v) && (!spec.log || v > 0) && v >= spec.low - 1e-9 * Math.abs(spec.low) &&
      v <= spec.high + 1e-9 * Math.abs(spec.high);
    // Powers of ten alone where more do not fit.
    const ticks = (spacing) => {
      if (!spec.log) return scale.ticks(Math.max(2, Math.floor(length / spacing)));
      const every = Math.max(1, Math.ceil(decades / Math.max(2, Math.floor(length / spacing))));
      const powers = d3
        .range(Math.floor(Math.log10(spec.low)), Math.log10(spec.high) + 1)
        .filter((k) => k % every === 0);
      return powers
        .flatMap((k) => (decades < 2 ? [1, 2, 5] : [1]).map((m) => m * 10 ** k))
        .filter(holds);
    };
    const label = (v) => {
      if (spec.text) return [spec.text(v)];
      if (!spec.log || decades < 2) return [number(v, 4)];
      return [
        '10',
        svg(
          'tspan', { dy: -5, 'font-size': 9 }, String(Math.round(Math.log10(v))).replace('-', '−'),
        ),
      ];
    };
    return {
      at: scale, value: scale.invert, holds, ticks, label, from, to, log: Boolean(spec.log),
    };
  };
  // The range of positive numbers, widened by a factor; null where there are none.
  const rangeOf = (values, factor) => {
    const positive = values.filter((v) => Number.isFinite(v) && v > 0);
    return positive.length
      ? { low: d3.min(positive) / factor, high: d3.max(positive) * factor, log: true }
      : null;
  };
  // The same of any numbers, with a margin.
  const spanOf = (values) => {
    const finite = values.filter(Number.isFinite),
      low = d3.min(finite),
      high = d3.max(finite),
      room = 0.04 * (high - low) || Math.abs(high) || 1;
    return finite.length ? { low: low - room, high: high + room } : null;
  };
  const pathOf = (points, x, y, curve = d3.curveLinear) =>
    points.length
      ? d3
          .line()
          .x((p) => Math.round(10 * x.at(p.x)) / 10)
          .y((p) => Math.round(10 * y.at(p.y)) / 10)
          .curve(curve)(points)
      : '';

  // Places texts one below the other, each as near as possible to where it wants to be.
  const spread = (wanted, gap, low, high) => {
    const order = d3.range(wanted.length).sort((a, b) => wanted[a] - wanted[b]),
      placed = [];
    order.forEach((i, k) => {
      placed[k] = Math.max(wanted[i], k ? placed[k - 1] + gap : low);
    });
    let limit = high;
    for (let k = placed.length - 1; k >= 0; --k) {
      placed[k] = Math.min(placed[k], limit);
      limit = placed[k] - gap;
    }
    return wanted.map((_, i) => placed[order.indexOf(i)]);
  };

  const drawAxes = (size, x, y, spec) => {
    const across = x.ticks(52),
      up = y.ticks(30);
    return [
      svg('path', {
        class: 'grid',
        d:
          across.map((v) => `M${x.at(v).toFixed(1)} ${size.top}V${size.bottom}`).join('') +
          up.map((v) => `M${size.left} ${y.at(v).toFixed(1)}H${size.right}`).join(''),
      }),
      across.map((v) =>
        svg('text', { x: x.at(v), y: size.bottom + 15, class: 'middle' }, x.label(v)),
      ),
      up.map((v) => svg('text', { x: size.left - 5, y: y.at(v) + 4, class: 'end' }, y.label(v))),
      svg('path', { d: `M${size.left} ${size.top}V${size.bottom}H${size.right}` }),
      svg(
        'text', { x: (size.left + size.right) / 2, y: size.bottom + 33, class: 'middle' },
        spec.x.label || '',
      ),
      svg(
        'text',
        { transform: `translate(12,${(size.top + size.bottom) / 2}) rotate(-90)`, class: 'middle' },
        spec.y.label || '',
      ),
    ];
  };

  const drawLevels = (size, x, y, spec) => [
    (spec.bands || []).map(({ low, high }) =>
      svg('rect', {
        class: 'shade', x: size.left, width: size.right - size.left,
        y: y.at(Math.min(high, spec.y.high)),
        height: Math.max(0, y.at(Math.max(low, spec.y.low)) - y.at(Math.min(high, spec.y.high))),
      }),
    ),
    (spec.levels || [])
      .filter((level) => y.holds(level.y))
      .map((level) => {
        const at = y.at(level.y);
        return [
          level.shaded
            ? svg('rect', {
                class: 'shade', x: size.left, y: at, width: size.right - size.left,
                height: Math.max(0, size.bottom - at),
              })
            : null,
          svg('path', {
            class: level.shaded ? 'guide dotted' : 'asked', d: `M${size.left} ${at}H${size.right}`,
          }),
          svg(
            'text', { class: 'note', x: size.left + 4, y: level.shaded ? at + 12 : at - 4 },
            level.text || '',
          ),
        ];
      }),
    spec.diagonal
      ? svg('path', {
          class: 'guide',
          d: pathOf(
            [Math.max(spec.x.low, spec.y.low), Math.min(spec.x.high, spec.y.high)].map((v) => ({
              x: v, y: v,
            })),
            x,
            y,
          ),
        })
      : null,
  ];

  // Lines error ~ x^order through the upper right of the field.
  const drawSlopes = (size, x, y, orders) =>
    orders.map((order) => {
      const far = x.value(size.right - 8),
        top = y.value(size.top + 8);
      const bottom = y.value(size.bottom - 4),
        near = x.value(size.left + 4);
      const end = top * (near / far) ** order;
      const point =
        end >= bottom ? { x: near, y: end } : { x: far * (bottom / top) ** (1 / order), y: bottom };
      return [
        svg('path', { class: 'guide', d: pathOf([{ x: far, y: top }, point], x, y) }),
        svg('text', { class: 'note', x: x.at(point.x) + 3, y: y.at(point.y) - 4 }, String(order)),
      ];
    });

  const pointsInside = (curve, x, y) => curve.points.filter((p) => x.holds(p.x) && y.holds(p.y));
  const drawCurve = (curve, x, y) => {
    const inside = pointsInside(curve, x, y),
      within = curve.window
        ? inside.filter(
            (p) => p.x >= curve.window[0] * (1 - 1e-6) && p.x <= curve.window[1] * (1 + 1e-6),
          )
        : [];
    const style = ['curve', curve.dashed && 'dashed', curve.wide && 'broad', curve.faint && 'faint']
      .filter(Boolean)
      .join(' ');
    return svg(
      'g', { style: { color: curve.colour } },
      inside.length > 1 && !curve.loose
        ? svg(
            'path',
            {
              class: style,
              d: pathOf(inside, x, y, curve.stairs ? d3.curveStepAfter : d3.curveLinear),
            },
            svg('title', {}, curve.name),
          )
        : null,
      within.length > 1 ? svg('path', { class: 'curve window', d: pathOf(within, x, y) }) : null,
      curve.bare
        ? null
        : inside.map((p) =>
            svg('path', {
              class: `marker${curve.faint ? ' faint' : ''}`, d: shapes[curve.shape || 0],
              transform: `translate(${x.at(p.x).toFixed(1)},${y.at(p.y).toFixed(1)})`,
            }),
          ),
    );
  };

  const shortName = (name) => name.replace(/^[^/ ]+\//, '');
  const drawNames = (size, x, y, curves, texts) => {
    const ends = curves
      .map((curve, k) => ({
        curve, text: texts[k], end: d3.greatest(pointsInside(curve, x, y), (p) => p.x),
      }))
      .filter(({ end }) => end);
    if (!ends.length) return [];
    const gap = Math.min(14, (size.bottom - size.top) / ends.length);
    const places = spread(
      ends.map(({ end }) => y.at(end.y)), gap, size.top + 4, size.bottom,
    );
    return ends.map(({ curve, text, end }, i) =>
      svg(
        'g', { style: { color: curve.colour } },
        svg('path', {
          class: 'leader',
          d:
            `M${(x.at(end.x) + 5).toFixed(1)} ${y.at(end.y).toFixed(1)}L${size.right + 4} ` +
            `${places[i].toFixed(1)}`,
        }),
        svg(
          'text', { class: 'name', x: size.right + 7, y: places[i] + 4 }, text,
          svg('title', {}, curve.name),
        ),
      ),
    );
  };

  // The tooltip: the nearest run to the pointer; arrows and Enter do the same from the keyboard.
  const attachPointer = (host, picture, spec, x, y) => {
    if (!spec.tell) return;
    const tip = html('div', { class: 'tip', role: 'status', hidden: true });
    const ring = svg('circle', { class: 'ring', r: 7, visibility: 'hidden' });
    picture.append(ring);
    host.append(tip);
    const drawn = [
      ...spec.curves.flatMap((curve, c) =>
        pointsInside(curve, x, y).map((point) => ({ point, curve, c, near: 22 })),
      ),
      ...(spec.cloud || [])
        .filter((p) => x.holds(p.x) && y.holds(p.y))
        .map((point) => ({ point, curve: null, c: -1, near: 8 })),
    ];
    let shown = null;
    const show = (item) => {
      shown = item;
      tip.hidden = !item;
      ring.setAttribute('visibility', item ? 'visible' : 'hidden');
      if (!item) return;
      const left = x.at(item.point.x),
        top = y.at(item.point.y);
      ring.setAttribute('cx', left);
      ring.setAttribute('cy', top);
      tip.replaceChildren(
        ...spec
          .tell(item.point.run, item.curve)
          .map((line, i) => html(i ? 'div' : 'strong', {}, line)),
      );
      const most = Math.max(0, host.clientWidth - tip.offsetWidth - 4);
      tip.style.left = `${Math.min(left + 12, most)}px`;
      tip.style.top = `${top + 14}px`;
    };
    const nearest = (event) => {
      const box = picture.getBoundingClientRect(),
        px = event.clientX - box.left,
        py = event.clientY - box.top,
        scale = picture.viewBox.baseVal.width / (box.width || 1);
      const away = (item) =>
        Math.hypot(x.at(item.point.x) - scale * px, y.at(item.point.y) - scale * py) / item.near;
      const best = d3.least(drawn, away);
      return best && away(best) < 1 ? best : null;
    };
    picture.addEventListener('pointermove', (event) => show(nearest(event)));
    picture.addEventListener('pointerleave', () => show(null));
    picture.addEventListener('blur', () => show(null));
    picture.addEventListener('click', (event) => {
      const item = nearest(event);
      show(item);
      if (item && spec.pick) spec.pick(item.point.run, item.curve);
    });
    picture.addEventListener('keydown', (event) => {
      const own = drawn.filter((item) => item.curve),
        i = own.indexOf(shown);
      const onCurve = (c) => own.find((item) => item.c === c);
      const next = {
        ArrowRight: own[Math.min(own.length - 1, i + 1)], ArrowLeft: own[Math.max(0, i - 1)],
        ArrowDown: shown && onCurve(shown.c + 1), ArrowUp: shown && onCurve(shown.c - 1),
      }[event.key];
      if (event.key === 'Enter' && shown && spec.pick) spec.pick(shown.point.run, shown.curve);
      else if (event.key === 'Escape') show(null);
      else if (next) show(next);
      else if (!event.key.startsWith('Arrow')) return;
      event.preventDefault();
    });
  };

  // What each colour and shape is, where names at the ends of curves have no room.
  const legendOf = (entries) =>
    html(
      'ul', { class: 'legend' },
      entries.map(({ name, colour, shape, dashed, bare }) =>
        html(
          'li', {},
          svg(
            'svg', { viewBox: '-14 -6 28 12', 'aria-hidden': 'true', style: { color: colour } },
            svg('path', { class: `curve${dashed ? ' dashed' : ''}`, d: 'M-13 0H13' }),
            bare ? null : svg('path', { class: 'marker', d: shapes[shape || 0] }),
          ),
          name,
        ),
      ),
    );

  const plot = (host, spec) => {
    const width = Math.max(240, spec.width || host.clientWidth || 640),
      height = spec.height || 400;
    const named = spec.curves.filter((curve) => curve.name && !curve.nameless);
    // A name is whole, or without its library, which the colour tells; where that has no room
    // either, a legend has all of them.
    const longest = (names) => (d3.max(names, (name) => name.length) || 0) * 6.4 + 14;
    const texts = [
      named.map((curve) => curve.name), named.map((curve) => shortName(curve.name)),
    ].find((names) => longest(names) <= width * 0.36);
    const room = width < 520 || spec.nameless || !texts ? 0 : longest(texts);
    const size = { left: 58, right: width - room - 12, top: 10, bottom: height - 42 };
    const x = makeAxis(spec.x, size.left, size.right),
      y = makeAxis(spec.y, size.bottom, size.top);
    const dots = (spec.cloud || [])
      .filter((p) => x.holds(p.x) && y.holds(p.y))
      .map((p) => `M${x.at(p.x).toFixed(1)} ${y.at(p.y).toFixed(1)}h0`)
      .join('');
    const picture = svg(
      'svg',
      {
        class: 'plot live', width, height, viewBox: `0 0 ${width} ${height}`, role: 'img',
        tabindex: spec.tell ? 0 : undefined, 'aria-label': spec.description,
      },
      drawAxes(size, x, y, spec),
      drawLevels(size, x, y, spec),
      drawSlopes(size, x, y, spec.slopes || []),
      svg('path', { class: 'cloud', d: dots }),
      spec.curves.map((curve) => drawCurve(curve, x, y)),
      room ? drawNames(size, x, y, named, texts) : [],
    );
    host.classList.add('plot-host');
    host.replaceChildren(
      picture, ...(room || spec.nameless || !named.length ? [] : [legendOf(named)]),
    );
    attachPointer(host, picture, spec, x, y);
    return { x, y };
  };

  Object.assign(odeum, { shorten, makeAxis, rangeOf, spanOf, spread, drawAxes, legendOf, plot });
})();
