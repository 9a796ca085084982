// SPDX-License-Identifier: BSD-3-Clause
// The figures of a sweep (src/odeum/sweep/page.cpp): maps over one or two parameters, and the
// quantiles of the components over time.
'use strict';
(() => {
  const { html, svg, plot, number, spanOf, figureOf, rowsOf, pageFigures } = odeum;

  const wide = ({ low, high }) => (high > low ? [low, high] : [low, low + 1]);

  // A cell of a map each, in the colour of its value, from dark to light.
  const drawMap = (host, title, about, cells, valueOf) => {
    const known = cells.filter((cell) => Number.isFinite(valueOf(cell)));
    if (!known.length) return;
    const [across, up] = about.sides, picture = figureOf(host, title),
      low = d3.min(known, valueOf), high = d3.max(known, valueOf),
      colour = d3.scaleSequential(wide({ low, high }), d3.interpolateViridis);
    const axisOf = (side, from, to) => ({
      low: d3.min(cells, (cell) => cell[from]), high: d3.max(cells, (cell) => cell[to]),
      label: side.name, log: side.log,
    });
    const { x, y } = plot(picture, {
      height: 320, description: `${title}: from ${number(low)} to ${number(high)}`, nameless: true,
      x: axisOf(across, 'x0', 'x1'), y: axisOf(up, 'y0', 'y1'), curves: [],
    });
    picture.querySelector('svg').append(
      ...cells.map((cell) => {
        const value = valueOf(cell), left = x.at(cell.x0), top = y.at(cell.y1);
        return svg(
          'rect',
          {
            x: left, y: top, width: Math.max(0.5, x.at(cell.x1) - left + 0.3),
            height: Math.max(0.5, y.at(cell.y0) - top + 0.3),
            fill: Number.isFinite(value) ? colour(value) : 'var(--bad, #c33)', stroke: 'none',
          },
          svg(
            'title', {},
            `${across.name} ${number(cell.x0, 4)} to ${number(cell.x1, 4)}, ` +
              `${up.name} ${number(cell.y0, 4)} to ${number(cell.y1, 4)}: ` +
              `${Number.isFinite(value) ? number(value, 4) : 'none was solved'} ` +
              `(${cell.members} members)`,
          ),
        );
      }),
    );
    host.lastChild.append(
      html(
        'p', { class: 'scale' }, number(low, 4),
        svg(
          'svg', { viewBox: '0 0 128 10', width: 256, height: 12, 'aria-hidden': 'true' },
          d3.range(32).map((k) =>
            svg('rect', {
              x: 4 * k, y: 0, width: 4.3, height: 10, fill: d3.interpolateViridis((k + 0.5) / 32),
            }),
          ),
        ),
        number(high, 4),
      ),
      `A cell has ${title === 'Share solved' ? 'the share' : 'the median'} of the members whose ` +
        `${across.name} and ${up.name} lie in it; in a red one none was solved.`,
    );
  };

  // Over one parameter: the median of the members of each of its values.
  const drawLine = (host, title, about, cells, valueOf) => {
    const [across] = about.sides,
      points = cells
        .map((cell) => ({
          x: across.log ? Math.sqrt(cell.x0 * cell.x1) : (cell.x0 + cell.x1) / 2, y: valueOf(cell),
        }))
        .filter((p) => Number.isFinite(p.y));
    const y = spanOf(points.map((p) => p.y));
    if (!y) return;
    plot(figureOf(host, title), {
      height: 300, description: title, nameless: true,
      x: { low: d3.min(points, (p) => p.x), high: d3.max(points, (p) => p.x) || 1,
        label: across.name, log: across.log },
      y: { ...y, label: title },
      tell: (p) => [`${across.name}: ${number(p.x, 6)}`, `${title}: ${number(p.y, 6)}`],
      curves: [{ name: title, points: points.map((p) => ({ ...p, run: p })), colour: 'var(--s0)',
        shape: 0, bare: points.length > 30 }],
    });
  };

  const drawOverTime = (host, about, name, rows) => {
    const title = `${name} over time`, picture = figureOf(host, title),
      finite = rows.filter((row) => Number.isFinite(row.median));
    if (!finite.length) return;
    const kinds = ['least', 'low', 'median', 'high', 'greatest'];
    plot(picture, {
      height: 300, description: title, nameless: true,
      x: { low: finite[0].time, high: finite[finite.length - 1].time, label: 'time' },
      y: { ...spanOf(finite.flatMap((row) => kinds.map((kind) => row[kind]))), label: name },
      tell: (p, curve) => [curve.name, `time: ${number(p.x, 6)}`, `${name}: ${number(p.y, 6)}`],
      curves: kinds.map((kind) => ({
        name: { low: '5 %', high: '95 %' }[kind] || kind, bare: true, shape: 0,
        dashed: kind !== 'median', colour: kind === 'median' ? 'var(--s0)' : 'var(--dim)',
        points: finite.map((row) => ({ x: row.time, y: row[kind], run: { x: row.time,
          y: row[kind] } })),
      })),
    });
    host.lastChild.append(
      `Least, 5 %, median, 95 % and greatest of ${about.over_time_members} members.`,
    );
  };

  pageFigures.sweep = async (host, about) => {
    const [map, times] = await Promise.all(['map', 'over_time'].map((name) => rowsOf(name)));
    const cells = map.objects(), draw = about.sides.length > 1 ? drawMap : drawLine;
    if (cells.length) {
      about.quantities.forEach((name, k) => {
        if (map.has(`q${k}`)) draw(host, name, about, cells, (cell) => cell[`q${k}`]);
      });
      if (cells.some((cell) => cell.solved < 1))
        draw(host, 'Share solved', about, cells, (cell) => cell.solved);
    }
    for (const [name, rows] of d3.group(times.objects(), (row) => row.component))
      drawOverTime(host, about, name, rows);
  };
})();
