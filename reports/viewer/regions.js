// SPDX-License-Identifier: BSD-3-Clause
// Regions of stability laid over each other, with the eigenvalues of a problem times the step.
'use strict';
(() => {
  const {
    shorten, spread, svg, colourOf, makeAxis, isInside, drawAxes, html, limitNumber, number,
    loadRegions, facts, fastestEigenvalue, writeAddress, showAgain, plural, choices, select, wide,
  } = odeum;

  const regionPath = (region, x, y) =>
    region.loops
      .map((loop) => {
        let d = '';
        for (let i = 0; i < loop.length; i += 2)
          d += `${i ? 'L' : 'M'}${x.at(loop[i]).toFixed(1)} ${y.at(loop[i + 1]).toFixed(1)}`;
        return `${d}Z`;
      })
      .join('');

  // The name, without its library (which the colour tells) where there is little room.
  const named = (id, most) => (id.length <= most ? id : shorten(id.split('/')[1], most));
  // Names to the right of the regions, each with a line to the highest point of its own.
  const regionNames = (shown, x, y, size) => {
    const tops = shown.map((region) => {
      const loop = region.loops.reduce((a, b) => (b.length > a.length ? b : a));
      let best = 0;
      for (let i = 0; i < loop.length; i += 2) if (loop[i + 1] > loop[best + 1]) best = i;
      return [x.at(loop[best]), y.at(loop[best + 1])];
    });
    const left = Math.max(
      x.at(0) + 24, size.right - 7 * Math.max(...shown.map((r) => r.solver.length)) - 6,
    );
    const places = spread(tops.map(([, top]) => top), 14, size.top + 8, size.bottom - 8);
    return shown.map((region, i) =>
      svg(
        'g', { style: { color: colourOf(region.solver.split('/')[0]) } },
        svg('path', {
          class: 'leader',
          d:
            `M${tops[i][0].toFixed(1)} ${tops[i][1].toFixed(1)}L${left - 3} ` +
            `${places[i].toFixed(1)}`,
        }),
        svg(
          'text', { class: 'name', x: left, y: places[i] + 4 },
          named(region.solver, Math.floor((size.right + 10 - left) / 7)),
        ),
      ),
    );
  };

  const drawRegions = (host, shown, plane, c, h) => {
    const box = shown.reduce(
      (all, r) => [
        Math.min(all[0], r.box[0]), Math.max(all[1], r.box[1]), Math.min(all[2], r.box[2]),
        Math.max(all[3], r.box[3]),
      ],
      shown[0].box,
    );
    // In the plane of z a circle is to look like one.
    const width = Math.max(280, host.clientWidth || 640),
      field = Math.min(
        width - 58, plane === 'lambda' ? (480 * (box[1] - box[0])) / (box[3] - box[2]) : width,
      );
    const tall = plane === 'lambda' ? (field * (box[3] - box[2])) / (box[1] - box[0]) : 0.6 * field,
      height = tall + 52;
    const size = { left: 46, right: 46 + field, top: 10, bottom: 10 + tall };
    const words =
      plane === 'lambda' ? ['real part of z = λh', 'imaginary part'] : ['ω h', 'damping ratio ζ'];
    const x = makeAxis({ low: box[0], high: box[1] }, size.left, size.right),
      y = makeAxis({ low: box[2], high: box[3] }, size.bottom, size.top);
    const dots = (c ? c.eigenvalues : []).flatMap((z) =>
      plane === 'lambda'
        ? [
            [z[0] * h, z[1] * h], [z[0] * h, -z[1] * h],
          ]
        : z[1] || z[0] < 0
          ? [[Math.hypot(...z) * h, -z[0] / Math.hypot(...z)]]
          : [],
    );
    const outside = dots.filter(
      ([px, py]) =>
        !shown.every(
          (r) =>
            (plane === 'lambda' ? Math.hypot(px, py) : px) < r.cell ||
            isInside(r, Math.min(px, -1e-6 * (plane === 'lambda')) || px, py || 1e-6),
        ),
    );
    const beyond = dots.filter(([px, py]) => !x.holds(px) || !y.holds(py)).length;
    const marks = dots
      .filter(([px, py]) => x.holds(px) && y.holds(py))
      .map((dot) =>
        svg('circle', {
          class: outside.includes(dot) ? 'eigenvalue out' : 'eigenvalue', cx: x.at(dot[0]),
          cy: y.at(dot[1]), r: 4,
        }),
      );
    host.replaceChildren(
      svg(
        'svg',
        {
          class: 'plot live', width, height, viewBox: `0 0 ${width} ${height}`, role: 'img',
          'aria-label':
            `Outlines of the regions of stability of ` + `${shown.map((r) => r.solver).join(', ')}`,
        },
        drawAxes(size, x, y, { x: { label: words[0] }, y: { label: words[1] } }),
        plane === 'lambda'
          ? svg('path', {
              class: 'guide',
              d: `M${x.at(0)} ${size.top}V${size.bottom}M${size.left} ${y.at(0)}H${size.right}`,
            })
          : null,
        shown.map((region, i) =>
          svg(
            'g', { style: { color: colourOf(region.solver.split('/')[0]) } },
            svg('path', {
              class: 'region-line',
              'stroke-dasharray': ['', '6 3', '2 3', '9 3 2 3'][i % 4] || null,
              'fill-rule': 'evenodd', d: regionPath(region, x, y),
            }),
          ),
        ),
        regionNames(shown, x, y, size),
        marks,
      ),
    );
    return { outside: outside.length, beyond };
  };

  const regionTable = (shown) =>
    html(
      'table', { class: 'numbers' },
      html(
        'thead', {},
        html(
          'tr', {},
          ['solver', 'line', 'real axis to', 'imaginary axis to', 'oscillator, ωh to'].map((t) =>
            html('th', {}, t),
          ),
        ),
      ),
      html(
        'tbody', {},
        shown.map((r, i) =>
          html(
            'tr', {}, html('th', { scope: 'row' }, r.solver),
            html(
              'td', {},
              svg(
                'svg',
                {
                  viewBox: '0 0 40 8', width: 40, height: 8, 'aria-hidden': 'true',
                  style: { color: colourOf(r.solver.split('/')[0]) },
                },
                svg('path', {
                  class: 'region-line',
                  'stroke-dasharray': ['', '6 3', '2 3', '9 3 2 3'][i % 4] || null, d: 'M0 4H40',
                }),
              ),
            ),
            ['real', 'imaginary', 'oscillator'].map((axis) =>
              html(
                'td', {},
                limitNumber(r.solver, axis) === undefined
                  ? '–'
                  : number(limitNumber(r.solver, axis), 6),
              ),
            ),
          ),
        ),
      ),
    );

  const firstRegions = [
    'odeum/explicit_euler', 'odeum/rk4', 'odeum/dormand_prince54', 'odeum/verner98',
    'odeum/adams_bashforth4',
  ];
  const showRegions = async (host, given) => {
    const regions = await loadRegions().catch(() => null);
    if (!regions)
      return host.replaceChildren(
        html(
          'p', { class: 'missing' },
          'Regions of stability were not measured in this report: odeum stability measures them ' +
            'into its folder.',
        ),
      );
    const plane = given.plane === 'oscillator' ? 'oscillator' : 'lambda';
    const available = [...regions.values()]
      .filter((r) => r.plane === plane && r.loops.length)
      .map((r) => r.solver);
    const first =
      plane === 'lambda'
        ? firstRegions.filter((id) => available.includes(id))
        : ['odeum/velocity_verlet', 'odeum/symplectic_euler', 'bullet/rigid_body'].filter((id) =>
            available.includes(id),
          );
    const names = (
      given.show === undefined
        ? first.length
          ? first
          : available.slice(0, 3)
        : given.show.split(',')
    ).filter((id) => available.includes(id));
    const c =
        facts.caseOf.get(given.case) || facts.caseOf.get(facts.questions[0]?.case) ||
        facts.cases[0],
      z = c && fastestEigenvalue(c);
    const exponent =
      Number.isFinite(Number(given.h)) && given.h
        ? Math.log10(Number(given.h))
        : z
          ? Math.log10(1 / Math.hypot(...z))
          : 0;
    const turn = (change) => {
      const next = { plane, case: c?.id, show: names.join(','), ...change };
      writeAddress('regions', next);
      return showAgain(host, () => showRegions(host, next));
    };
    const shown = names.map((id) => regions.get(`${id}:${plane}`)),
      picture = html('div', { class: 'picture' }),
      text = html('p', { 'aria-live': 'polite' });
    const draw = (h) => {
      if (!shown.length)
        return picture.replaceChildren(html('p', { class: 'missing' }, 'Choose a solver.'));
      const { outside, beyond } = drawRegions(picture, shown, plane, c, h);
      const inside = outside
        ? `${plural(outside, 'eigenvalue')} of ${c.title} outside of at least one region (red)`
        : 'every eigenvalue inside of every region';
      const rest = beyond ? `; ${beyond} beyond the picture` : '';
      text.textContent = `h = ${number(h)}${c?.unit ? ` ${c.unit}` : ''}: ${inside}${rest}.`;
      return null;
    };
    const low = z ? Math.log10(0.01 / Math.hypot(...z)) : -4, high = low + 4;
    const slider = html('input', {
      type: 'range', min: low, max: high, step: 0.01,
      value: Math.min(high, Math.max(low, exponent)), 'aria-label': 'step h',
      oninput: (event) => draw(10 ** event.target.value),
      onchange: (event) =>
        writeAddress('regions', {
          plane, case: c?.id, show: names.join(','), h: number(10 ** event.target.value),
        }),
    });
    host.replaceChildren(
      html(
        'div', { class: 'controls' },
        choices(
          'plane',
          [['lambda', 'λh', "y' = λ y"], ['oscillator', 'ωh, ζ', "q'' = -2ζω q' - ω² q"]],
          plane,
          (next) => turn({ plane: next, show: undefined }),
        ),
        select(
          'eigenvalues of',
          facts.cases.map((each) => [
            each.id, each.title + (each.eigenvalues.length ? '' : ' (none)'),
          ]),
          c?.id,
          (id) => turn({ case: id }),
        ),
        html('label', { class: 'field wide-field' }, 'step h ', slider),
        select(
          'add',
          [['', '…'], ...available.filter((id) => !names.includes(id)).map((id) => [id, id])], '',
          (id) => turn({ show: [...names, id].join(',') }),
        ),
      ),
      html(
        'div', { class: 'chips', role: 'group', 'aria-label': 'regions shown' },
        names.map((id) =>
          html(
            'button',
            {
              type: 'button', class: 'chip-button', style: { '--lib': colourOf(id.split('/')[0]) },
              'aria-label': `remove ${id}`,
              onclick: () => turn({ show: names.filter((n) => n !== id).join(',') }),
            },
            id,
            ' ×',
          ),
        ),
      ),
      text,
      html(
        'div', { class: 'columns wide-left' }, picture,
        wide('limits of stability', regionTable(shown)),
      ),
    );
    return draw(10 ** slider.value);
  };

  Object.assign(odeum, { showRegions });
})();
