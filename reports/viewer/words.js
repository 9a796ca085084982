// SPDX-License-Identifier: BSD-3-Clause
// The rules by which measured facts become sentences: all of them are here.
'use strict';
(() => {
  const { html, number, shorten, duration, plural, idOf, times, functions, facts } = odeum;

  const sameError = (a, b) => Math.abs(Math.log10(a / b)) < 0.01;
  const settingText = (row) =>
    row.setting_kind === 'tol' || row.mode === 'adaptive'
      ? `tolerance ${number(row.setting ?? row.tolerance)}`
      : `step ${number(row.setting ?? row.step)}`;

  // Above a view whose address names what the report does not have.
  const missingNote = (kind, asked, shown) =>
    html(
      'p', { class: 'missing', role: 'alert' },
      `This report has no ${kind} ${asked}${shown ? `; shown is ${shown}` : ''}.`,
    );

  // What a status means to a reader.
  const endings = {
    over_budget: 'costs more than the study pays for',
    newton_failed: "fails: Newton's iteration does not converge",
    non_finite: 'ends in values that are not finite',
    step_too_small: 'chooses a step that becomes too small', refused: 'refuses the run',
    not_applicable: 'does not fit',
  };
  // How a run ended; a success whose answer is wrong, or off by more than the solution's `size`, is
  // not one alone.
  const statusText = (run, size) => {
    const text = `${run.status}${run.detail ? `: ${run.detail}` : ''}`;
    if (run.status !== 'ok') return text;
    if (run.answer === 'wrong') return `${text}, but a wrong answer: ${run.answer_reason}`;
    return (run.error_max ?? run.error) > size
      ? `${text}, but diverged: its error exceeds the solution's size, ${number(size)}`
      : text;
  };
  const mostOf = (rows, key) => {
    const counts = new Map();
    for (const row of rows) counts.set(key(row), (counts.get(key(row)) || 0) + 1);
    return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
  };

  // Why no run of a library reaches an error: what it reaches, and how the rest ended. `tried`:
  // whether that says something about the library, and not about the report.
  const whyNotReached = (rows, error) => {
    if (!rows.length) return { text: 'not tried', tried: false };
    const fitting = rows.filter((row) => row.status !== 'not_applicable');
    if (!fitting.length)
      return { text: `does not fit: ${mostOf(rows, (row) => row.detail)}`, tried: false };
    const solved = fitting.filter((row) => Number.isFinite(row.error));
    // The reason that counts is that of the solver which came nearest.
    const best = solved.length ? solved.reduce((a, b) => (b.error < a.error ? b : a)) : null;
    const ended = fitting.filter(
      (row) => row.status !== 'ok' && (!best || row.solver === best.solver),
    );
    const rest = ended.length ? mostOf(ended, (row) => row.status) : '';
    const first = ended.find((row) => row.status === rest),
      detail = first ? `${endings[rest] || rest} (${shorten(first.detail, 80)})` : '';
    if (!best) return { text: `no run ended: ${detail}`, tried: rest !== 'over_budget' };
    const then = detail ? `; at a finer setting it ${detail}` : '; no finer setting was tried';
    return {
      text:
        `reaches ${number(best.error, 2)} at best (${best.solver})` +
        (best.error <= error ? ', not timed' : then),
      tried: Boolean(rest) && rest !== 'over_budget',
    };
  };

  // What a timed run did, by its own counts: no reason follows from a family, an order or a tag.
  const workText = (run) => {
    const counts = [
      run.steps ? plural(run.steps, 'step') : '',
      run.rejected_steps ? `${run.rejected_steps.toLocaleString('en')} rejected` : '',
      run.rhs_evaluations ? `${plural(run.rhs_evaluations, 'evaluation')} of f` : '',
      run.jacobian_evaluations ? plural(run.jacobian_evaluations, 'Jacobian') : '',
    ];
    const each = run.rhs_evaluations
      ? `; ${duration(run.wall_ns_min / run.rhs_evaluations)} for each evaluation, all else ` +
        `included`
      : '';
    return (
      `${settingText(run)}, error ${number(run.error)}` +
      (run.near_error ? `, at most ${number(run.near_error)} at the next settings` : '') + ': ' +
      `${counts.filter(Boolean).join(', ') || 'it counts nothing'}${each}.`
    );
  };

  // The command that makes a run of the study of speed or of orders again, with its stops.
  const commandOf = (c, run) => {
    const timed = Boolean(run.setting_kind), kind = run.setting_kind || run.mode;
    const steps = timed ? Math.round((c.end - c.start) / run.setting) : run.steps,
      setting =
        kind === 'step' || kind === 'fixed'
          ? `--steps ${steps}`
          : `--tol ${run.setting.toExponential()}`,
      options = run.options ? ` --option ${run.options}` : '';
    return (
      `odeum run ${c.words} --solver ${idOf(run)} ${setting}${options} ` +
      `--stops ${timed ? 'speed' : 'orders'}`
    );
  };

  // The lead of the best of one library over the best of another.
  const leadOf = (best, second) => {
    const ratio = second.wall_ns_min / best.wall_ns_min,
      other = `${idOf(second)} (${duration(second.wall_ns_min)})`;
    return ratio < 1.1
      ? `level with ${other}, to within what times on this machine tell.`
      : `${times(ratio)} times as fast as the best of another library, ${other}.`;
  };

  // What three digits more cost.
  const moreText = (now, more) => {
    const ratio = more.wall_ns_min / now.wall_ns_min, same = idOf(more) === idOf(now);
    if (same && more.setting === now.setting) return 'none: the same run has them.';
    return (
      (ratio < 1.05 ? 'no more time' : `${times(ratio)} times the time`) +
      `, with ${same ? 'the same method' : idOf(more)}.`
    );
  };

  // Which step a solver is stable to on a case, by the limits that were measured, and how long the
  // steps of a run are; `limit` is h |lambda| (regions.js).
  const stableText = (c, limit, z, run) => {
    if (!limit) return '';
    const size = Math.hypot(z[0], z[1]);
    const eigenvalue =
      `eigenvalue ${number(z[0], 2)}${z[1] ? ` ± ${number(z[1], 2)}i` : ''} at ` +
      `t = ${number(c.eigenvalues_time)}`;
    if (!Number.isFinite(limit.value)) return `at any step (${eigenvalue}).`;
    if (limit.value === 0)
      return `at no step, strictly (${eigenvalue}): errors grow, slowly at small steps.`;
    const far = limit.beyond ? ', as far as the region was measured' : '';
    const unit = c.unit ? ` ${c.unit}` : '', mean = run ? (c.end - c.start) / run.steps : NaN;
    const taken = Number.isFinite(mean)
      ? ` The run's steps are ${number(mean)}${unit} on average, ` +
        `${number((mean * size) / limit.value, 2)} of that.`
      : '';
    return (
      `to h = ${number(limit.value / size)}${unit}${far}, which is ` +
      `${number(limit.value)} / |λ| (${eigenvalue}).${taken}`
    );
  };

  // Times of a case that were disturbed, by the limits that the study has for a repetition.
  const disturbedText = (timed) => {
    const known = (t) => Number.isFinite(t.drift) || Number.isFinite(t.processor_share);
    const row = timed.find((t) => t.repetitions > 0 && known(t));
    if (!row || !functions.disturbed(row.drift, row.processor_share)) return '';
    const percent = (part) =>
      Number.isFinite(part) ? `${Math.round(100 * part)} %` : 'an unknown part';
    const speed = `speed changed by ${percent(Math.abs(row.drift))}`;
    const found = functions.disturbed(0, row.processor_share)
      ? `while other programs ran: the timed runs had the processor for ` +
        `${percent(row.processor_share)} of the time, and its ${speed}`
      : `on a processor whose ${speed} meanwhile`;
    return `Measured ${found}. Measure again on a quiet machine before you rely on ratios near 1.`;
  };

  // Runs of a curve that are not drawn, by how they ended.
  const notDrawnText = (rows) => {
    const ended = rows.filter((row) => row.status !== 'ok');
    if (!ended.length) return '';
    const classes = new Map();
    for (const row of ended) classes.set(row.status, [...(classes.get(row.status) || []), row]);
    const textOf = ([status, list]) =>
      (status === 'not_applicable' ? '' : `${list.length} of ${rows.length} settings: `) +
      `${endings[status] || status} (${list[0].detail || status})`;
    return [...classes].map(textOf).join('; ');
  };

  // Why the curves of a run are not in the report.
  const notKeptText = (c, run) =>
    !facts.solutions[c.id]
      ? 'This report keeps no solutions of this problem: the command, with --out, draws this one.'
      : run.status === 'ok'
        ? 'A longer run, which lies on the exact solution: the command, with --out, draws it ' +
          'and its error.'
        : 'This run gave no states to draw.';
  // What the curves of a run show.
  const solutionText = ({ set, states, times, errors }, run) => {
    const last = times.length - 1, known = errors.filter(Number.isFinite),
      worst = known.length ? Math.max(...known) : NaN;
    const where = times[errors.indexOf(worst) + 1], whole = times[last] >= set.end * (1 - 1e-9);
    const size = Math.max(...set.high.map((high, i) => high - set.low[i]));
    const how = !known.length
      ? 'The exact solution is not known at these times'
      : worst > 0.5 * size
        ? `Wrong: off by ${number(worst, 2)} at t = ${number(where)}, as much as the solution ` +
          `itself moves`
        : worst > 2e-3 * size
          ? `Visibly off: by at most ${number(worst, 2)}, at t = ${number(where)}`
          : `On the exact solution to the eye: off by at most ${number(worst, 2)}, at t = ` +
            `${number(where)}`;
    const end = whole
      ? ''
      : ` The run ends at t = ${number(times[last])}: ${run.detail || run.status}.`;
    const drawn =
      run.mode === 'adaptive' && run.library !== 'odeum'
        ? ' Drawn with output at 100 times, where a library may end its steps: its error ' +
          'differs a ' +
          'little from that of the run in the chart.'
        : '';
    const marks = set.exact.everywhere ? '' : ', known at the marks only';
    return `${how}.${end}${drawn} Exact: ${set.exact.source}${marks}.`;
  };

  // How the runs of a method on a problem ended where they did not, by class, with what it would
  // take.
  const failureText = (runs) => {
    const ended = runs.filter((run) => run.status !== 'ok');
    if (!ended.length) return 'every run ended';
    if (ended[0].status === 'not_applicable' && ended.length === runs.length)
      return `does not fit: ${ended[0].detail}`;
    const setting = (run) =>
      run.mode === 'fixed' || run.setting_kind === 'step'
        ? `h = ${number(run.setting)}`
        : `tolerance ${number(run.setting)}`;
    const size = (run) =>
      run.mode === 'fixed' || run.setting_kind === 'step' ? run.setting : NaN;
    const texts = [];
    for (const status of [...new Set(ended.map((run) => run.status))].filter(
      (s) => s !== 'not_applicable',
    )) {
      const list = ended.filter((run) => run.status === status),
        fixed = list.filter((run) => size(run) > 0);
      const least = fixed.reduce((a, b) => (!a || size(b) < size(a) ? b : a), null),
        most = fixed.reduce((a, b) => (!a || size(b) > size(a) ? b : a), null);
      const good =
        least && runs
          .filter((run) => run.status === 'ok' && size(run) < size(least))
          .reduce((a, b) => (!a || size(b) > size(a) ? b : a), null);
      if (status === 'non_finite' && least)
        texts.push(
          good
            ? `not finite from ${setting(least)}, finite at ${setting(good)}`
            : `not finite at every step that was run to its end, down to ${setting(least)}`,
        );
      else if (status === 'over_budget')
        texts.push(`over budget from ${setting(most || list[0])}: ${shorten(list[0].detail, 110)}`);
      else
        texts.push(
          `${endings[status] || status} at ${setting(least || list[0])}: ` +
            `${shorten(list[0].detail, 110)}`,
        );
    }
    return texts.join('; ');
  };

  Object.assign(odeum, {
    sameError, settingText, statusText, missingNote, commandOf, whyNotReached, workText, leadOf,
    moreText, stableText, disturbedText, notDrawnText, notKeptText, solutionText, failureText,
  });
})();
