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
//     filled: with full marks;
//   diagonal: the line y = x;
//   bands: [{low, high}]; slopes: [orders], guides; nameless: without names at the ends of curves;
//   tell(run, curve): lines of text for the tooltip; pick(run, curve): on a click or Enter.
'use strict';
(() => {
  const { svg, pointsInside, spread, html, makeAxis, attachPointer } = odeum;

  const shapes = [
    'M0-3.6A3.6 3.6 0 1 1 0 3.6 3.6 3.6 0 1 1 0-3.6z', 'M-3.2-3.2H3.2V3.2H-3.2z', 'M0-4.4 4 3H-4z',
    'M0-4.6 4.6 0 0 4.6-4.6 0z', 'M0 4.4 4-3H-4z', 'M-4 0H4M0-4V4',
    'M-3.4-3.4 3.4 3.4M-3.4 3.4 3.4-3.4',
    'M-4.2-1.4H-1.4V-4.2H1.4V-1.4H4.2V1.4H1.4V4.2H-1.4V1.4H-4.2z',
  ];
  const shorten = (text, most) => (text.length <= most ? text : `${text.slice(0, most - 1)}…`);

  const pathOf = (points, x, y, curve = d3.curveLinear) =>
    points.length
      ? d3
          .line()
          .x((p) => Math.round(10 * x.at(p.x)) / 10)
          .y((p) => Math.round(10 * y.at(p.y)) / 10)
          .curve(curve)(points)
      : '';

  const drawAxes = (size, x, y, spec) => {
    const across = x.ticks(52), up = y.ticks(30);
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

  // Their texts stand above the curves.
  const drawLevelTexts = (size, y, levels) =>
    levels
      .filter((level) => y.holds(level.y))
      .map((level) =>
        svg(
          'text',
          {
            class: 'note over', x: size.left + 4, y: y.at(level.y) + (level.shaded ? 12 : -4),
          },
          level.text || '',
        ),
      );

  // Lines error ~ x^order through the upper right of the field.
  const drawSlopes = (size, x, y, orders) =>
    orders.map((order) => {
      const far = x.value(size.right - 8), top = y.value(size.top + 8);
      const bottom = y.value(size.bottom - 4), near = x.value(size.left + 4);
      const end = top * (near / far) ** order;
      const point =
        end >= bottom ? { x: near, y: end } : { x: far * (bottom / top) ** (1 / order), y: bottom };
      return [
        svg('path', { class: 'guide', d: pathOf([{ x: far, y: top }, point], x, y) }),
        svg('text', { class: 'note', x: x.at(point.x) + 3, y: y.at(point.y) - 4 }, String(order)),
      ];
    });

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
              class: `marker${curve.faint ? ' faint' : ''}${curve.filled ? ' filled' : ''}`,
              d: shapes[curve.shape || 0],
              transform: `translate(${x.at(p.x).toFixed(1)},${y.at(p.y).toFixed(1)})`,
            }),
          ),
    );
  };

  // Names without their libraries, but for those that two solvers share then.
  const shortNames = (names) => {
    const short = names.map((name) => name.replace(/^[^/ ]+\//, ''));
    const shared = (name) => short.indexOf(name) !== short.lastIndexOf(name);
    return short.map((name, k) => (shared(name) ? names[k] : name));
  };
  const drawNames = (size, x, y, curves, texts) => {
    const ends = curves
      .map((curve, k) => ({
        curve, text: texts[k], end: d3.greatest(pointsInside(curve, x, y), (p) => p.x),
      }))
      .filter(({ end }) => end);
    if (!ends.length) return [];
    const gap = Math.min(14, (size.bottom - size.top) / ends.length);
    const places = spread(ends.map(({ end }) => y.at(end.y)), gap, size.top + 4, size.bottom);
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

  // What each colour and shape is, where names at the ends of curves have no room.
  const legendOf = (entries) =>
    html(
      'ul', { class: 'legend' },
      entries.map(({ name, colour, shape, dashed, bare, filled }) =>
        html(
          'li', {},
          svg(
            'svg', { viewBox: '-14 -6 28 12', 'aria-hidden': 'true', style: { color: colour } },
            svg('path', { class: `curve${dashed ? ' dashed' : ''}`, d: 'M-13 0H13' }),
            bare
              ? null
              : svg('path', { class: `marker${filled ? ' filled' : ''}`, d: shapes[shape || 0] }),
          ),
          name,
        ),
      ),
    );

  const plot = (host, spec) => {
    const width = Math.max(240, spec.width || host.clientWidth || 640), height = spec.height || 400;
    const named = spec.curves.filter((curve) => curve.name && !curve.nameless);
    // A name is whole, or without its library, which the colour tells, where the methods differ;
    // where that has no room either, a legend has all of them.
    const longest = (names) => (d3.max(names, (name) => name.length) || 0) * 6.4 + 14;
    const whole = named.map((curve) => curve.name);
    const texts = [whole, shortNames(whole)].find((names) => longest(names) <= width * 0.36);
    const room = width < 520 || spec.nameless || !texts ? 0 : longest(texts);
    const size = { left: 58, right: width - room - 12, top: 10, bottom: height - 42 };
    const x = makeAxis(spec.x, size.left, size.right), y = makeAxis(spec.y, size.bottom, size.top);
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
      drawLevelTexts(size, y, spec.levels || []),
      room ? drawNames(size, x, y, named, texts) : [],
    );
    host.classList.add('plot-host');
    host.replaceChildren(
      picture, ...(room || spec.nameless || !named.length ? [] : [legendOf(named)]),
    );
    attachPointer(host, picture, spec, x, y);
    return { x, y };
  };

  Object.assign(odeum, { shorten, shortNames, drawAxes, legendOf, plot });
})();
