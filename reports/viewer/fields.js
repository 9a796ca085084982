// SPDX-License-Identifier: BSD-3-Clause
// Pictures over a plane: a field on triangles, and the types of an equation.
'use strict';
(() => {
  const {
    makeAxis, svg, number, drawAxes, blocks, checkKeys, prepare, Template, emptyText, html, grouped,
    columnOf, figureOf, rowsOf, pageFigures,
  } = odeum;

  // Scales of x and y with the same unit of length in both, as wide as `host`, at most `most`
  // pixels.
  const planeOf = (
    host, [x0, x1, y0, y1], { most = 480, left = 46, right = 12, below = 42, square = false } = {},
  ) => {
    const wide = Math.min(most, Math.max(200, host.clientWidth || most) - left - right);
    const scale = square ? 0 : wide / Math.max(x1 - x0, y1 - y0),
      across = square ? wide : scale * (x1 - x0),
      up = square ? wide : scale * (y1 - y0);
    const size = { left, right: left + across, top: 10, bottom: 10 + up };
    return {
      size, x: makeAxis({ low: x0, high: x1 }, size.left, size.right),
      y: makeAxis({ low: y0, high: y1 }, size.bottom, size.top), width: left + across + right,
      height: 10 + up + below,
    };
  };
  const pictureOver = (plane, label, ...children) =>
    svg(
      'svg',
      {
        class: 'plot live', width: plane.width, height: plane.height,
        viewBox: `0 0 ${plane.width} ${plane.height}`, role: 'img', 'aria-label': label,
        style: { 'max-width': `${Math.ceil(plane.width)}px` },
      },
      children,
    );

  // Rows with x1, y1, … y3 and NAME1 to NAME3 as triangles {x, y, values}.
  const trianglesOf = (rows, name) =>
    rows.map((row) => ({
      x: [row.x1, row.x2, row.x3], y: [row.y1, row.y2, row.y3],
      values: [1, 2, 3].map((k) => row[`${name}${k}`]),
    }));
  // Triangles in the colours of the means of their nodes' values, from the lowest to the highest of
  // all, which stand beside; from dark to light, so that it reads without colours too. A triangle
  // tells its middle and its value.
  const drawField = (host, triangles, label) => {
    const values = triangles.flatMap((t) => t.values), low = d3.min(values), high = d3.max(values),
      bar = 14,
      bars = 32;
    const plane = planeOf(
      host,
      [...d3.extent(triangles.flatMap((t) => t.x)), ...d3.extent(triangles.flatMap((t) => t.y))],
      { most: 400, right: 84 },
    );
    const { size, x, y } = plane,
      colour = d3.scaleSequential(high > low ? [low, high] : [low, low + 1], d3.interpolateViridis),
      tall = size.bottom - size.top;
    const placeOf = (a, b) => `${x.at(a).toFixed(1)} ${y.at(b).toFixed(1)}`;
    host.replaceChildren(
      pictureOver(
        plane, `${label}: from ${number(low)} to ${number(high)}`,
        drawAxes(size, x, y, { x: { label: 'x' }, y: { label: 'y' } }),
        svg(
          'g', { class: 'triangles' },
          triangles.map((t) =>
            svg(
              'path',
              {
                d: `M${t.x.map((v, k) => placeOf(v, t.y[k])).join('L')}Z`,
                fill: colour(d3.mean(t.values)),
              },
              svg(
                'title', {},
                `(${number(d3.mean(t.x))}, ${number(d3.mean(t.y))}): ` +
                  `${number(d3.mean(t.values), 4)}`,
              ),
            ),
          ),
        ),
        svg(
          'g', { class: 'scale' },
          d3.range(bars).map((k) =>
            svg('rect', {
              x: size.right + 14, y: size.bottom - ((k + 1) * tall) / bars, width: bar,
              height: tall / bars + 0.5, fill: d3.interpolateViridis((k + 0.5) / bars),
            }),
          ),
        ),
        svg('text', { x: size.right + 18 + bar, y: size.top + 10 }, number(high)),
        svg('text', { x: size.right + 18 + bar, y: size.bottom }, number(low)),
      ),
    );
  };

  // The block `field`: pictures of fields on triangles.
  //   rows: with x1, y1, … y3 of the triangles' nodes
  //   values:        a list: heading = NAME, a picture each of the columns NAME1 to NAME3
  //   by: template   pictures of its own for each text
  blocks.field = async (host, spec, context) => {
    checkKeys(spec, 'field', ['values', 'by']);
    const {
      rows, indices, bound: [by],
    } = await prepare(spec, context, [spec.by ? new Template(spec.by) : null]);
    if (!indices.length) return emptyText(host, spec);
    const all = rows.objects(), figures = html('div', { class: 'figures' });
    host.append(figures);
    for (const [name, members] of grouped(indices, by ? by.text : () => ''))
      for (const { heading, cell } of spec.values.map(columnOf)) {
        const title = name ? `${name}: ${heading}` : heading;
        drawField(
          figureOf(figures, title),
          trianglesOf(members.map((i) => all[i]), cell.trim()),
          title,
        );
      }
    return null;
  };

  const fieldFigures = async (host) => {
    const triangles = await rowsOf('triangles'), rows = triangles.objects();
    if (!rows.length) return;
    for (const [name, title] of [['u', 'Solution u'], ['error', 'Error at the nodes']])
      if (triangles.has(`${name}1`))
        drawField(figureOf(host, title), trianglesOf(rows, name), title);
  };

  // Regions by type, where the type changes, and the characteristic directions.
  const typeFigures = async (host, about) => {
    const [regions, directions, changes] = (
      await Promise.all(['types', 'characteristics', 'type_changes'].map((name) => rowsOf(name)))
    ).map((rows) => rows.objects());
    const picture = figureOf(host, 'Types'),
      plane = planeOf(picture, about.region, { square: true }),
      { size, x, y } = plane;
    const types = [
        ...new Set([...regions.map((row) => row.type), ...(changes.length ? ['parabolic'] : [])]),
      ],
      stroke = (0.4 * (size.right - size.left)) / 24;
    const strokes = directions.map((row) => {
      // In the picture's own proportions.
      const dx = x.at(row.x + row.dx) - x.at(row.x), dy = y.at(row.y + row.dy) - y.at(row.y),
        part = stroke / Math.hypot(dx, dy),
        at = [x.at(row.x), y.at(row.y)];
      return (
        `M${(at[0] - part * dx).toFixed(1)} ` +
        `${(at[1] - part * dy).toFixed(1)}L${(at[0] + part * dx).toFixed(1)} ` +
        `${(at[1] + part * dy).toFixed(1)}`
      );
    });
    picture.append(
      pictureOver(
        plane, `Types over x and ${about.second}: ${types.join(', ')}`,
        regions.map((row) =>
          svg('rect', {
            class: `type ${row.type}`, x: x.at(row.x0).toFixed(2), y: y.at(row.y1).toFixed(2),
            width: (x.at(row.x1) - x.at(row.x0)).toFixed(2),
            height: (y.at(row.y0) - y.at(row.y1)).toFixed(2),
          }),
        ),
        drawAxes(size, x, y, { x: { label: 'x' }, y: { label: about.second } }),
        svg('path', { class: 'directions', d: strokes.join('') }),
        changes.map((row) =>
          svg('circle', {
            class: 'type parabolic', cx: x.at(row.x).toFixed(1), cy: y.at(row.y).toFixed(1), r: 1.6,
          }),
        ),
      ),
      html(
        'ul', { class: 'legend' },
        types.map((type) =>
          html(
            'li', {},
            svg(
              'svg', { viewBox: '-14 -6 28 12', 'aria-hidden': 'true' },
              svg('rect', { class: `type ${type}`, x: -10, y: -6, width: 20, height: 12 }),
            ),
            type.replace('_', ' '),
          ),
        ),
        directions.length
          ? html(
              'li', {},
              svg(
                'svg', { viewBox: '-14 -6 28 12', 'aria-hidden': 'true' },
                svg('path', { class: 'curve', d: 'M-10 4L10 -4' }),
              ),
              'characteristic direction',
            )
          : null,
      ),
    );
  };

  Object.assign(pageFigures, { types: typeFigures, field: fieldFigures });

  Object.assign(odeum, { trianglesOf });
})();
