// SPDX-License-Identifier: BSD-3-Clause
// The page of one problem, as odeum run, classify and poisson write it with --out
// (src/odeum/trajectories/run_page.hpp): of runs what ran, how it ended, the solutions over time
// and in the state plane, errors, energy, steps, and replays in step; see also fields.js.
'use strict';
(() => {
  const {
    html, svg, spanOf, rangeOf, plot, number, legendOf, save, idOf, rowsOf, facts, runTable,
    remarksOf, replaysInStep,
  } = odeum;

  const mostComponents = 6;

  // A figure with a title and a picture, which can be saved.
  const figureOf = (host, title) => {
    const picture = html('div', { class: 'picture' }),
      name = title.toLowerCase().replace(/[^a-z0-9]+/g, '_');
    host.append(
      html(
        'figure', { 'data-figure': name },
        html(
          'figcaption', {}, html('strong', {}, title), ' ',
          html(
            'button',
            { type: 'button', class: 'download', onclick: () => saveSvg(picture, `${name}.svg`) },
            'save as SVG',
          ),
        ),
        picture,
      ),
    );
    return picture;
  };
  // A figure of curves {name, key, points, exact, dashed}: the exact solution wide and pale,
  // solvers in colours of their own. `bare` curves are drawn as marks.
  const runFigure = (host, title, axes, curves, spec = {}) => {
    const drawn = curves
      .map((curve) => ({
        ...curve,
        points: curve.points.filter(
          (p) => Number.isFinite(p.x) && Number.isFinite(p.y) && (!axes.y.log || p.y > 0),
        ),
      }))
      .filter((curve) => curve.points.length);
    const points = drawn.flatMap((curve) => curve.points);
    const x = spanOf(points.map((p) => p.x)),
      y = axes.y.log
        ? rangeOf(
            points.map((p) => p.y), 1.5,
          )
        : axes.y.range
          ? { low: axes.y.range[0], high: axes.y.range[1] }
          : spanOf(points.map((p) => p.y));
    if (!x || !y) return;
    const picture = figureOf(host, title);
    plot(picture, {
      height: 300, description: title, x: { ...x, label: axes.x.label },
      y: { ...y, label: axes.y.label, log: axes.y.log }, nameless: true,
      tell: (run, curve) => [
        curve.name, `${axes.x.label || 'x'}: ${number(run.x, 6)}`,
        `${axes.y.label || 'y'}: ${number(run.y, 6)}`,
      ],
      curves: drawn.map((curve) => ({
        ...curve, points: curve.points.map((p) => ({ ...p, run: p })),
        colour: curve.exact ? 'var(--dim)' : `var(--s${curve.key % 8})`,
        shape: curve.exact ? 0 : curve.key % 8, wide: curve.exact && !curve.loose,
        bare: !curve.loose && (curve.exact || curve.points.length > 30), stairs: spec.stairs,
      })),
    });
    host.lastChild.append(
      legendOf(
        drawn.map((curve) => ({
          name: curve.name, colour: curve.exact ? 'var(--dim)' : `var(--s${curve.key % 8})`,
          shape: curve.exact ? 0 : curve.key % 8, dashed: curve.dashed, bare: !curve.loose,
        })),
      ),
    );
  };

  // The picture as a file that stands alone: colours that the style sheet gives are written into
  // it.
  const saveSvg = (picture, name) => {
    const shown = picture.querySelector('svg'), copy = shown.cloneNode(true);
    copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
    const from = [shown, ...shown.querySelectorAll('*')],
      to = [copy, ...copy.querySelectorAll('*')];
    from.forEach((element, i) => {
      const style = getComputedStyle(element);
      for (const key of [
        'fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity', 'fill-opacity',
        'opacity', 'text-anchor', 'font-size', 'font-family', 'visibility',
      ])
        to[i].style.setProperty(key, style.getPropertyValue(key));
    });
    save(name, new XMLSerializer().serializeToString(copy), 'image/svg+xml');
  };

  // Rows by solver, in the order of the runs; the exact solution's, if any, first.
  const bySolver = (rows, runs) => {
    const all = rows.objects(), groups = [];
    const exact = all.filter((row) => row.library === 'truth');
    if (exact.length > 1) groups.push({ name: 'exact', key: -1, exact: true, rows: exact });
    runs.forEach((run, key) => {
      const own = all.filter((row) => row.library === run.library && row.solver === run.solver);
      if (own.length) groups.push({ name: idOf(run), key, rows: own });
    });
    return groups;
  };

  // The length of the steps by what bounds them: strips of a colour each behind it.
  const boundsFigure = (host, every) => {
    const segments = every.filter((segment) => segment.step > 0);
    if (!segments.length) return;
    const causes = [...new Set(segments.map((segment) => segment.bound_by))],
      colour = (cause) => `var(--s${causes.indexOf(cause) % 8})`,
      steps = segments.map((segment) => segment.step);
    const picture = figureOf(host, 'What bounds the steps');
    const { x, y } = plot(picture, {
      height: 240, description: 'What bounds the steps', nameless: true,
      x: { ...spanOf(segments.flatMap(({ from, to }) => [from, to])), label: 'time' },
      y: { ...rangeOf(steps, 3), label: 'step', log: true }, curves: [],
    });
    const shown = picture.querySelector('svg'), { height } = shown.viewBox.baseVal;
    for (const segment of segments) {
      const from = x.at(segment.from), to = x.at(segment.to), at = y.at(segment.step);
      const count = number(segment.steps, 4), text =
        `${segment.bound_by}: ${count} steps of about ${number(segment.step, 3)}`;
      const place = { x: from, width: Math.max(1, to - from), y: 10, height: height - 52 },
        fill = { fill: colour(segment.bound_by), 'fill-opacity': 0.25 };
      shown.append(
        svg('rect', { class: 'bound', ...place, ...fill }, svg('title', {}, text)),
        svg('path', { class: 'curve', d: `M${from} ${at}H${to}`, style: { color: fill.fill } }),
      );
    }
    host.lastChild.append(legendOf(causes.map((name) => ({ name, colour: colour(name) }))));
  };

  const caseFigures = async (host, about, runs) => {
    const [trajectory, steps, schemes, bounds, curves] = await Promise.all(
      ['trajectory', 'steps', 'schemes', 'why', 'curves'].map((name) => rowsOf(name)),
    );
    // Outputs step over what is fast; the ends of steps do not.
    const between = new Map(bySolver(curves, runs).map(({ key, rows }) => [key, rows]));
    const groups = bySolver(trajectory, runs).map((group) => ({
      ...group, loose: group.exact && !about.exact_everywhere,
      rows: d3.sort([...group.rows, ...(between.get(group.key) || [])], (row) => row.time),
    }));
    const closed = bySolver(schemes, runs).map((group) => ({
      ...group, name: `${group.name}, its own closed form`, dashed: true,
    }));
    const names = about.components, n = names.length,
      plotted = (x, y) =>
        [...groups, ...closed].map((group) => ({
          ...group, points: group.rows.map((row) => ({ x: x(row), y: y(row) })),
        }));
    const of = (name) => (row) => row[name], time = of('time');
    if (n > 1 && n <= 4 && runs.length === 1 && !about.second_order)
      runFigure(
        host, 'Components over time', { x: { label: 'time' }, y: { label: '' } },
        names.map((name, key) => ({
          name, key,
          points: (groups.find((group) => !group.exact)?.rows || []).map((row) => ({
            x: row.time, y: row[name],
          })),
        })),
      );
    for (const i of about.measured.slice(0, mostComponents))
      runFigure(
        host, `${names[i]} over time`, { x: { label: 'time' }, y: { label: names[i] } },
        plotted(time, of(names[i])),
      );
    boundsFigure(host, bounds.objects());
    const plane = (i, j, title) =>
      runFigure(
        host, `${title}: ${names[j]} against ${names[i]}`,
        { x: { label: names[i] }, y: { label: names[j] } }, plotted(of(names[i]), of(names[j])),
      );
    if (about.second_order)
      for (let i = 0; i < Math.min(n / 2, 2); ++i) plane(i, n / 2 + i, 'State plane');
    else if (n > 1) plane(0, 1, 'State plane');
    if (about.second_order && n >= 4) plane(0, 1, 'Path');
    runFigure(
      host, 'Largest error over time', { x: { label: 'time' }, y: { label: 'error', log: true } },
      groups
        .filter((group) => !group.exact)
        .map((group) => ({
          ...group, loose: !about.exact_everywhere,
          points: group.rows.map((row) => ({ x: row.time, y: row.error })),
        })),
    );
    if (about.energy) {
      const start = groups.find((group) => !group.exact)?.rows[0]?.energy;
      runFigure(
        host, 'Energy, less that at the start', { x: { label: 'time' }, y: { label: 'energy' } },
        groups.map((group) => ({
          ...group, points: group.rows.map((row) => ({ x: row.time, y: row.energy - start })),
        })),
      );
    }
    runFigure(
      host, 'Steps taken over time', { x: { label: 'time' }, y: { label: 'step', log: true } },
      bySolver(steps, runs).map((group) => ({
        ...group,
        points: group.rows.flatMap((row) => [
          { x: row.time - row.step, y: row.step }, { x: row.time, y: row.step },
        ]),
      })),
    );
  };

  const sceneFigures = async (host, about, runs) => {
    const [plotted, energies] = await Promise.all(
      ['plotted', 'energies'].map((name) => rowsOf(name)),
    );
    if (about.plot) {
      const { particle, coordinate, range } = about.plot, groups = bySolver(plotted, runs),
        curves = (x, y) =>
          groups.map((group) => ({
            ...group, points: group.rows.map((row) => ({ x: row[x], y: row[y] })),
          }));
      runFigure(
        host, `${coordinate} of particle ${particle} over time`,
        { x: { label: 'time (s)' }, y: { label: `${coordinate} (m)`, range } },
        curves('time', 'position'),
      );
      runFigure(
        host, `State plane of ${coordinate} of particle ${particle}`,
        { x: { label: `${coordinate} (m)` }, y: { label: `v${coordinate} (m/s)` } },
        curves('position', 'velocity'),
      );
    }
    const groups = bySolver(energies, runs), start = groups[0]?.rows[0]?.total;
    runFigure(
      host, 'Energy, less that at the start',
      { x: { label: 'time (s)' }, y: { label: 'energy (J)' } },
      groups.map((group) => ({
        ...group, points: group.rows.map((row) => ({ x: row.time, y: row.total - start })),
      })),
    );
  };

  // The fields for each kind of page; fields.js has more.
  const pageFigures = { case: caseFigures, scene: sceneFigures };
  const showRuns = async (host) => {
    const about = facts.runs, runs = (await rowsOf('runs')).objects();
    document.title = `${about.title} – Odeum`;
    host.append(
      html('h1', {}, about.title),
      about.lead ? html('p', { class: 'lead' }, html('code', {}, about.lead)) : '',
      html(
        'dl', { class: 'facts' },
        about.facts.map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
      ),
    );
    if (runs.length)
      host.append(
        runTable(about, runs),
        ...(about.unit ? [html('p', { class: 'unit' }, `Errors are ${about.unit}.`)] : []),
        ...remarksOf(runs),
      );
    const figures = html('div', { class: 'figures' });
    host.append(figures);
    await pageFigures[about.kind](figures, about, runs);
    const replays = runs
      .filter((run) => run.replay)
      .map((run) => ({ name: idOf(run), address: run.replay }));
    if (replays.length) replaysInStep(host, replays);
  };

  Object.assign(odeum, { figureOf, pageFigures, showRuns });
})();
