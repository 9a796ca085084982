// SPDX-License-Identifier: BSD-3-Clause
// What the pages of orders show beside tables: the cases at a glance, and the errors of one case,
// solver by solver.
'use strict';
(() => {
  const {
    functions, facts, fastestEigenvalue, limitNumber, number, html, sum, blocks, prepare, addressOf,
    rowsOf, solverGroups, tableOf, plural, rangeOf, idOf, whenSeen, plot, legendOf, lazyDetails,
    versionOf,
  } = odeum;

  // The best first; signs tell verdicts apart without colour.
  const verdicts = {
    confirmed: ['✓', 'the claimed order lies within the tolerance of the slope'],
    higher: ['▲', 'errors fall faster than claimed'],
    lower: ['▼', 'errors fall more slowly than claimed'],
    floors: ['⊥', 'errors stop falling at a level, which the tables name'],
    undetermined: ['?', 'there are too few points, or no settled slope'],
    unstable: ['↯', 'no step that was tried is stable for the solver: no word on its answers'],
    failed: ['✗', 'no run gave a result'],
    not_applicable: ['·', 'the solver does not fit the case, or there is no claim'],
  };
  const judged = Object.keys(verdicts).filter((verdict) => verdict !== 'not_applicable');
  functions.verdict_sign = (verdict) => verdicts[verdict]?.[0] ?? '';
  // What a reader sees of a verdict: that no step was stable is no failure of the code.
  functions.verdict_kind = (verdict, why) =>
    verdict === 'failed' && why === 'unstable' ? 'unstable' : verdict;
  // The step below which a solver is stable on a case, by its limit on the real axis and the
  // fastest eigenvalue along the solution, where that is real.
  functions.needed_step = (id, library, solver) => {
    const c = facts.caseOf.get(id), z = c && fastestEigenvalue(c),
      limit = limitNumber(`${library}/${solver}`, 'real');
    if (!z || z[1] || !(limit > 0) || !Number.isFinite(limit)) return '';
    const step = limit / -z[0];
    return (
      ` It takes h < ${number(step, 2)}, ${number((c.end - c.start) / step, 2)} steps to ` +
      `t = ${number(c.end)}: ${number(limit)} / |λ|, λ = ${number(z[0], 2)} at ` +
      `t = ${number(c.eigenvalues_time)}.`
    );
  };
  functions.verdict_place = (verdict) => Object.keys(verdicts).indexOf(verdict);
  functions.class_name = (why) => facts.order_classes?.[why]?.name ?? why;
  functions.class_settles = (why) => facts.order_classes?.[why]?.settles ?? '';

  // `counts`: how many by verdict.
  const barOf = (counts) =>
    html(
      'span', { class: 'bar', 'aria-hidden': 'true' },
      judged
        .filter((verdict) => counts[verdict])
        .map((verdict) => html('i', { class: verdict, style: { 'flex-grow': counts[verdict] } })),
    );
  const wordsOf = (counts) =>
    judged
      .filter((verdict) => counts[verdict])
      .map((verdict) => `${counts[verdict]} ${verdict}`)
      .join(', ') || 'not run';
  const total = (counts) => sum(judged.map((verdict) => counts[verdict] || 0));

  blocks.verdict_key = (host) =>
    host.append(
      html(
        'ul', { class: 'key' },
        Object.entries(verdicts).map(([verdict, [sign, meaning]]) =>
          html(
            'li', {},
            html('span', { class: `chip ${verdict}` }, `${sign} ${verdict.replace('_', ' ')}`),
            ` ${meaning}`,
          ),
        ),
      ),
    );

  // The verdicts of a case as a bar and in words, and why there is no order, the most frequent
  // reason first.
  blocks.case_verdicts = async (host, spec, context) => {
    const { rows, indices } = await prepare(spec, context, []);
    if (!indices.length) return;
    const [verdicts, reasons] = ['verdict', 'no_order'].map((name) => rows.column(name));
    const count = (key) => d3.rollup(indices, (some) => some.length, key);
    const verdict = count((i) => functions.verdict_kind(verdicts[i], reasons[i])),
      why = count((i) => reasons[i]);
    const counts = Object.fromEntries(verdict);
    why.delete('');
    const lines = [
      ['Orders', [barOf(counts), ' ', wordsOf(counts)]],
      [
        'Without an order',
        d3
          .sort(why, ([, n]) => -n)
          .map(([name, n]) => `${n} ${functions.class_name(name)}`)
          .join(', '),
      ],
    ];
    host.append(
      html(
        'dl', { class: 'facts' },
        lines
          .filter(([, text]) => text.length)
          .map(([name, text]) => [html('dt', {}, name), html('dd', {}, text)]),
      ),
    );
  };

  const cellOf = (counts, title) => {
    const all = total(counts), good = (counts.confirmed || 0) + (counts.higher || 0);
    return all
      ? {
          text: `${good}/${all}`, node: [barOf(counts), html('b', {}, String(good)), `/${all}`],
          value: good / all, title: `${title}: ${wordsOf(counts)}`,
        }
      : {
          text: '·', value: NaN, class: 'zero',
          title: `${title}: ${counts.not_applicable ? 'does not apply' : 'not tried'}`,
        };
  };
  const caseLink = (c, text, part) =>
    html('a', { href: addressOf('case', { id: c.id, part }) }, text || c.id);
  const listed = (links) => links.flatMap((link, k) => (k ? [', ', link] : [link]));

  // Every case against the groups of solvers.
  blocks.case_overview = async (host) => {
    const rows = await rowsOf('orders'),
      [ids, libraries, solvers, given, why] = [
        'case', 'library', 'solver', 'verdict', 'no_order',
      ].map((name) => rows.column(name));
    const groups = solverGroups(),
      tally = d3.rollup(
        rows.indices(null),
        (some) =>
          Object.fromEntries(
            d3.rollup(some, (list) => list.length, (i) => functions.verdict_kind(given[i], why[i])),
          ),
        (i) => ids[i],
        (i) => functions.solver_group(libraries[i], solvers[i]),
      );
    const countsOf = (id, name) => tally.get(id)?.get(name) || {};
    const measured = facts.cases.filter((c) => tally.has(c.id)),
      cloths = measured.filter((c) => c.tags.includes('cloth'));
    const all = (name) =>
      Object.fromEntries(
        Object.keys(verdicts).map((verdict) => [
          verdict, sum(measured.map((c) => countsOf(c.id, name)[verdict] || 0)),
        ]),
      );
    const own = groups.filter((group) => group.own).length;
    const kinds = html(
      'tr', {}, html('td', {}), own ? html('th', { colspan: own }, 'Odeum, by family') : null,
      own < groups.length
        ? html('th', { colspan: groups.length - own }, 'peers, by library')
        : null,
    );
    const lines = [
      {
        class: 'all',
        cells: [
          { text: 'all cases' }, ...groups.map((group) => cellOf(all(group.name), group.title)),
        ],
      },
      ...measured.map((c) => ({
        cells: [
          { text: `${c.id} ${c.title}`, node: [caseLink(c), html('span', {}, c.title)] },
          ...groups.map((group) => cellOf(countsOf(c.id, group.name), group.title)),
        ],
      })),
    ];
    host.append(
      tableOf(
        [
          { text: 'case' },
          ...groups.map((group) => ({
            text: group.title, title: plural(group.ids.length, 'solver'),
          })),
        ],
        lines,
        'overview',
        kinds,
      ),
    );
    if (cloths.length)
      host.append(
        html(
          'p', {}, 'The pages of the cloths also show errors and energy over time: ',
          listed(cloths.map((c) => caseLink(c))), '.',
        ),
      );
  };
  blocks.cases_left_out = async (host) => {
    const ids = new Set((await rowsOf('orders')).column('case')),
      others = facts.cases.filter((c) => !ids.has(c.id));
    if (others.length)
      host.append(
        html(
          'p', { class: 'dim' }, 'Without orders in this report: ',
          listed(others.map((c) => caseLink(c))), '.',
        ),
      );
  };

  blocks.not_built = (host) => {
    const missing = facts.libraries.filter((each) => !each.built);
    if (missing.length)
      host.append(
        html(
          'p', {}, 'These libraries are not built in: ',
          listed(
            missing.map((each) =>
              html(
                'span', {}, html('strong', {}, each.name), ' (option ',
                html('code', {}, each.option), ')',
              ),
            ),
          ),
          '.',
        ),
      );
  };

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
        run.mode === 'fixed' ? `step ${number(run.step)}` : `tolerance ${number(run.tolerance)}`,
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
