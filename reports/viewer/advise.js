// SPDX-License-Identifier: BSD-3-Clause
// The figure of an advice (src/odeum/advise/page.cpp): error against time of the runs of the race,
// and a table of those that were timed.
'use strict';
(() => {
  const {
    html, plot, rangeOf, duration, number, plural, idOf, rowsOf, settingText, figureOf, pageFigures,
    colourOf, shapeOf, facts, toldApart, tableOf, wide,
  } = odeum;

  // The fastest of each library, so many at most.
  const drawnOf = (timed) => [
    ...new Map([...timed].reverse().map((row) => [row.library, row])).values(),
  ].sort((a, b) => a.wall_ns_min - b.wall_ns_min).slice(0, 8);
  const tell = (run) => [
    idOf(run), `${settingText(run)}: error ${number(run.error)}`,
    `${duration(run.guarded_ns)} of processor time, counted`,
    `${plural(run.rhs_evaluations, 'evaluation')}, ${plural(run.steps, 'step')}`,
  ];

  const timedTable = (timed) => [
    html('h2', {}, 'Timed side by side'),
    wide(
      'what was timed',
      tableOf(
        [
          'solver', 'setting', 'least time', 'median', 'of the fastest', 'error', 'evaluations',
          'steps',
        ].map((text) => ({ text })),
        timed.map((row) => ({
          cells: [
            { text: idOf(row) }, { text: settingText(row), value: row.setting },
            { text: duration(row.wall_ns_min), value: row.wall_ns_min },
            { text: duration(row.wall_ns_median), value: row.wall_ns_median },
            {
              text: number(row.wall_ns_min / timed[0].wall_ns_min),
              value: row.wall_ns_min / timed[0].wall_ns_min,
            },
            { text: number(row.error), value: row.error },
            ...[row.rhs_evaluations, row.steps].map((value) => ({
              text: value.toLocaleString('en'), value,
            })),
          ],
        })),
      ),
    ),
    html(
      'p', {}, html('a', { href: 'race.csv' }, 'race.csv'), ' has every run, ',
      html('a', { href: 'advice.json' }, 'advice.json'), ' the answer for programs.',
    ),
  ];

  pageFigures.advice = async (host, about) => {
    const rows = (await rowsOf('race')).objects(),
      solved = rows.filter((row) => row.error > 0 && row.guarded_ns > 0),
      timed = rows
        .filter((row) => row.repetitions > 0)
        .sort((a, b) => a.wall_ns_min - b.wall_ns_min);
    const x = rangeOf(solved.map((row) => row.guarded_ns), 1.5),
      errors = solved.map((row) => row.error),
      y = rangeOf([...errors, ...(about.error > 0 ? [about.error] : [])], 3);
    if (!x) return host.append(html('p', { class: 'missing' }, 'No run gave an error.'));
    const curves = drawnOf(timed).map((best) => {
      const own = solved.filter(
        (row) => idOf(row) === idOf(best) && row.setting_kind === best.setting_kind,
      );
      const points = own.map((run) => ({ x: run.guarded_ns, y: run.error, run }));
      return {
        name: idOf(best), colour: colourOf(best.library),
        shape: shapeOf(facts.solverOf.get(idOf(best))), dashed: best.setting_kind === 'step',
        points: d3.sort(points, (p) => p.x),
      };
    });
    const picture = figureOf(host, 'Error against time');
    host.lastChild.classList.add('across');
    plot(picture, {
      height: 420, description: 'error against time of the runs of the race',
      x: { ...x, label: 'time of a run that is counted', text: duration },
      y: { ...y, label: 'largest error at the stops' },
      cloud: solved.map((run) => ({ x: run.guarded_ns, y: run.error, run })),
      curves: toldApart(curves), tell,
      levels: [
        ...(about.error > 0 ? [{ y: about.error, text: `asked: ${number(about.error)}` }] : []),
        { y: about.floor, text: "the truth's own error", shaded: true },
      ],
    });
    host.lastChild.append(
      `${plural(solved.length, 'run')} of ${plural(new Set(solved.map(idOf)).size, 'solver')}; ` +
        'dots are those of solvers that have no curve.',
    );
    host.append(html('section', { class: 'across' }, ...timedTable(timed)));
    return null;
  };
})();
