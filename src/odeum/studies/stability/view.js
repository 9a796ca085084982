// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the page of stability.
//
//   ```axis_limits    the limits along the three axes, measured and by theory, a table for each
//                     library
//   ```region_pictures
//   plane: lambda     small pictures of the regions in a plane, by library; one is drawn when it
//                     comes into sight
'use strict';
(() => {
  const {
    blocks, checkKeys, number, linkOf, html, rowsOf, emptyText, idOf, lazyDetails, versionOf,
    plural, tableOf, makeAxis, svg, loadRegions, addressOf,
  } = odeum;

  blocks.axis_limits = async (host, spec) => {
    checkKeys(spec, 'axis_limits', []);
    const axes = [
      ['real', 'real axis'], ['imaginary', 'imaginary axis'], ['oscillator', 'oscillator, ωh'],
    ];
    const word = (text, title) => [
      { text, title, class: 'dim', value: NaN }, { text: '', value: NaN }, { text: '', value: NaN },
    ];
    const cellsOf = (row) => {
      const differs = row?.status === 'differs';
      if (!row || (row.status !== 'ok' && !differs))
        return word(row ? row.status.replaceAll('_', ' ') : '·', row?.detail);
      return [
        { text: number(row.limit, 8), value: row.limit, title: row.detail },
        { text: number(row.theory, 8), value: row.theory, class: 'dim' },
        {
          text: `${differs ? 'differs: ' : ''}${number(row.difference, 2)}`, value: row.difference,
          class: differs ? 'lower' : 'dim',
        },
      ];
    };
    const lineOf = ([solver, rows]) => ({
      cells: [
        { text: solver, node: linkOf('{library}/{solver}', solver) },
        ...axes.flatMap(([axis]) => cellsOf(rows.find((row) => row.axis === axis))),
      ],
    });
    const above = html(
      'tr', {}, html('td', {}),
      axes.map(([, text]) => html('th', { colspan: 3, scope: 'colgroup' }, text)),
    );
    const headings = [
      { text: 'solver' },
      ...axes.flatMap(() => [{ text: 'measured' }, { text: 'theory' }, { text: 'difference' }]),
    ];
    const rows = (await rowsOf('stability_limits')).objects();
    if (!rows.length) return emptyText(host, spec);
    [...d3.group(rows, (row) => row.library)].forEach(([library, some], k) => {
      const solvers = [...d3.group(some, idOf)].filter(([, list]) =>
        list.some((row) => row.status !== 'not_applicable'),
      );
      if (solvers.length)
        host.append(
          lazyDetails(
            [
              html('strong', {}, library), ` ${versionOf(library)} `,
              html('span', { class: 'dim' }, plural(solvers.length, 'solver')),
            ],
            () => tableOf(headings, solvers.map(lineOf), 'numbers limits', above.cloneNode(true)),
            k === 0,
          ),
        );
    });
    return null;
  };

  // A loop as a path; `open`: without the parts that run along the edges of the picture, which are
  // not a boundary.
  const loopPath = (region, loop, x, y, open) => {
    const [left, right, bottom, top] = region.box,
      near = [1e-3 * (right - left), 1e-3 * (top - bottom)];
    const edges = (i) => [
      Math.abs(loop[i] - left) < near[0], Math.abs(loop[i] - right) < near[0],
      Math.abs(loop[i + 1] - bottom) < near[1], Math.abs(loop[i + 1] - top) < near[1],
    ];
    const place = (i) => `${x(loop[i]).toFixed(1)} ${y(loop[i + 1]).toFixed(1)}`;
    if (!open) return `M${d3.range(0, loop.length, 2).map(place).join('L')}Z`;
    return d3
      .range(0, loop.length, 2)
      .map((i) => {
        const next = (i + 2) % loop.length, ends = [edges(i), edges(next)];
        return ends[0].some((at, k) => at && ends[1][k]) ? '' : `M${place(i)}L${place(next)}`;
      })
      .join('');
  };
  const regionPicture = (region) => {
    const [left, right, bottom, top] = region.box;
    const aspect =
      region.plane === 'lambda'
        ? Math.min(3, Math.max(0.5, (right - left) / (top - bottom)))
        : 1.25;
    const field = { left: 25, right: 225, top: 4, bottom: 4 + 200 / aspect }, width = 230,
      height = field.bottom + 17;
    const x = makeAxis({ low: left, high: right }, field.left, field.right),
      y = makeAxis({ low: bottom, high: top }, field.bottom, field.top);
    const part = (loops, style, open) =>
      loops.length
        ? svg('path', {
            class: style, d: loops.map((loop) => loopPath(region, loop, x.at, y.at, open)).join(''),
          })
        : null;
    const across = x.ticks(40), up = y.ticks(40);
    return svg(
      'svg',
      {
        class: 'plot', viewBox: `0 0 ${width} ${height}`, role: 'img',
        'aria-label': `Region of stability of ${region.solver}`,
      },
      part(region.loops, 'damped0'),
      ['0.75', '0.5', '0.25'].map((level, k) => part(region.others[level] || [], `damped${k + 1}`)),
      svg('path', {
        class: 'grid',
        d:
          across.map((v) => `M${x.at(v).toFixed(1)} ${field.top}V${field.bottom}`).join('') +
          up.map((v) => `M${field.left} ${y.at(v).toFixed(1)}H${field.right}`).join(''),
      }),
      ['1.25', '2'].map((level) => part(region.others[level] || [], 'growing', true)),
      part(region.loops, 'boundary', true),
      across.map((v) =>
        svg('text', { class: 'label middle', x: x.at(v), y: field.bottom + 11 }, number(v)),
      ),
      up.map((v) =>
        svg('text', { class: 'label end', x: field.left - 3, y: y.at(v) + 3 }, number(v)),
      ),
    );
  };

  blocks.region_pictures = async (host, spec) => {
    checkKeys(spec, 'region_pictures', ['plane']);
    const regions = [...(await loadRegions().catch(() => new Map())).values()].filter(
      (region) => region.plane === spec.plane,
    );
    if (!regions.length) return emptyText(host, spec);
    const seen = new IntersectionObserver(
      (entries) =>
        entries
          .filter((each) => each.isIntersecting)
          .forEach(({ target }) => {
            seen.unobserve(target);
            target.replaceChildren(regionPicture(target.region));
          }),
      { rootMargin: '300px' },
    );
    const figureOf = (region) => {
      const room = html('div', { class: 'room' });
      room.region = region;
      seen.observe(room);
      return html(
        'figure', { class: 'region' }, room,
        html(
          'figcaption', {},
          html(
            'a',
            {
              href: addressOf('regions', {
                plane: region.plane === 'lambda' ? '' : region.plane, show: region.solver,
              }),
            },
            region.solver.slice(region.solver.indexOf('/') + 1),
          ),
        ),
      );
    };
    const drawable = (region) =>
      region.loops.length || Object.values(region.others).some((loops) => loops.length);
    const shortName = (region) => region.solver.slice(region.solver.indexOf('/') + 1);
    const whyNot = (list) =>
      [
        ...d3.group(list, (region) => region.missing || 'no growth up to 2 a step in the picture'),
      ].map(([reason, some]) =>
        html('p', { class: 'missing' }, `${reason}: ${some.map(shortName).join(', ')}`),
      );
    [...d3.group(regions, (region) => region.solver.split('/')[0])].forEach(
      ([library, some], k) => {
        const drawn = some.filter(drawable), others = some.filter((region) => !drawable(region));
        host.append(
          lazyDetails(
            [
              html('strong', {}, library), ` ${versionOf(library)} `,
              html(
                'span', { class: 'dim' },
                plural(drawn.length, 'region') +
                  (others.length ? `, ${others.length} without a result` : ''),
              ),
            ],
            () => [html('div', { class: 'regions' }, drawn.map(figureOf)), ...whyNot(others)],
            k === 0,
          ),
        );
      },
    );
    return null;
  };
})();
