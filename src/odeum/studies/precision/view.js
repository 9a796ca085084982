// SPDX-License-Identifier: BSD-3-Clause
// Error against time with the Pareto fronts, and how disturbed the machine was while a case was
// timed.
'use strict';
(() => {
  const {
    functions, facts, blocks, rowsOf, formatted, legendOf, colourOf, idOf, number, duration, plural,
    addressOf, rangeOf, plot, checkKeys, html, whenSeen, frontOf,
  } = odeum;

  functions.loaded_libraries = () => (facts.run.loaded || []).join(', ');
  functions.case_end = (id) => facts.caseOf.get(id)?.end ?? NaN;

  const conditions = new Map();
  functions.conditions = (id) => conditions.get(id) ?? 'nothing was timed';

  // A matrix of precision_summary that may call conditions(case).
  blocks.ratios = async (host, spec, context) => {
    const rows = await rowsOf('precision'),
      [ids, drifts, shares] = ['case', 'drift', 'processor_share'].map((name) => rows.column(name));
    for (const i of rows.indices((k) => !Number.isNaN(drifts[k])))
      if (!conditions.has(ids[i]))
        conditions.set(
          ids[i],
          `${functions.disturbed(drifts[i], shares[i]) ? '⚠ disturbed: ' : ''}drift ` +
            `${formatted(drifts[i], '+.1%')}, processor ${formatted(shares[i], '.0%')}`,
        );
    return blocks.matrix(host, spec, context);
  };

  const frontIn = (rows) => frontOf(rows, 'wall_ns_min', 'error');
  const pointOf = (run) => ({ x: run.wall_ns_min, y: run.error, run });
  const fronts = {
    all: { colour: 'var(--ink)', text: 'Pareto front: no method is both faster and more accurate' },
    peers: { colour: 'var(--dim)', dashed: true, text: 'the same of the peers alone' },
  };
  // Runs are points without a line.
  const legendOfSpeed = (libraries) => {
    const legend = legendOf([
      ...libraries.map((name) => ({
        name, colour: colourOf(name), shape: facts.libraryNames.indexOf(name) % 8,
      })),
      ...Object.values(fronts).map((front) => ({ ...front, name: front.text, bare: true })),
    ]);
    libraries.forEach((_, k) => legend.children[k].querySelector('.curve').remove());
    return legend;
  };
  const tell = (run) => [
    `${idOf(run)}${run.options ? ` (${run.options})` : ''}`,
    `${run.setting_kind === 'tol' ? 'tolerance' : 'step'} ${number(run.setting)}`,
    duration(run.wall_ns_min), `error ${number(run.error)}`,
    `${plural(run.rhs_evaluations, 'evaluation')} of f`,
  ];
  const pick = (c) => (run) => {
    location.hash = addressOf('compare', {
      case: c.id, x: 'time', add: '1',
      show: `${idOf(run)}:${run.setting_kind === 'tol' ? 'adaptive' : 'fixed'}`,
    });
  };

  // An error beyond ten times the initial state only says that a run diverged.
  const drawnOf = (c, rows) =>
    rows.filter(
      (row) =>
        row.repetitions > 0 && row.wall_ns_min > 0 && row.error > 0 && row.error <= 10 * c.scale,
    );
  // The ranges of all cases together: pictures side by side have the same axes.
  const sharedRanges = async (cases) => {
    const all = await rowsOf('precision'), times = [], errors = [];
    const [ids, ns, error, count] = ['case', 'wall_ns_min', 'error', 'repetitions'].map((name) =>
      all.column(name),
    );
    const largest = new Map(cases.map((c) => [c.id, 10 * c.scale]));
    for (let i = 0; i < all.length; ++i)
      if (count[i] > 0 && ns[i] > 0 && error[i] > 0 && error[i] <= largest.get(ids[i])) {
        times.push(ns[i]);
        errors.push(error[i]);
      }
    return { x: rangeOf(times, 1.4), y: rangeOf(errors, 3) };
  };
  const drawSpeed = (host, c, rows, height, shared) => {
    const best = frontIn(rows), peers = frontIn(rows.filter((row) => row.library !== 'odeum')),
      onFront = new Set(best);
    const clouds = d3
      .groups(rows, (row) => row.library)
      .sort(([a], [b]) => facts.libraryNames.indexOf(b) - facts.libraryNames.indexOf(a))
      .flatMap(([library, some]) =>
        d3
          .groups(some, (row) => onFront.has(row))
          .map(([front, part]) => ({
            name: library, colour: colourOf(library),
            shape: facts.libraryNames.indexOf(library) % 8, loose: true, faint: !front,
            points: part.map(pointOf),
          })),
      );
    // The floor's text stands below it.
    const up = shared ? shared.y : rangeOf(rows.map((row) => row.error), 3),
      floor = c.timed_floor,
      low =
        !shared && floor > up.low && floor < up.high
          ? Math.min(up.low, floor * (floor / up.high) ** 0.08)
          : up.low;
    plot(host, {
      height, nameless: true, description: `error against time of a solve, ${c.id}`,
      x: {
        ...(shared ? shared.x : rangeOf(rows.map((row) => row.wall_ns_min), 1.4)),
        label: 'time of a solve (minimum)',
        text: duration,
      },
      y: { ...up, low, label: 'largest error, absolute' },
      levels: floor > 0 ? [{ y: floor, text: "the truth's own error", shaded: true }] : [],
      curves: [
        ...clouds,
        ...[
          ['peers', peers], ['all', best],
        ].map(([name, points]) => ({
          ...fronts[name], name: '', stairs: true, bare: true, points: points.map(pointOf),
        })),
      ],
      tell,
      pick: pick(c),
    });
  };

  // A diagram of each case, or of the one whose page this is; its rows are loaded when it comes
  // into view.
  blocks.speed = (host, spec, context) => {
    checkKeys(spec, 'speed', []);
    const ids = new Set(facts.tableOf.get('precision')?.cases || []),
      cases = facts.cases.filter((c) => (context.caseId ? c.id === context.caseId : ids.has(c.id)));
    const figures = html('div', { class: context.caseId ? 'single' : 'speeds' }),
      height = context.caseId ? 460 : 340;
    host.append(
      ...(context.caseId
        ? [figures, legendOfSpeed(facts.libraryNames)]
        : [legendOfSpeed(facts.libraryNames), figures]),
    );
    const shared = context.caseId ? null : sharedRanges(cases);
    for (const c of cases) {
      const picture = html('div', { class: 'picture' });
      const caption = context.caseId
        ? null
        : html(
            'figcaption', {},
            html('a', { href: addressOf('case', { id: c.id, part: 'precision' }) }, c.id),
            ` ${c.title}, t = ${number(c.end, 6)}`,
          );
      figures.append(html('figure', { class: 'speed' }, caption, picture));
      whenSeen(picture, height, async () => {
        const rows = drawnOf(c, (await rowsOf('precision', c.id)).objects());
        if (rows.length) drawSpeed(picture, c, rows, height, await shared);
        else picture.replaceChildren(html('p', { class: 'missing' }, 'There is nothing to draw.'));
      });
    }
  };
})();
