// SPDX-License-Identifier: BSD-3-Clause
// The panel of one run of a comparison: its numbers, its command, its solution.
'use strict';
(() => {
  const {
    idOf, number, html, addressOf, facts, statusText, duration, plural, orderText, commandOf,
    showSolution,
  } = odeum;

  const nameOfRun = (run) =>
    `${idOf(run)}:${run.mode}:${number(run.setting, 6)}`;

  const showRun = (panel, run, curve) => {
    const lines = [
      ['solver', html('a', { href: addressOf('methods', { solver: idOf(run) }) }, idOf(run))],
      ['problem', `${facts.caseOf.get(run.case).title} (${run.case})`],
      [
        'setting',
        run.mode === 'fixed' ? `step ${number(run.step, 6)}` : `tolerance ${number(run.setting)}`,
      ],
      ['status', statusText(run, facts.caseOf.get(run.case).scale)],
      [
        'error',
        number(run.error_max, 4) +
          (run.error_rms ? `, root mean square ${number(run.error_rms, 4)}` : ''),
      ],
      [
        'energy',
        Number.isFinite(run.energy_error) ? `relative error ${number(run.energy_error, 3)}` : '',
      ],
      [
        'cost',
        [
          run.timed
            ? `${duration(run.wall_ns_min)}, median ${duration(run.wall_ns_median)} of ` +
              `${run.repetitions}`
            : '',
          plural(run.rhs_evaluations, 'evaluation'),
          run.jacobian_evaluations ? plural(run.jacobian_evaluations, 'Jacobian') : '',
          plural(run.steps, 'step'),
        ]
          .filter(Boolean)
          .join(', '),
      ],
      [
        'counted',
        (run.timed
          ? `to t = ${number(facts.caseOf.get(run.case).end)}, in the study of speed`
          : 'in the study of orders') +
          ': each has an end and stops of its own, and so its own counts',
      ],
      ['order', curve ? orderText(curve.order) : ''],
    ];
    const command = commandOf(facts.caseOf.get(run.case), run);
    const solution = html('div', { class: 'solution' });
    panel.replaceChildren(
      html('h3', {}, 'This run'),
      html(
        'dl', { class: 'facts' },
        lines
          .filter(([, value]) => value)
          .map(([name, value]) => [html('dt', {}, name), html('dd', {}, value)]),
      ),
      html(
        'p', { class: 'command' }, html('code', {}, command), ' ',
        html(
          'button',
          {
            type: 'button',
            onclick: (event) =>
              navigator.clipboard?.writeText(command).then(() => {
                event.target.textContent = 'copied';
              }),
          },
          'copy',
        ),
      ),
      solution,
    );
    panel.hidden = false;
    return showSolution(solution, facts.caseOf.get(run.case), run);
  };

  Object.assign(odeum, { nameOfRun, showRun });
})();
