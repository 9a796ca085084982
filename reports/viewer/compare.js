// SPDX-License-Identifier: BSD-3-Clause
// Any solvers side by side. The choice: case, also (a second case), x, y, show (keys, separated by
// commas), run (the one whose solution is shown).
'use strict';
(() => {
  const {
    html, save, csv, wide, number, notDrawnText, plural, rangeOf, plot, vertical, horizontal,
    duration, tellRun, facts, runsOf, most, sensible, measuredCases, loadCase, writeAddress,
    showAgain, toldApart, curveOf, select, choices, colourOf, front, finder, readAddress, nameOfRun,
    showRun, statusText, missingNote,
  } = odeum;

  // curves

  // The numbers behind the chart, as a table and as a file.
  const columnsOfTable = [
    'case', 'library', 'solver', 'mode', 'setting', 'x', 'y', 'rhs_evaluations', 'steps', 'status',
    'detail',
  ];
  // What stands beside a status: of a success that diverged, or whose answer is wrong, that it is.
  const detailOf = (run) =>
    statusText(run, facts.caseOf.get(run.case).scale).replace(/^[a-z_]+(: |, but )?/, '');
  const tableRows = (curves) =>
    curves.flatMap((curve) =>
      curve.points.map((p) => [
        p.run.case, p.run.library, p.run.solver, p.run.mode, p.run.setting, p.x, p.y,
        p.run.rhs_evaluations, p.run.steps, p.run.status, detailOf(p.run),
      ]),
    );
  const numbersBehind = (curves, choice) =>
    html(
      'details', {}, html('summary', {}, 'The numbers'),
      html(
        'p', {},
        html(
          'button',
          {
            type: 'button', class: 'download',
            onclick: () =>
              save(
                `${choice.case}_${choice.y}_${choice.x}.csv`,
                csv(columnsOfTable, tableRows(curves)),
              ),
          },
          'download as CSV',
        ),
      ),
      wide(
        'the numbers',
        html(
          'table', { class: 'numbers', 'data-numbers': 'compare' },
          html(
            'thead', {},
            html('tr', {}, columnsOfTable.map((name) => html('th', {}, name))),
          ),
          html(
            'tbody', {},
            tableRows(curves).map((row) =>
              html(
                'tr', {},
                row.map((cell) => html('td', {}, typeof cell === 'number' ? number(cell, 8) : cell),
                ),
              ),
            ),
          ),
        ),
      ),
    );

  const notDrawn = (curves) => {
    const list = curves
      .map((curve) => [curve, notDrawnText(curve.runs)])
      .filter(([curve, text]) => text || !curve.runs.length);
    return list.length
      ? html(
          'details', { class: 'not-drawn', open: list.some(([curve]) => !curve.points.length) },
          html('summary', {}, `Runs that gave no error, and why (${plural(list.length, 'curve')})`),
          html(
            'ul', {},
            list.map(([curve, text]) =>
              html('li', {}, html('b', {}, curve.name), `: ${text || 'not tried in this report'}`),
            ),
          ),
        )
      : null;
  };

  const drawComparison = (host, cases, curves, choice, pick) => {
    const points = curves.flatMap((curve) => curve.points);
    const x = rangeOf(
        points.map((p) => p.x), 1.3,
      ),
      y = rangeOf(points.map((p) => p.y), 3);
    if (!x)
      return host.replaceChildren(
        html(
          'p', { class: 'missing' },
          choice.x === 'time' && cases.every(({ data }) => !data.timed.length)
            ? 'This problem was not timed in this report: choose evaluations, or run odeum ' +
                'precision into its folder.'
            : 'No run of these solvers gave this number.',
        ),
      );
    const orders =
      choice.x === 'step' && choice.y !== 'energy'
        ? [...new Set(curves.map((curve) => Math.round(curve.order?.claimed_order)))]
            .filter((p) => p > 0)
            .sort((a, b) => a - b)
        : [];
    const floor = choice.x === 'time' ? cases[0].c.timed_floor : cases[0].c.floor;
    return plot(host, {
      height: Math.max(380, Math.min(560, Math.round(window.innerHeight * 0.62))),
      description:
        `${vertical[choice.y][0]} against ${horizontal[choice.x][0]} of ` +
        `${plural(curves.length, 'curve')}; the numbers are in the table below`,
      x: {
        ...x,
        label:
          horizontal[choice.x][0] +
          (choice.x === 'step' && cases[0].c.unit ? `, ${cases[0].c.unit}` : ''),
        text: choice.x === 'time' ? duration : undefined,
      },
      y: { ...y, label: vertical[choice.y][0] },
      curves,
      slopes: orders,
      levels:
        choice.y === 'energy' ? [] : [{ y: floor, text: "the truth's own error", shaded: true }],
      tell: tellRun,
      pick,
    });
  };

  const compareFilter = { text: '', library: '', family: '', order: '' };
  const compareChoice = (given, data) => {
    const choice = {
      case: facts.caseOf.has(given.case) ? given.case : '',
      also: facts.caseOf.has(given.also) ? given.also : '', x: horizontal[given.x] ? given.x : '',
      y: vertical[given.y] ? given.y : 'error', run: given.run || '',
    };
    choice.x = choice.x || (data.timed.length ? 'time' : 'evaluations');
    // A name without a mode: to a tolerance where it runs so, but at fixed steps across steps.
    const known = runsOf(data, choice.x);
    const whole = (key) =>
      key.includes(':')
        ? key
        : `${key}:${known.has(`${key}:adaptive`) && choice.x !== 'step' ? 'adaptive' : 'fixed'}`;
    const named = (given.show || '').split(',').filter(Boolean).map(whole).slice(0, most);
    choice.show =
      given.show === undefined || given.add
        ? [...new Set([...sensible(choice.case, data), ...named])]
        : named;
    return choice;
  };

  const showCompare = async (host, given) => {
    const measured = measuredCases();
    if (!measured.length)
      return host.replaceChildren(
        html('p', { class: 'missing' }, 'No case was measured in this report.'),
      );
    const id = measured.some((c) => c.id === given.case)
      ? given.case
      : (
          facts.questions.find((q) => measured.some((c) => c.id === q.case)) || {
            case: measured[0].id,
          }
        ).case;
    const c = facts.caseOf.get(id), data = await loadCase(id),
      choice = compareChoice({ ...given, case: id }, data);
    const cases = [{ c, data, more: '' }];
    if (choice.also && choice.also !== id) {
      const other = facts.caseOf.get(choice.also);
      cases[0].more = ` on ${id}`;
      cases.push({ c: other, data: await loadCase(other.id), more: ` on ${other.id}` });
    }
    const turn = (change) => {
      const next = { ...choice, run: '', ...change },
        written = {
          ...next, show: next.show ? next.show.join(',') : undefined,
          y: next.y === 'error' ? '' : next.y,
        };
      writeAddress('compare', written);
      return showAgain(host, () => showCompare(host, written));
    };
    const curves = toldApart(
      cases.flatMap((each, i) =>
        choice.show.map((key) => ({
          ...curveOf(each.c, each.data, key, choice.x, choice.y, each.more),
          ...(i ? { dashed: true } : {}),
        })),
      ),
    );
    const chart = html('div', { class: 'picture' }),
      panel = html('div', { class: 'run-panel', hidden: true, 'aria-live': 'polite' });
    const titled = measured.map((m) => [m.id, `${m.title} (${m.id})`]);
    host.replaceChildren(
      ...(given.case && given.case !== id ? [missingNote('measured case', given.case, id)] : []),
      html(
        'div', { class: 'controls' },
        select('problem', titled, id, (value) =>
          turn({ case: value, show: given.show === undefined ? undefined : choice.show }),
        ),
        select(
          'and', [['', '–'], ...titled.filter(([other]) => other !== id)], choice.also,
          (also) => turn({ also }),
        ),
        html(
          'span', {}, 'across ',
          choices(
            'across', Object.entries(horizontal).map(([key, [text]]) => [key, key, text]), choice.x,
            (x) => turn({ x }),
          ),
        ),
        html(
          'span', {}, 'up ',
          choices(
            'up', Object.entries(vertical).map(([key, [text]]) => [key, key, text]), choice.y,
            (y) => turn({ y }),
          ),
        ),
      ),
      html(
        'div', { class: 'chips', role: 'group', 'aria-label': 'shown' },
        choice.show.map((key) =>
          html(
            'button',
            {
              type: 'button', class: 'chip-button', style: { '--lib': colourOf(key.split('/')[0]) },
              title: 'remove', 'aria-label': `remove ${key}`,
              onclick: () => turn({ show: choice.show.filter((k) => k !== key) }),
            },
            key.replace(':adaptive', '').replace(':fixed', ' (fixed)'),
            ' ×',
          ),
        ),
        html(
          'button', { type: 'button', onclick: () => turn({ show: sensible(id, data) }) },
          "each library's best",
        ),
        html(
          'button', { type: 'button', onclick: () => turn({ show: front(data).slice(0, most) }) },
          'Pareto front',
        ),
        choice.show.length
          ? html('button', { type: 'button', onclick: () => turn({ show: [] }) }, 'none')
          : null,
      ),
      finder(compareFilter, [...runsOf(data, choice.x).keys()], choice.show, (show) =>
        turn({ show }),
      ),
      chart,
      panel,
      notDrawn(curves) || '',
      numbersBehind(curves, choice),
    );
    const pick = (run, curve) => {
      const { view, choice: now } = readAddress();
      if (view === 'compare') writeAddress('compare', { ...now, run: nameOfRun(run) });
      return showRun(panel, run, curve);
    };
    drawComparison(chart, cases, curves, choice, pick);
    for (const curve of choice.run ? curves : [])
      for (const { run } of curve.points)
        if (nameOfRun(run) === choice.run) return showRun(panel, run, curve);
    return null;
  };

  Object.assign(odeum, { showCompare });
})();
