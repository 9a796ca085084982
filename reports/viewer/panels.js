// SPDX-License-Identifier: BSD-3-Clause
// The errors of one case, solver by solver: small charts of one size with the same axes.
'use strict';
(() => {
  const {
    facts, number, html, blocks, addressOf, rowsOf, plural, rangeOf, idOf, whenSeen, plot,
    legendOf, lazyDetails, versionOf,
  } = odeum;

  // The solvers of a library in groups that fit a chart: whole small families together, large ones
  // in parts.
  const most = 8;
  const panelsOf = (solvers) => {
    const panels = [];
    for (const [, members] of d3.groups(
      d3.sort(solvers, (s) => s.family, (s) => s.order ?? Infinity),
      (s) => s.family,
    )) {
      const parts = Math.ceil(members.length / most), before = panels.at(-1);
      if (parts === 1 && before?.whole && before.solvers.length + members.length <= most)
        before.solvers.push(...members);
      else
        for (let k = 0; k < parts; ++k)
          panels.push({
            whole: parts === 1,
            solvers: members.slice(
              Math.round((k * members.length) / parts),
              Math.round(((k + 1) * members.length) / parts),
            ),
          });
    }
    return panels;
  };
  const contentsOf = ({ solvers }) => {
    const orders = d3.sort(new Set(solvers.map((s) => s.order).filter((order) => order !== null))),
      varies = solvers.some((s) => s.order === null);
    const text =
      orders.length > 1
        ? `orders ${number(orders[0])} to ${number(orders.at(-1))}`
        : orders.length
          ? `order ${number(orders[0])}`
          : '';
    const families = solvers.map((s) => s.family.replaceAll('_', ' ').replace(/ rk$/, ' RK'));
    const all = [text, varies ? 'variable order' : ''].filter(Boolean).join(' and ');
    return `${[...new Set(families)].join(', ')}; ${all}`;
  };

  // A level near the bottom has its text below itself.
  const withRoom = (up, floor) =>
    floor > up.low && floor < up.high
      ? { ...up, low: Math.min(up.low, floor * (floor / up.high) ** 0.13) }
      : up;
  // A figure of each group of solvers with `charts`: [{title, x, label, slopes: with those of the
  // claimed orders, holds(row)}]; the axes are the same throughout. `y`: {column, label, most}.
  const showPanels = (host, c, rows, charts, y, floor) => {
    const drawn = rows.filter((row) => row[y.column] > 0 && row[y.column] <= y.most);
    if (!drawn.length)
      return host.append(
        html('p', { class: 'missing' }, 'Nothing to draw: no run of this case gave an error.'),
      );
    const up = withRoom(
        rangeOf(drawn.map((row) => row[y.column]), 3),
        floor,
      ),
      bySolver = d3.group(drawn, idOf),
      key = (s) => `${s.library}/${s.method}`;
    const across = new Map(
      d3
        .groups(charts, (chart) => chart.x)
        .map(([x, some]) => [
          x,
          rangeOf(
            drawn.filter((row) => some.some((chart) => chart.holds(row))).map((row) => row[x]), 1.3,
          ),
        ]),
    );
    const curvesOf = (panel, chart) =>
      panel.solvers.flatMap((solver, k) =>
        d3
          .groups(bySolver.get(key(solver)).filter(chart.holds), (row) => row.mode)
          .map(([mode, some]) => ({
            name: `${key(solver)}${mode === 'fixed' ? '' : ', to a tolerance'}`,
            colour: `var(--s${k})`, shape: k, dashed: mode !== 'fixed',
            points: some.map((run) => ({ x: run[chart.x], y: run[y.column], run })),
          })),
      );
    const tell = (chart) => (run, curve) =>
      [
        curve.name,
        run.mode === 'fixed' ? `step ${number(run.step)}` : `tolerance ${number(run.setting)}`,
        `${y.label}: ${number(run[y.column])}`,
        run.rhs_evaluations ? plural(run.rhs_evaluations, 'evaluation') : '',
      ].filter(Boolean);
    const pick = (panel, chart) => (run) => {
      location.hash = addressOf('compare', {
        case: c.id, x: chart.x === 'step' ? 'step' : 'evaluations',
        show: panel.solvers
          .filter((s) => bySolver.get(key(s)).some((row) => row.mode === run.mode))
          .map((s) => `${key(s)}:${run.mode}`)
          .join(','),
      });
    };
    const pictureOf = (panel, chart) => {
      const picture = html('div', { class: 'picture' }), curves = curvesOf(panel, chart),
        x = across.get(chart.x);
      if (!curves.length || !x) return null;
      whenSeen(picture, 230, () =>
        plot(picture, {
          height: 230, nameless: true,
          description: `${y.label} against ${chart.label}${chart.title ? `, ${chart.title}` : ''}`,
          x: { ...x, label: chart.label }, y: { ...up, label: y.label }, curves,
          slopes: chart.slopes
            ? d3.sort(
                new Set(panel.solvers.map((s) => Math.round(s.order)).filter((order) => order > 0)),
              )
            : [],
          levels: floor > 0 ? [{ y: floor, text: "the truth's own error", shaded: true }] : [],
          tell: tell(chart),
          pick: pick(panel, chart),
        }),
      );
      return html(
        'div', {}, chart.title ? html('span', { class: 'when' }, chart.title) : null, picture,
      );
    };
    const figureOf = (panel) =>
      html(
        'figure', { class: `panel${charts.length > 2 ? ' four' : ''}` },
        html('figcaption', {}, contentsOf(panel)),
        html('div', { class: 'plots' }, charts.map((chart) => pictureOf(panel, chart))),
        legendOf(
          panel.solvers.map((solver, k) => ({
            name: solver.method, colour: `var(--s${k})`, shape: k,
          })),
        ),
      );
    const libraries = d3.groups(
      facts.solvers.filter((s) => bySolver.has(key(s))), (s) => s.library,
    );
    libraries.forEach(([library, solvers], k) =>
      host.append(
        lazyDetails(
          [
            html('strong', {}, library), ` ${versionOf(library)} `,
            html('span', { class: 'dim' }, plural(solvers.length, 'solver')),
          ],
          () => html('div', { class: 'panels pairs' }, panelsOf(solvers).map(figureOf)),
          k === 0,
        ),
      ),
    );
    return null;
  };

  // Time is in seconds in mechanics; elsewhere in whatever unit the equation has.
  const stepLabel = (c) => `step h [${c.unit || 'unit of t'}]`;
  const isFixed = (row) => row.mode === 'fixed';

  // Errors of a case against step and cost. An error beyond a hundred times the initial state only
  // says that a run diverged.
  blocks.error_panels = async (host, spec, context) => {
    const c = facts.caseOf.get(context.caseId),
      rows = (await rowsOf('convergence', c.id)).objects();
    return showPanels(
      host, c, rows,
      [
        { x: 'step', label: stepLabel(c), slopes: true, holds: isFixed },
        {
          x: 'rhs_evaluations', label: 'evaluations of f', holds: (row) => row.rhs_evaluations > 0,
        },
      ],
      { column: 'error_rms', label: 'error (root mean square)', most: 100 * c.scale },
      c.floor,
    );
  };

  // Errors at each time of the reference against a fixed step: `quantity`, a column, and its
  // `label`.
  blocks.time_panels = async (host, spec, context) => {
    const c = facts.caseOf.get(context.caseId),
      rows = (await rowsOf('convergence_times', c.id)).objects().filter(isFixed);
    const stops = d3.sort(
      new Set(rows.filter((row) => row[spec.quantity] > 0).map((row) => row.time)),
    );
    return showPanels(
      host, c, rows,
      stops.map((time) => ({
        title: `t = ${number(time)} s`, x: 'step', label: 'step h [s]',
        holds: (row) => row.time === time,
      })),
      { column: spec.quantity, label: spec.label, most: 100 },
      0,
    );
  };
})();
