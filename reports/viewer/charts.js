// SPDX-License-Identifier: BSD-3-Clause
// The block `chart`: rows as points or curves.
//   x, y: expression (log) "label"   (log) and the label may be left out
//   by: template        a curve each, in colours of their own; `library`: in the libraries' colours
//   facet: template     a small chart each, all with the same axes
//   marks: points       points alone; `lines`: lines alone; default: both
//   join: sorted        points of a curve in the order of x; default: of the rows
//   reference: number "text"   a level across; diagonal: yes   the line y = x
//   slopes: 1, 2, 4     guides y ~ x^p
//   band: low, high
//   least: number  most: number   of y; what lies beyond is not drawn
//   tip: template       what a point tells; wide: yes   the whole width
'use strict';
(() => {
  const {
    Template, grouped, facts, colourOf, blocks, checkKeys, prepare, rangeOf, spanOf, emptyText,
    html, linkOf, plot, legendOf,
  } = odeum;

  const axisOf = (text) => {
    const found = /^(.*?)\s*(\(log\))?\s*(?:"([^"]*)")?$/.exec(text || '');
    return {
      template: new Template(found[1]), log: Boolean(found[2]), label: found[3] ?? found[1],
    };
  };
  const numbersOf = (text) => (text ? text.split(',').map(Number) : []);

  const curvesOf = (indices, bound, spec, names) => {
    const [x, y, by, , tip] = bound;
    return [...grouped(indices, by ? by.text : () => '')]
      .map(([name, members]) => {
        const points = members
          .map((i) => ({
            x: x.value(i, [i]), y: y.value(i, [i]), run: { i, tip: tip ? tip.text(i, [i]) : '' },
          }))
          .filter(
            (p) =>
              Number.isFinite(p.x) && Number.isFinite(p.y) && !(p.y < Number(spec.least)) &&
              !(p.y > Number(spec.most)),
          );
        const k = names.indexOf(name);
        return {
          name,
          colour: facts.libraryNames.includes(name)
            ? colourOf(name)
            : name
              ? `var(--s${k % 8})`
              : 'var(--s0)',
          shape: Math.max(0, k) % 8,
          points: spec.join === 'sorted' ? d3.sort(points, (p) => p.x) : points,
          loose: spec.marks === 'points',
          bare: spec.marks === 'lines',
        };
      })
      .filter((curve) => curve.points.length);
  };

  blocks.chart = async (host, spec, context) => {
    checkKeys(spec, 'chart', [
      'x', 'y', 'by', 'facet', 'marks', 'join', 'reference', 'diagonal', 'slopes', 'band', 'least',
      'most', 'tip', 'wide', 'height',
    ]);
    const x = axisOf(spec.x), y = axisOf(spec.y);
    const templates = [
      x.template, y.template,
      ...['by', 'facet', 'tip'].map((key) => (spec[key] ? new Template(spec[key]) : null)),
    ];
    const { indices, bound } = await prepare(spec, context, templates);
    const names = bound[2] ? [...grouped(indices, bound[2].text).keys()] : [];
    const facets = bound[3] ? [...grouped(indices, bound[3].text)] : [['', indices]];
    const charts = facets
      .map(([name, members]) => ({ name, curves: curvesOf(members, bound, spec, names) }))
      .filter(({ curves }) => curves.length);
    const points = charts.flatMap(({ curves }) => curves.flatMap((curve) => curve.points));
    const [, level, levelText] = /^([-+0-9.e]+)\s*(?:"([^"]*)")?$/.exec(spec.reference || '') || [];
    const range = (axis, values) => (axis.log ? rangeOf(values, 1.4) : spanOf(values));
    const across = range(
        x, points.map((p) => p.x),
      ),
      up = range(y, [...points.map((p) => p.y), ...(level ? [Number(level)] : [])]);
    if (!across || !up) return emptyText(host, spec);
    const [low, high] = numbersOf(spec.band);
    const grid = html('div', {
      class: facets.length > 1 ? 'panels' : `single${spec.wide === 'yes' ? ' whole' : ''}`,
    });
    host.append(grid);
    for (const { name, curves } of charts) {
      const picture = html('div', { class: 'picture' });
      grid.append(
        html(
          'figure', {},
          name || spec.title
            ? html('figcaption', {}, linkOf(spec.facet || '', name || spec.title))
            : null,
          picture,
        ),
      );
      plot(picture, {
        height: Number(spec.height) || (facets.length > 1 ? 230 : 380),
        description: `${y.label} against ${x.label}${name ? `, ${name}` : ''}`,
        nameless: facets.length > 1, x: { ...across, label: x.label }, y: { ...up, label: y.label },
        curves: names.length ? curves : curves.map((curve) => ({ ...curve, name: '' })),
        levels: level ? [{ y: Number(level), text: levelText || '' }] : [],
        bands: low !== undefined ? [{ low, high }] : [], slopes: numbersOf(spec.slopes),
        diagonal: spec.diagonal === 'yes',
        tell: (run, curve) =>
          [
            run.tip || curve?.name || '', `${x.label}: ${bound[0].text(run.i, [run.i])}`,
            `${y.label}: ${bound[1].text(run.i, [run.i])}`,
          ].filter(Boolean),
      });
    }
    if (facets.length > 1 && names.length)
      host.append(legendOf(d3.greatest(charts, ({ curves }) => curves.length).curves));
    return null;
  };

  // Draws in `host` once it comes near the window: a page may have hundreds of charts.
  const whenSeen = (host, height, draw) => {
    host.style.minHeight = `${height}px`;
    const observer = new IntersectionObserver(
      (seen) => {
        if (seen.some((each) => each.isIntersecting)) {
          observer.disconnect();
          host.style.minHeight = '';
          draw();
        }
      },
      { rootMargin: '400px' },
    );
    observer.observe(host);
  };

  Object.assign(odeum, { axisOf, whenSeen });
})();
