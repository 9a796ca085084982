// SPDX-License-Identifier: BSD-3-Clause
// The table of the runs of one problem, and what else is said of them.
'use strict';
(() => {
  const { html, number, idOf, tableOf, settingText } = odeum;

  // What the judge says of a run that ended; a fixed step promises no error.
  const answerText = (run) => {
    const said = run.answer_reason ? `: ${run.answer_reason}` : '';
    if (run.answer === 'none') return '';
    if (run.answer === 'not_applicable') return run.answer_reason || 'no error was promised';
    return (
      run.answer +
      (said || (Number.isFinite(run.explained_error)
        ? `: tolerance, steps and amplification explain up to ${number(run.explained_error, 2)}`
        : ''))
    );
  };
  const runTable = (about, runs) => {
    const scene = about.kind === 'scene',
      count = (value) => ({ text: value.toLocaleString('en'), value }),
      size = (value) => ({ text: number(value, 4), value });
    return tableOf(
      [
        'solver', 'status', 'error', 'setting', 'steps', 'rejected', 'evaluations',
        ...(scene ? ['change of energy (J)'] : []), 'answer',
      ].map((text) => ({ text })),
      runs.map((run) => ({
        cells: [
          { text: idOf(run) },
          {
            text: run.status + (run.detail ? `: ${run.detail}` : ''),
            class: run.status === 'ok' ? undefined : 'reason',
          },
          size(run.error_max), { text: settingText(run) },
          ...[run.steps, run.rejected_steps, run.rhs_evaluations].map(count),
          ...(scene ? [size(run.energy_change)] : []), { text: answerText(run), class: 'reason' },
        ],
      })),
    );
  };
  // What else the runs show, a line each.
  const remarksOf = (runs) =>
    runs
      .filter((run) => run.remarks)
      .map((run) => html('p', { class: 'remark' }, `${idOf(run)}: ${run.remarks}.`));

  Object.assign(odeum, { runTable, remarksOf });
})();
